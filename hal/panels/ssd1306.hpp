// SPDX-License-Identifier: MIT
//
// SSD1306 and its relatives (SH1106, SSD0303): 1-bit OLED controllers behind I2C or SPI.
//
// Rule: the display memory is organised in pages of eight rows; a byte is a column of a page, bit 0 on top.
// The driver takes ordinary rows and turns them while it sends, sixteen columns at a time, in page addressing
// mode, which all relatives understand. Rectangles keep to whole pages. Half a turn is the controller's
// (segments and rows remapped); a quarter is made of that and of an exchange of rows and columns, where a
// byte of the program's row is one of the memory's.
//
// Source: Solomon Systech SSD1306 data sheet, rev. 1.1 (2008/04), chapters 9 and 10, and its application note
// on the charge pump; Sino Wealth SH1106 data sheet, version 2.3; Solomon Systech SSD0303 data sheet.
#pragma once

#include <hal/panels/bus_panel.hpp>
#include <hal/panels/rotation.hpp>
#include <hal/panels/synced_port.hpp>

#include <optional>

namespace hal::panels {

/// A module: size of the glass, where it lies in the display memory, and how the controller is set up.
struct Ssd1306Module {
  int width = 0;
  int height = 0;
  /// The memory column that the glass shows first.
  int column_offset = 0;
  /// Columns of the memory: 128, or 132 of the relatives. Reversed segments count from the other end.
  int memory_columns = 128;
  /// The glass is mounted for reversed segments.
  bool segments_reversed = true;
  /// Commands sent with the display off, before the memory is cleared.
  std::span<const std::uint8_t> setup{};
  /// Frames a second times 1000, at least 1, counted by the frame clock: the controllers have no VBLANK
  /// signal.
  std::uint32_t refresh_millihertz = 60'000;
};

/// What depends on how a module is used.
struct Ssd1306Options {
  Rotation rotation = Rotation::by_0;
  /// Shows the picture's negative.
  bool negative = false;
  /// The module's own if not given.
  std::optional<std::uint8_t> contrast{};
};

/// The common modules.
extern const Ssd1306Module ssd1306_128x64;
extern const Ssd1306Module ssd1306_128x32;
extern const Ssd1306Module sh1106_128x64;
extern const Ssd1306Module ssd0303_96x16;

class Ssd1306 final : public BusPanel {
 public:
  /// `frame_clock` gives the rhythm of frames; null: frames follow each other as fast as the bus takes them.
  explicit Ssd1306(CommandPort& port, const Ssd1306Module& module = ssd1306_128x64,
                   Clock* frame_clock = nullptr, const Ssd1306Options& options = {}) noexcept;

 private:
  Status do_start() noexcept override;
  Status do_stop() noexcept override { return do_sleep(true); }
  Status do_sleep(bool asleep) noexcept override;
  Status do_set_contrast(std::uint8_t contrast) noexcept override;
  Status do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept override;
  /// Sends rows as page `page`, from column `x` on. `pixels` begins with the page's first row.
  Status write_page(int page, const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept;
  /// Sends a rectangle of a picture turned by a quarter.
  Status write_turned(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept;
  Status set_position(int page, int x) noexcept;

  SyncedPort port_;
  Ssd1306Module module_;
  Ssd1306Options options_;
  bool valid_;
  int first_column_;  // The memory column of the picture's first, or of its first row if it is turned.
};

}  // namespace hal::panels
