// SPDX-License-Identifier: MIT
//
// A write panel whose bus takes time and whose beam sees what is there, for tests of racing it.
#pragma once

#include <hal/panel.hpp>
#include <hal/sim/virtual_clock.hpp>
#include <hal/vblank.hpp>
#include <intaglio/present/beam_race.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace slow {

/// A panel of indices, and of the colour of index 0 as it was when they arrived, behind a bus that takes
/// time. A beam fetches a line's first half at the beginning of the line's time and its second at the end;
/// refreshes that saw two values are torn.
class SlowPanel final : public hal::Panel,
                        public hal::VblankSource,
                        private hal::sim::VirtualClock::Listener {
 public:
  SlowPanel(hal::sim::VirtualClock& clock, int width, int height, hal::ScanDirection scan,
            const intaglio::present::BeamTiming& timing)
      : glass(static_cast<std::size_t>(width * height)),
        clock_(&clock),
        timing_(timing),
        capabilities_{.width = width,
                      .height = height,
                      .palette_entries = 1,
                      .palette_on_write = true,
                      .buffers = 0,
                      .scan = scan} {
    clock.attach(*this);
  }
  ~SlowPanel() override { clock_->detach(*this); }

  std::vector<std::uint16_t> glass;  ///< Index, and 256 times the colour.
  std::uint64_t refreshes = 0;
  std::uint64_t torn = 0;
  std::uint64_t excused = 0;          ///< Torn refreshes that hold a part of a lost frame.
  std::array<bool, 256> lost{};       ///< Frames, by their index, that were broken off by a fault.
  std::vector<bool> silent;           ///< VBLANKs, modulo their number, that aren't told.
  hal::Nanoseconds signal_delay = 0;  ///< A signal comes so much late.
  hal::Nanoseconds extra_per_write = 0;
  int writes_until_fault = -1;

 private:
  int width() const { return capabilities_.width; }
  int height() const { return capabilities_.height; }
  bool sideways() const {
    return capabilities_.scan == hal::ScanDirection::left || capabilities_.scan == hal::ScanDirection::right;
  }
  int lines() const { return sideways() ? width() : height(); }
  std::uint16_t& pixel(int x, int y) { return glass[static_cast<std::size_t>(y * width() + x)]; }

  const hal::Capabilities& do_capabilities() const noexcept override { return capabilities_; }
  std::span<std::uint8_t> do_buffer(int) noexcept override { return {}; }
  int do_buffer_stride() const noexcept override { return 0; }
  hal::Status do_show(int, std::span<const std::uint8_t>) noexcept override { return {}; }
  bool do_show_pending() noexcept override { return false; }
  hal::Status do_load_palette(std::span<const std::uint8_t> palette) noexcept override {
    colour_ = palette[0];
    return {};
  }
  std::uint32_t do_vblank_count() noexcept override { return do_count(); }
  hal::Status do_wait_for_vblank() noexcept override { return do_wait(); }
  hal::Status do_write(const hal::Rect& r, std::span<const std::uint8_t> pixels,
                       int stride) noexcept override {
    if (writes_until_fault == 0) return {hal::Error::bus, hal::Part::bus};
    if (writes_until_fault > 0) --writes_until_fault;
    clock_->advance(timing_.bus_band + extra_per_write);
    const hal::Nanoseconds start = clock_->now();
    const hal::Nanoseconds all =
        timing_.bus_line * static_cast<hal::Nanoseconds>(sideways() ? r.width : r.height);
    for (int y = 0; y < r.height; ++y)
      for (int half = 0; half < 2; ++half) {
        for (int x = half * r.width / 2; x < (half + 1) * r.width / 2; ++x)
          pixel(r.x + x, r.y + y) =
              static_cast<std::uint16_t>(pixels[static_cast<std::size_t>(y * stride + x)] | colour_ << 8U);
        clock_->wait_until(start + all * static_cast<hal::Nanoseconds>(2 * y + half + 1) /
                                       static_cast<hal::Nanoseconds>(2 * r.height));
      }
    return {};
  }

  bool told(std::uint64_t vblank) const { return silent.empty() || !silent[vblank % silent.size()]; }
  /// The signals given until now; VBLANK n (from 1 on) begins at (n - 1) refreshes.
  std::uint32_t do_count() noexcept override {
    while (told_ * timing_.refresh + signal_delay <= clock_->now()) {
      if (told(told_)) {
        ++count_;
        last_ = told_ * timing_.refresh + signal_delay;
      }
      ++told_;
    }
    return count_;
  }
  hal::Status do_wait() noexcept override {
    const std::uint32_t before = do_count();
    while (do_count() == before) clock_->wait_until(told_ * timing_.refresh + signal_delay);
    return {};
  }
  hal::Nanoseconds do_last() noexcept override {
    do_count();
    return last_;
  }

  void before_time_moves(hal::Nanoseconds time) override {
    for (;;) {
      const hal::Nanoseconds line_begin = refreshes * timing_.refresh + timing_.first_line +
                                          static_cast<hal::Nanoseconds>(line_) * timing_.scan_line;
      // The end of a line is over just before the next begins.
      if ((half_ == 0 ? line_begin : line_begin + timing_.scan_line) > time) return;
      fetch();
    }
  }
  void fetch() {
    const bool back =
        capabilities_.scan == hal::ScanDirection::up || capabilities_.scan == hal::ScanDirection::left;
    const int line = back ? lines() - 1 - line_ : line_;
    const int length = sideways() ? height() : width();
    for (int i = half_ * length / 2; i < (half_ + 1) * length / 2; ++i) {
      const std::uint16_t value = sideways() ? pixel(line, i) : pixel(i, line);
      if (line_ == 0 && half_ == 0 && i == 0) value_ = value;
      mixed_ = mixed_ || value != value_;
      lost_ = lost_ || lost[value & 255U];
    }
    half_ = 1 - half_;
    if (half_ == 1 || ++line_ < lines()) return;
    line_ = 0;
    (lost_ ? excused : torn) += mixed_ ? 1U : 0U;
    mixed_ = false;
    lost_ = false;
    ++refreshes;
  }

  hal::sim::VirtualClock* clock_;
  intaglio::present::BeamTiming timing_;
  hal::Capabilities capabilities_;
  std::uint64_t told_ = 0;
  std::uint32_t count_ = 0;
  hal::Nanoseconds last_ = 0;
  int line_ = 0;
  int half_ = 0;
  std::uint16_t value_ = 0;
  std::uint8_t colour_ = 0;
  bool mixed_ = false;
  bool lost_ = false;
};

}  // namespace slow
