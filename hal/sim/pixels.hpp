// SPDX-License-Identifier: MIT
//
// Packed pixels, read and written one at a time by the plain definition; for simulators and test doubles,
// which must not depend on the library they check.
#pragma once

#include <hal/panel.hpp>

#include <cstdint>
#include <span>

namespace hal::sim {

/// Bytes of `width` pixels.
[[nodiscard]] constexpr int row_bytes(int width, int bits) { return (width * bits + 7) / 8; }

/// How far left the pixel of column x lies in its byte, in bits.
[[nodiscard]] constexpr int pixel_shift(int x, int bits, BitOrder order) {
  const int from_left = x * bits % 8;
  return order == BitOrder::msb_first ? 8 - bits - from_left : from_left;
}

/// The index at column x of a row.
[[nodiscard]] constexpr std::uint8_t pixel_at(std::span<const std::uint8_t> row, int x, int bits,
                                              BitOrder order) {
  const int byte = row[static_cast<std::size_t>(x * bits / 8)];
  return static_cast<std::uint8_t>(byte >> pixel_shift(x, bits, order) & ((1 << bits) - 1));
}

/// Writes the index at column x of a row.
constexpr void set_pixel(std::span<std::uint8_t> row, int x, int bits, BitOrder order, std::uint8_t index) {
  std::uint8_t& byte = row[static_cast<std::size_t>(x * bits / 8)];
  const int shift = pixel_shift(x, bits, order);
  const int mask = ((1 << bits) - 1) << shift;
  byte = static_cast<std::uint8_t>((byte & ~mask) | (index << shift & mask));
}

}  // namespace hal::sim
