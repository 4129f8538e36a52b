// SPDX-License-Identifier: MIT
//
// SSD0323 (and SSD1325): OLED controller for 128x64 pixels of 16 greys, behind SPI.
//
// Rule: the display memory holds two pixels a byte, the left one in the high nibble (nibble remap on). A
// write sets a window in columns of two pixels and in rows, and sends the bytes of it row by row; the address
// counter wraps inside the window, so exactly the window's bytes are sent.
#pragma once

#include <hal/panels/command_port.hpp>
#include <hal/panels/write_panel.hpp>

namespace hal::panels {

/// What depends on the module an SSD0323 is built into.
struct Ssd0323Options {
  std::uint8_t contrast = 0x70;  ///< 0..127.
  /// Display offset: the memory row that the glass shows first.
  std::uint8_t offset = 0;
  /// Frames a second times 1000, counted by the frame clock: the controller has no VBLANK signal.
  std::uint32_t refresh_millihertz = 60'000;
};

class Ssd0323 final : public WritePanel {
 public:
  static constexpr int width = 128;
  static constexpr int height = 64;

  /// `frame_clock` gives the rhythm of frames; null: frames follow each other as fast as the bus takes them.
  explicit Ssd0323(CommandPort& port, Clock* frame_clock = nullptr,
                   const Ssd0323Options& options = {}) noexcept;

  /// Sets the controller up, clears its memory and switches the display on. After reset, before anything
  /// else. Errors: bus, pin.
  Status start() noexcept;

 private:
  Status do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept override;
  Status set_window(const Rect& area) noexcept;

  CommandPort* port_;
  Ssd0323Options options_;
};

}  // namespace hal::panels
