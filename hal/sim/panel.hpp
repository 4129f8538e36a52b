// SPDX-License-Identifier: MIT
//
// A simulated panel: memory, palette, and a beam that fetches lines in virtual time.
//
// Rule: line i of refresh k is fetched i line times after the refresh began, from the buffer on display at
// that moment, with the palette in effect at that moment. VBLANK begins when the line after the last would be
// due; then a request of `show` takes effect, buffer and palette together. A write panel is scanned out of
// its own memory in the same way; writes change it at once. Line time is rounded to whole nanoseconds, so
// a refresh is off by up to half a nanosecond a line (4 parts in 10^6 with 240 lines), unless the scenario
// has `te`: then it is the refresh that is rounded. Refresh k begins at k frame times. 0 mHz are taken for 1.
//
// A panel is ideal but for the effects that its scenario declares (effects/effects.hpp).
#pragma once

#include <hal/panel.hpp>
#include <hal/sim/catalog.hpp>
#include <hal/sim/effects/bus.hpp>
#include <hal/sim/effects/te.hpp>
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
  /// A panel that starts its first refresh now. The clock outlives it. Of the effects it takes those of time;
  /// those of the glass are `Glass`.
  Panel(PanelSpec spec, VirtualClock& clock, const Effects& effects = {});
  ~Panel() override;

  [[nodiscard]] const PanelSpec& spec() const { return spec_; }
  [[nodiscard]] Nanoseconds line_time() const {
    return nominal_frame_time_ / static_cast<Nanoseconds>(spec_.total_lines);
  }
  /// Of a refresh without drift.
  [[nodiscard]] Nanoseconds frame_time() const { return nominal_frame_time_; }

  /// Adds an observer; it must be detached before it dies, or outlive the panel. It is told what is on
  /// display, and sees lines from the next on.
  void attach(Observer& observer);
  void detach(Observer& observer);

  /// What a refresh would show if all of it were scanned out now. The low bits of each colour that the device
  /// doesn't keep (`palette_bits`) read as zero.
  [[nodiscard]] Picture displayed() const;

  /// A component (0 red, 1 green, 2 blue) of the colour that an index shows by a palette; black beyond it.
  [[nodiscard]] std::uint8_t colour(std::span<const std::uint8_t> palette, std::size_t index,
                                    std::size_t channel) const;

  /// Says that what a write panel's memory holds now is a whole frame: observers are told of it.
  void mark_frame();

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
  bool do_show_replaced() noexcept override { return replaced_; }
  int do_on_display() noexcept override { return displayed_; }
  Status do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept override;
  Status do_load_palette(std::span<const std::uint8_t> palette) noexcept override;
  std::uint32_t do_vblank_count() noexcept override;
  Status do_wait_for_vblank() noexcept override;

  void before_time_moves(Nanoseconds time) override;
  /// When the beam begins line `line` of the refresh in work.
  [[nodiscard]] Nanoseconds time_of(int line) const {
    return refresh_start_ +
           frame_time_ * static_cast<Nanoseconds>(line) / static_cast<Nanoseconds>(spec_.total_lines);
  }
  void set_times();
  void begin_refresh(Nanoseconds time);
  [[nodiscard]] std::span<const std::uint8_t> row(int y) const;
  /// The palette that a line is looked up in: none, where the beam fetches colours.
  [[nodiscard]] std::span<const std::uint8_t> palette_in_effect(std::span<const std::uint8_t> palette) const {
    return colours_.empty() ? palette : std::span<const std::uint8_t>();
  }
  /// What the beam fetches, and the distance of its rows.
  [[nodiscard]] std::span<const std::uint8_t> memory(int buffer) const;
  [[nodiscard]] int memory_stride() const {
    return colours_.empty() ? stride_ : 3 * spec_.capabilities.width;
  }
  void scan_line();
  void begin_vblank();
  void take_effect(Nanoseconds time);
  void tell_presented(int buffer, std::uint32_t frame, std::span<const std::uint8_t> palette) const;
  void tell_transfer(const Transfer& transfer) const;

  PanelSpec spec_;
  VirtualClock* clock_;
  std::optional<Bus> bus_;
  std::optional<TeLine> te_;
  std::optional<RefreshDrift> drift_;
  PaletteLatch palette_latch_ = PaletteLatch::at_vblank;
  Nanoseconds nominal_frame_time_ = 0;
  Nanoseconds frame_time_ = 0;  // Of the refresh in work.
  Nanoseconds refresh_start_ = 0;
  Nanoseconds last_te_ = 0;  // The edge that tells of the latest VBLANK.
  int lines_ = 0;            // As the beam counts them.
  int stride_ = 0;
  std::vector<std::vector<std::uint8_t>> buffers_;  // A write panel's own memory is buffer 0.
  std::vector<std::uint8_t> palette_;
  std::vector<std::uint8_t> colours_;  // Of pixels as they were written, where `palette_on_write`.
  int displayed_ = 0;
  std::uint32_t displayed_frame_ = 0;
  std::uint32_t presented_ = 0;
  std::optional<Request> pending_;
  bool replaced_ = false;      // The last request replaced one that waited.
  std::uint64_t refresh_ = 0;  // The refresh whose VBLANK comes next: VBLANKs so far.
  int line_ = 0;               // Its line that comes next.
  std::vector<std::uint8_t> column_;
  std::vector<Observer*> observers_;
};

}  // namespace hal::sim
