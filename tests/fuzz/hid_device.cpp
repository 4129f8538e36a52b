// SPDX-License-Identifier: MIT
//
// The device side of the USB HID protocol takes any reports: it touches no memory but its own, displays
// nothing that wasn't committed with the right checksum, and an honest host that comes after whatever it was
// shows its frame.
#include <hal/hid/crc32.hpp>
#include <hal/hid/device/device.hpp>
#include <hal/sim/panel.hpp>
#include <tests/fuzz/input.hpp>

#include <algorithm>
#include <vector>

namespace fuzz {

namespace {

using namespace hal::hid;
using Bytes = std::vector<std::uint8_t>;

/// A host that knows the protocol, and at times keeps to it.
class Host {
 public:
  Host(Device& device, hal::sim::Panel& glass, hal::sim::VirtualClock& clock)
      : device_(&device), glass_(&glass), clock_(&clock) {}

  void hello(std::uint32_t nonce) {
    nonce_ = nonce | 1U;
    sequence_ = 0;
    give(ReportType::hello, encode(Hello{nonce_, true}));
  }
  /// A report of the session, with the next number.
  void give(ReportType type, std::span<const std::uint8_t> payload) {
    Bytes report(device_->report_bytes());
    const bool counted = type == ReportType::palette || type == ReportType::rectangle ||
                         type == ReportType::pixels || type == ReportType::commit;
    compose(report, {type, static_cast<std::uint8_t>(nonce_ & 0xFFU), counted ? sequence_ : std::uint16_t{0},
                     payload});
    if (counted) sequence_ = static_cast<std::uint16_t>((sequence_ + 1U) & 0xFFFFU);
    give(report);
  }
  void give(std::span<const std::uint8_t> report) {
    const std::uint32_t committed = device_->counters().committed;
    const bool waited = !device_->ready();
    const hal::sim::Picture before = glass_->displayed();
    device_->receive(report);
    device_->poll();
    if (committed == device_->counters().committed && !waited)
      require(glass_->displayed() == before, "the display changed without a commit");
  }
  /// Lets the device say all that it has to say.
  void listen() {
    Bytes report(device_->report_bytes());
    int said = 0;
    while (device_->next(report) != 0) {
      require(parse(report).has_value(), "a report of the device is malformed");
      require(++said < 8, "the device never stops talking");
    }
  }
  void pass() {
    clock_->advance(glass_->frame_time());
    device_->poll();
  }
  /// A session with one frame, which must appear.
  void be_honest(std::uint8_t value) {
    for (int i = 0; i < 3; ++i) pass();
    require(device_->ready(), "the device waits for ever");
    hello(nonce_ + 2U);
    const hal::Capabilities& c = glass_->capabilities();
    Bytes palette(static_cast<std::size_t>(c.palette_entries) * 3U);
    const auto most = static_cast<std::size_t>(palette_entries_in(device_->report_bytes())) * 3U;
    for (std::size_t i = 0; i < palette.size(); i += most) {
      const std::size_t count = std::min(most, palette.size() - i);
      Bytes payload(1 + count);
      payload[0] = static_cast<std::uint8_t>(i / 3U);
      give(ReportType::palette, payload);
    }
    const Bytes picture(picture_bytes(c), value);
    const auto area = encode(hal::Rect{0, 0, c.width, c.height});
    Bytes payload(area.size() + 4);
    std::copy(area.begin(), area.end(), payload.begin());
    payload[area.size()] = 0xFE;
    payload[area.size() + 1] = static_cast<std::uint8_t>(picture.size() & 0xFFU);
    payload[area.size() + 2] = static_cast<std::uint8_t>(picture.size() >> 8U);
    payload[area.size() + 3] = value;
    give(ReportType::rectangle, payload);
    Crc32 crc;
    crc.add(palette);
    crc.add(picture);
    const std::uint32_t committed = device_->counters().committed;
    give(ReportType::commit, encode(Commit{7, crc.value()}));
    require(device_->counters().committed == committed + 1, "an honest frame was refused");
    for (int i = 0; i < 3; ++i) pass();
    require(device_->shown() == 7, "an honest frame didn't appear");
    const auto shown = glass_->displayed().indices;
    const unsigned mask = (1U << static_cast<unsigned>(c.bits_per_pixel)) - 1U;
    // Every index of the byte is the same only for values made of one index.
    if (c.bits_per_pixel == 8)
      require(std::all_of(shown.begin(), shown.end(), [&](std::uint8_t i) { return i == (value & mask); }),
              "an honest frame appeared as another");
  }

 private:
  Device* device_;
  hal::sim::Panel* glass_;
  hal::sim::VirtualClock* clock_;
  std::uint32_t nonce_ = 1;
  std::uint16_t sequence_ = 0;
};

}  // namespace

void run(Input in) {
  constexpr int depths[] = {1, 2, 4, 8};
  hal::sim::VirtualClock clock;
  hal::sim::PanelSpec spec =
      hal::sim::paletted(1 + in.choice(40), 1 + in.choice(20), depths[in.choice(4)], in.choice(4));
  if (spec.capabilities.buffers == 0) {
    spec.capabilities.x_alignment = 1 + in.choice(9);
    spec.capabilities.y_alignment = 1 + in.choice(9);
  }
  hal::sim::Panel glass(spec, clock);
  constexpr std::size_t guard = 32;
  const std::size_t needed = Device::memory_for(glass.capabilities());
  Bytes memory(needed + 2 * guard, 0xA5);
  Device device(glass, nullptr, std::span(memory).subspan(guard, needed),
                {.report_bytes = 64U + static_cast<std::size_t>(in.choice(64)), .window = 1 + in.choice(16)});
  require(device.status().ok(), "a good panel was refused");
  Host host(device, glass, clock);
  constexpr ReportType types[] = {ReportType::palette, ReportType::rectangle, ReportType::pixels,
                                  ReportType::commit, ReportType::ask_colours};
  for (int round = 0; round < 200 && !in.empty(); ++round) {
    const int what = in.choice(16);
    Bytes bytes(static_cast<std::size_t>(in.choice(64)));
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(in.byte());
    if (what < 9) {
      host.give(types[what % 5], bytes);
    } else if (what == 9) {
      host.hello(static_cast<std::uint32_t>(in.any()));
    } else if (what == 10) {
      host.listen();
    } else if (what == 11) {
      host.pass();
    } else if (what == 12) {
      device.unplugged();
    } else if (what == 13) {
      host.be_honest(static_cast<std::uint8_t>(in.byte()));
    } else {
      host.give(bytes);
    }
  }
  host.listen();
  host.be_honest(0x55);
  const auto intact = [&](std::size_t from) {
    return std::all_of(memory.begin() + static_cast<std::ptrdiff_t>(from),
                       memory.begin() + static_cast<std::ptrdiff_t>(from + guard),
                       [](std::uint8_t byte) { return byte == 0xA5; });
  };
  require(intact(0) && intact(guard + needed), "the device wrote outside its memory");
}

}  // namespace fuzz
