// SPDX-License-Identifier: MIT
//
// A simulated panel: memory, palette, and a beam that fetches lines in virtual time.
//
// Rule: line y of refresh k is fetched at k*frame_time + y*line_time from the buffer on display at that
// moment, with the palette in effect at that moment. VBLANK begins when the line after the last would be due;
// then a request of `show` takes effect, buffer and palette together. A write panel is scanned out of its own
// memory in the same way; writes change it at once. Line time is rounded to whole nanoseconds, so the refresh
// rate is met within one part in 10^4.
#pragma once

#include <hal/panel.hpp>
#include <hal/sim/catalog.hpp>
#include <hal/sim/observer.hpp>
#include <hal/sim/virtual_clock.hpp>

#include <optional>
#include <vector>

namespace hal::sim {

/// What a viewer sees: one byte a pixel, and three.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> indices;
  std::vector<std::uint8_t> rgb;
  friend bool operator==(const Picture&, const Picture&) = default;
};

class Panel final : public hal::Panel, private VirtualClock::Listener {
 public:
  /// A panel that starts its first refresh now. The clock outlives it.
  Panel(PanelSpec spec, VirtualClock& clock);
  ~Panel() override;

  [[nodiscard]] const PanelSpec& spec() const { return spec_; }
  [[nodiscard]] Nanoseconds line_time() const { return line_time_; }
  [[nodiscard]] Nanoseconds frame_time() const {
    return line_time_ * static_cast<Nanoseconds>(spec_.total_lines);
  }

  /// Adds an observer; it must be detached before it dies, or outlive the panel. It is told what is on
  /// display, and sees lines from the next on.
  void attach(Observer& observer);
  void detach(Observer& observer);

  /// What a refresh would show if all of it were scanned out now. The low bits of each colour that the device
  /// doesn't keep (`palette_bits`) read as zero.
  [[nodiscard]] Picture displayed() const;

 private:
  /// A request of `show`.
  struct Request {
    int buffer = 0;
    std::uint32_t frame = 0;
    std::vector<std::uint8_t> palette;
  };

  const Capabilities& do_capabilities() const noexcept override { return spec_.capabilities; }
  std::span<std::uint8_t> do_buffer(int index) noexcept override;
  int do_buffer_stride() const noexcept override { return stride_; }
  Status do_show(int index, std::span<const std::uint8_t> palette) noexcept override;
  bool do_show_pending() noexcept override { return pending_.has_value(); }
  int do_on_display() noexcept override { return displayed_; }
  Status do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept override;
  Status do_load_palette(std::span<const std::uint8_t> palette) noexcept override;
  std::uint32_t do_vblank_count() noexcept override { return static_cast<std::uint32_t>(refresh_); }
  Status do_wait_for_vblank() noexcept override;

  void before_time_moves(Nanoseconds time) override;
  [[nodiscard]] Nanoseconds refresh_start() const { return start_ + refresh_ * frame_time(); }
  [[nodiscard]] Nanoseconds vblank_time() const { return refresh_start() + height() * line_time_; }
  [[nodiscard]] Nanoseconds height() const { return static_cast<Nanoseconds>(spec_.capabilities.height); }
  [[nodiscard]] std::span<const std::uint8_t> row(int y) const;
  void scan_line();
  void begin_vblank();
  void take_effect();
  void tell_presented(int buffer, std::uint32_t frame, std::span<const std::uint8_t> palette) const;

  PanelSpec spec_;
  VirtualClock* clock_;
  Nanoseconds line_time_ = 0;
  Nanoseconds start_ = 0;
  int stride_ = 0;
  std::vector<std::vector<std::uint8_t>> buffers_;  // A write panel's own memory is buffer 0.
  std::vector<std::uint8_t> palette_;
  int displayed_ = 0;
  std::uint32_t displayed_frame_ = 0;
  std::uint32_t presented_ = 0;
  std::optional<Request> pending_;
  std::uint64_t refresh_ = 0;  // The refresh whose VBLANK comes next: VBLANKs so far.
  int line_ = 0;               // Its line that comes next.
  std::vector<Observer*> observers_;
};

}  // namespace hal::sim
