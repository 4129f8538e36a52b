// SPDX-License-Identifier: MIT
//
// SSD0323 (and SSD1325): OLED controller for 128x64 pixels of 16 greys, behind SPI.
//
// Rule: the display memory holds two pixels a byte, the left one in the high nibble (nibble remap on). A
// write sets a window in columns of two pixels and in rows, and sends the bytes of it row by row; the address
// counter wraps inside the window, so exactly the window's bytes are sent. Half a turn is the controller's
// (columns, nibbles and rows remapped); a quarter is made of that and of the driver's exchange of rows and
// columns.
//
// Source: Solomon Systech SSD0323 data sheet, and SSD1325 rev. 2.3 (2010/07), chapters "Command table" and
// "Command descriptions".
#pragma once

#include <hal/panels/bus_panel.hpp>
#include <hal/panels/grey_rows.hpp>
#include <hal/panels/synced_port.hpp>

namespace hal::panels {

/// What depends on the module an SSD0323 is built into.
struct Ssd0323Options {
  std::uint8_t contrast = 0x70;  ///< 0..127.
  /// Display offset: the memory row that the glass shows first.
  std::uint8_t offset = 0;
  /// Frames a second times 1000, at least 1, counted by the frame clock: the controller has no VBLANK signal.
  std::uint32_t refresh_millihertz = 60'000;
  Rotation rotation = Rotation::by_0;
  /// Shows the picture's negative.
  bool negative = false;
};

class Ssd0323 final : public BusPanel {
 public:
  static constexpr int width = 128;
  static constexpr int height = 64;

  /// `frame_clock` gives the rhythm of frames; null: frames follow each other as fast as the bus takes them.
  explicit Ssd0323(CommandPort& port, Clock* frame_clock = nullptr,
                   const Ssd0323Options& options = {}) noexcept;

 private:
  Status do_start() noexcept override;
  Status do_stop() noexcept override { return do_sleep(true); }
  Status do_sleep(bool asleep) noexcept override;
  Status do_set_contrast(std::uint8_t contrast) noexcept override;
  Status do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept override;
  Status set_window(const Rect& area) noexcept;

  SyncedPort port_;
  Ssd0323Options options_;
  bool valid_;
};

}  // namespace hal::panels
