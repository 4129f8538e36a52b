// SPDX-License-Identifier: MIT
//
// SSD1322: OLED controller for up to 480x128 pixels of 16 greys, behind SPI with a data/command line;
// parameters of commands travel as data.
//
// Rule: the display memory is addressed in columns of four pixels, two bytes, the left pixel in the first
// high nibble (nibble remap on). Rectangles keep to whole columns. The usual glass of 256x64 pixels takes
// columns 28 to 91 of 120. Half a turn is the controller's (columns and rows remapped).
// Greys are even to the eye: the grey table holds the light of 0, 17, 34 … 255 in 180 steps.
//
// Source: Solomon Systech SSD1322 data sheet, rev. 1.2, chapters 9 "Command table" and 10 "Command
// descriptions"; the voltages and timings are those the makers of 256x64 glass give for it.
#pragma once

#include <hal/panels/bus_panel.hpp>
#include <hal/panels/grey_rows.hpp>

namespace hal::panels {

/// What depends on the module an SSD1322 is built into, and on how it is used.
struct Ssd1322Options {
  /// The glass, not turned; the width is a multiple of 4.
  int width = 256;
  int height = 64;
  /// The memory column, of four pixels, that the glass shows first.
  int column_offset = 28;
  Rotation rotation = Rotation::by_0;
  /// Shows the picture's negative.
  bool negative = false;
  std::uint8_t contrast = 0x9F;
  /// Frames a second times 1000, at least 1, counted by the frame clock.
  std::uint32_t refresh_millihertz = 60'000;
};

class Ssd1322 final : public BusPanel {
 public:
  static constexpr int memory_columns = 120;
  static constexpr int memory_rows = 128;

  /// `vblank` gives the rhythm of frames, as the controller's FR output does; null: `frame_clock` does; both
  /// null: frames follow each other as fast as the bus takes them.
  explicit Ssd1322(CommandPort& port, Clock* frame_clock = nullptr, VblankSource* vblank = nullptr,
                   const Ssd1322Options& options = {}) noexcept;

 private:
  Status do_start() noexcept override;
  Status do_stop() noexcept override { return do_sleep(true); }
  Status do_sleep(bool asleep) noexcept override;
  Status do_set_contrast(std::uint8_t contrast) noexcept override;
  Status do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept override;
  Status set_window(const Rect& area) noexcept;

  CommandPort* port_;
  Ssd1322Options options_;
  bool valid_;
};

}  // namespace hal::panels
