// SPDX-License-Identifier: MIT
//
// What OLED controllers with two pixels of 16 greys a byte have in common: SSD0323, SSD1322.
//
// Rule: the program's rows hold two pixels a byte, the left one high, as the memory does. Turned by a
// quarter, a row of the memory is a column of the picture, so its bytes are put together from two rows each.
#pragma once

#include <hal/panels/command_port.hpp>
#include <hal/panels/rotation.hpp>

#include <array>

namespace hal::panels {

/// 0, 17, 34 … 255.
inline constexpr auto sixteen_greys = [] {
  std::array<std::uint8_t, 48> colours{};
  for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = static_cast<std::uint8_t>(i / 3 * 17);
  return colours;
}();

/// Capabilities of a glass (not turned) whose memory is addressed in columns of `pixels_a_column`.
[[nodiscard]] constexpr Capabilities grey_capabilities(int width, int height, int pixels_a_column,
                                                       Rotation rotation,
                                                       std::uint32_t refresh_millihertz) noexcept {
  const bool turned = swaps_sides(rotation);
  return {.width = turned ? height : width,
          .height = turned ? width : height,
          .bits_per_pixel = 4,
          .bit_order = BitOrder::msb_first,
          .fixed_palette = sixteen_greys,
          .x_alignment = turned ? 2 : pixels_a_column,
          .y_alignment = turned ? pixels_a_column : 1,
          // These controllers are scanned in the order of their memory's rows, whichever way it is mapped.
          .scan = turned ? ScanDirection::right : ScanDirection::down,
          .refresh_millihertz = refresh_millihertz};
}

/// Sends `width` x `height` pixels of the picture as data, in the order of the memory's rows, an even number
/// each; turned: as the memory's columns. Whoever calls has set the window.
Status send_greys(CommandPort& port, int width, int height, std::span<const std::uint8_t> pixels, int stride,
                  bool turned) noexcept;

/// Sends `bytes` bytes of black.
Status send_black(CommandPort& port, int bytes) noexcept;

}  // namespace hal::panels
