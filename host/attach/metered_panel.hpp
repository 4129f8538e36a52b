// SPDX-License-Identifier: MIT
//
// Counts at which VBLANKs frames appear on a panel: what was late, left out or shown twice over.
//
// Rule: a frame appears at the VBLANK that its program was last told of before it sent the first pixel (write
// panels) or found its request fulfilled (scan-out panels). Frame n is due `interval` VBLANKs after frame
// n-1; a frame that was dropped for being late is passed over. What is sent behind the beam appears in the
// refresh that its chaser aimed it at, and VBLANKs are asked for when its first pixel is sent, so that those
// before belong to frames before.
#pragma once

#include <hal/panel.hpp>
#include <intaglio/present/beam_chaser.hpp>

#include <cstdint>
#include <string>

namespace host {

class MeteredPanel final : public hal::Panel {
 public:
  /// `chaser`: of the frames, if they are sent behind the beam.
  MeteredPanel(hal::Panel& panel, int interval, const intaglio::present::BeamChaser* chaser = nullptr)
      : panel_(&panel), chaser_(chaser), interval_(static_cast<std::uint32_t>(interval)) {}

  /// The program's frame is on display.
  void frame_shown();
  /// It isn't, being too late.
  void frame_dropped();

  [[nodiscard]] std::uint32_t frames() const { return frames_; }
  /// From the first frame to the last.
  [[nodiscard]] std::uint32_t vblanks() const { return frames_ == 0 ? 0 : last_ - first_; }
  /// Frames that came later than they were due, and the VBLANKs at which one was due that didn't come.
  [[nodiscard]] std::uint32_t late_frames() const { return late_; }
  [[nodiscard]] std::uint32_t skipped_vblanks() const { return skipped_; }
  /// Frames that appeared before they were due: the one before was seen too briefly, or never.
  [[nodiscard]] std::uint32_t early_frames() const { return early_; }
  [[nodiscard]] std::uint32_t dropped_frames() const { return dropped_; }
  /// All of it, lines "KEY VALUE".
  [[nodiscard]] std::string counters() const;

 private:
  const hal::Capabilities& do_capabilities() const noexcept override { return panel_->capabilities(); }
  std::span<std::uint8_t> do_buffer(int index) noexcept override { return panel_->buffer(index); }
  int do_buffer_stride() const noexcept override { return panel_->buffer_stride(); }
  hal::Status do_show(int index, std::span<const std::uint8_t> palette) noexcept override {
    return panel_->show(index, palette);
  }
  bool do_show_pending() noexcept override { return panel_->show_pending(); }
  bool do_show_replaced() noexcept override { return panel_->show_replaced(); }
  int do_on_display() noexcept override { return panel_->on_display(); }
  hal::Status do_write(const hal::Rect& area, std::span<const std::uint8_t> pixels,
                       int stride) noexcept override;
  hal::Status do_load_palette(std::span<const std::uint8_t> palette) noexcept override {
    return panel_->load_palette(palette);
  }
  std::uint32_t do_vblank_count() noexcept override;
  hal::Status do_wait_for_vblank() noexcept override { return panel_->wait_for_vblank(); }

  hal::Panel* panel_;
  const intaglio::present::BeamChaser* chaser_;
  std::uint32_t interval_;
  std::uint32_t told_ = 0;  // The VBLANK that the program was told of last.
  std::uint32_t begun_ = 0;
  bool sending_ = false;
  std::uint32_t frames_ = 0;
  std::uint32_t first_ = 0;
  std::uint32_t last_ = 0;
  std::uint32_t late_ = 0;
  std::uint32_t skipped_ = 0;
  std::uint32_t early_ = 0;
  std::uint32_t dropped_ = 0;
  std::uint32_t dropped_since_ = 0;  // Since a frame was shown.
};

}  // namespace host
