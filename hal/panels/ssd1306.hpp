// SPDX-License-Identifier: MIT
//
// SSD1306 and its relatives (SH1106, SSD0303): 1-bit OLED controllers behind I2C or SPI.
//
// Rule: the display memory is organised in pages of eight rows; a byte is a column of a page, bit 0 on top.
// The driver takes ordinary rows and turns them while it sends, sixteen columns at a time, in page addressing
// mode, which all relatives understand. Rectangles keep to whole pages.
#pragma once

#include <hal/panels/command_port.hpp>
#include <hal/panels/write_panel.hpp>

namespace hal::panels {

/// A module: size of the glass, where it lies in the display memory, and how the controller is set up.
struct Ssd1306Module {
  int width = 0;
  int height = 0;
  /// The memory column that the glass shows first.
  int column_offset = 0;
  /// Commands sent with the display off, before the memory is cleared.
  std::span<const std::uint8_t> setup{};
  /// Frames a second times 1000, counted by the frame clock: the controllers have no VBLANK signal.
  std::uint32_t refresh_millihertz = 60'000;
};

/// The common modules.
extern const Ssd1306Module ssd1306_128x64;
extern const Ssd1306Module ssd1306_128x32;
extern const Ssd1306Module sh1106_128x64;
extern const Ssd1306Module ssd0303_96x16;

class Ssd1306 final : public WritePanel {
 public:
  /// `frame_clock` gives the rhythm of frames; null: frames follow each other as fast as the bus takes them.
  explicit Ssd1306(CommandPort& port, const Ssd1306Module& module = ssd1306_128x64,
                   Clock* frame_clock = nullptr) noexcept;

  /// Sets the controller up, clears its memory and switches the display on. After reset, before anything
  /// else. Errors: bus, pin.
  Status start() noexcept;

 private:
  Status do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept override;
  /// Sends rows as page `page`, from column `x` on. `pixels` begins with the page's first row.
  Status write_page(int page, const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept;
  Status set_position(int page, int x) noexcept;

  CommandPort* port_;
  Ssd1306Module module_;
};

}  // namespace hal::panels
