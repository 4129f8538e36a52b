// SPDX-License-Identifier: MIT
//
// Scan-out order: which row or column the beam fetches next, and its pixels.
//
// Rule: a panel scanned downwards fetches row i as its i-th line, upwards row height-1-i; to the right column
// i, to the left column width-1-i. A column is packed as a row is, from the top. The time of a refresh is
// shared by its lines, so a panel scanned by columns has width lines and the same share of blanking.
#pragma once

#include <hal/panel.hpp>
#include <hal/sim/effects/effects.hpp>
#include <hal/sim/pixels.hpp>

#include <vector>

namespace hal::sim {

[[nodiscard]] constexpr bool by_columns(ScanDirection scan) {
  return scan == ScanDirection::left || scan == ScanDirection::right;
}
/// Lines of a picture as the beam counts them.
[[nodiscard]] constexpr int lines_of(const Capabilities& c) {
  return by_columns(c.scan) ? c.width : c.height;
}
/// Bits of a pixel in the memory that the beam fetches: colours of three bytes where they are applied as
/// pixels are written.
[[nodiscard]] constexpr int memory_bits(const Capabilities& c) {
  return c.palette_on_write ? 24 : c.bits_per_pixel;
}
/// Bytes of a line.
[[nodiscard]] constexpr int line_bytes(const Capabilities& c) {
  return row_bytes(by_columns(c.scan) ? c.height : c.width, memory_bits(c));
}
/// The row or column that is line `line` of the beam.
[[nodiscard]] constexpr int place_of(const Capabilities& c, int line) {
  const bool backwards = c.scan == ScanDirection::up || c.scan == ScanDirection::left;
  return backwards ? lines_of(c) - 1 - line : line;
}

/// The pixels of line `line` in a memory of rows `stride` bytes apart: part of it, or gathered in `column`.
[[nodiscard]] std::span<const std::uint8_t> line_pixels(const Capabilities& c,
                                                        std::span<const std::uint8_t> memory, int stride,
                                                        int line, std::vector<std::uint8_t>& column);

}  // namespace hal::sim
