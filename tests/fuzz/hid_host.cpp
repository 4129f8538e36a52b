// SPDX-License-Identifier: MIT
//
// The host's side of the USB HID protocol with a device that says anything, at any time, or nothing: every
// call comes to an end, and what a device claims to be is kept within bounds.
#include <hal/hid/host/panel.hpp>
#include <hal/sim/virtual_clock.hpp>
#include <tests/fuzz/input.hpp>

#include <algorithm>
#include <vector>

namespace fuzz {

namespace {

using namespace hal::hid;
using Bytes = std::vector<std::uint8_t>;

/// A device made of the fuzzer's bytes. What it says fits the session more often than chance would have it.
class Liar final : public ReportPort {
 public:
  Liar(Input& in, hal::sim::VirtualClock& clock) : in_(&in), clock_(&clock) {}

 private:
  hal::Status do_send(std::span<const std::uint8_t> report) noexcept override {
    clock_->advance(10'000);
    require(report.size() >= least_report_bytes && report.size() <= most_report_bytes, "a report's length");
    const auto r = parse(report);
    require(r.has_value(), "a malformed report was sent");
    mark_ = r->session;
    if (r->type == ReportType::hello) {
      const auto hello = decode_hello(r->payload);
      require(hello.has_value(), "a malformed HELLO was sent");
      nonce_ = hello->nonce;
      next_ = 0;
    } else if (r->type == ReportType::commit) {
      frame_ = decode_commit(r->payload).value_or(Commit{}).frame;
    }
    if (static_cast<std::uint8_t>(r->type) >= 0x10 && r->sequence == next_)
      next_ = static_cast<std::uint16_t>((next_ + 1U) & 0xFFFFU);
    const int trouble = in_->choice(64);
    if (trouble == 1) return {hal::Error::bus, hal::Part::bus};
    if (trouble == 2) return {hal::Error::disconnected, hal::Part::panel};
    return {};
  }

  Received do_receive(std::span<std::uint8_t> out, hal::Nanoseconds patience) noexcept override {
    clock_->advance(10'000);
    const int what = in_->empty() ? 0 : in_->choice(16);
    Bytes report(least_report_bytes);
    if (what < 4) {
      clock_->advance(patience);
      return {{hal::Error::timeout, hal::Part::bus}, 0};
    }
    if (what == 4) return {{hal::Error::disconnected, hal::Part::panel}, 0};
    if (what < 7) {
      report.resize(static_cast<std::size_t>(in_->choice(80)));
      for (auto& byte : report) byte = static_cast<std::uint8_t>(in_->byte());
    } else if (what < 9) {
      DeviceInfo info;
      info.nonce = nonce_;
      info.window = static_cast<std::uint8_t>(1 + in_->choice(16));
      info.report_bytes = static_cast<std::uint16_t>(64 + in_->choice(128));
      info.capabilities.width = 1 + in_->choice(64);
      info.capabilities.height = 1 + in_->choice(32);
      info.capabilities.bits_per_pixel = 1 << in_->choice(4);
      info.capabilities.palette_entries = in_->choice(3);
      auto bytes = encode(info);
      if (in_->choice(4) == 0)
        bytes[static_cast<std::size_t>(in_->byte()) % bytes.size()] = static_cast<std::uint8_t>(in_->byte());
      compose(report, {ReportType::capabilities, mark_, 0, bytes});
    } else if (what < 10) {
      Bytes colours(58);
      colours[0] = static_cast<std::uint8_t>(in_->byte());
      compose(report, {ReportType::colours, mark_, 0,
                       std::span(colours).first(1U + 3U * static_cast<std::size_t>(in_->choice(20)))});
    } else {
      DeviceState state;
      state.decided = what < 14 ? frame_ : static_cast<std::uint16_t>(in_->any() & 0xFFFF);
      state.shown = in_->choice(2) == 0 ? frame_ : static_cast<std::uint16_t>(in_->byte());
      state.verdict = static_cast<Verdict>(in_->choice(8) == 0 ? in_->byte() : 0);
      const int flags = in_->byte();
      state.gap = (flags & 7) == 1;
      state.no_session = (flags & 0x38) == 0x38;
      state.vblanks = ++vblanks_;
      const auto next = what < 14 ? next_ : static_cast<std::uint16_t>(in_->any() & 0xFFFF);
      compose(report, {ReportType::status, mark_, next, encode(state)});
    }
    const std::size_t size = std::min(report.size(), out.size());
    std::copy_n(report.begin(), size, out.begin());
    return {{}, size};
  }
  hal::Status do_reopen() noexcept override {
    clock_->advance(10'000);
    return in_->choice(2) == 0 ? hal::Status{} : hal::Status{hal::Error::disconnected, hal::Part::panel};
  }

  Input* in_;
  hal::sim::VirtualClock* clock_;
  std::uint32_t nonce_ = 0;
  std::uint32_t vblanks_ = 0;
  std::uint8_t mark_ = 0;
  std::uint16_t next_ = 0;
  std::uint16_t frame_ = 0;
};

}  // namespace

void run(Input in) {
  hal::sim::VirtualClock clock;
  Liar liar(in, clock);
  Link link(liar, clock, {.retry = 10'000'000, .patience = 100'000'000});
  if (!link.open().ok()) return;
  const hal::Capabilities& c = link.info().capabilities;
  require(c.width >= 1 && c.width <= most_side && c.height >= 1 && c.height <= most_side,
          "a size out of bounds");
  require(c.palette_entries != 0 || c.fixed_palette.size() == std::size_t{3}
                                                                  << static_cast<unsigned>(c.bits_per_pixel),
          "a palette that isn't whole");
  // Larger ones are as good, but take their time.
  if (picture_bytes(c) > 1U << 16U) return;
  HidPanel panel(link, {.replug_patience = in.choice(2) == 0 ? 0U : 200'000'000U});
  HidInput input(link);
  for (int n = 0; n < 20 && !in.empty(); ++n) {
    const auto buffer = panel.buffer(n % 2);
    const int byte = in.byte();
    std::fill(buffer.begin(), buffer.end(), static_cast<std::uint8_t>(byte));
    if (!buffer.empty()) buffer[static_cast<std::size_t>(in.byte()) % buffer.size()] = 1;
    const hal::Nanoseconds begin = clock.now();
    panel.show(n % 2, {}).ignore();
    if (panel.show_pending()) panel.wait_for_vblank().ignore();
    static_cast<void>(input.poll());
    static_cast<void>(panel.vblank_count());
    require(clock.now() - begin < hal::Nanoseconds{3'600'000'000'000}, "a frame took an hour");
  }
}

}  // namespace fuzz
