// SPDX-License-Identifier: MIT
//
// Pixel formats: palette indices of 1, 2, 4 or 8 bits, packed into bytes.
//
// Rule: pixel x of a row lies in byte (x * bits) / 8. Which end of the byte holds the leftmost pixel is a
// property of the format, because devices differ: an SSD0323 shows the high nibble left, a PL110 in
// little-endian mode the low nibble. The format is a type, so a program pays only for the ones it names.
#pragma once

#include <concepts>
#include <cstdint>

namespace intaglio::image {

/// Which end of a byte holds its leftmost pixel.
enum class BitOrder : std::uint8_t { msb_first, lsb_first };

/// Palette indices of `Bits` bits. `Order` means nothing for 8 bits.
template <int Bits, BitOrder Order = BitOrder::msb_first>
struct Indexed {
  static_assert(Bits == 1 || Bits == 2 || Bits == 4 || Bits == 8);
  static constexpr int bits = Bits;
  static constexpr BitOrder order = Order;
  static constexpr int pixels_per_byte = 8 / Bits;
  /// log2(pixels_per_byte): shifts a column to its byte.
  static constexpr int byte_shift = Bits == 8 ? 0 : Bits == 4 ? 1 : Bits == 2 ? 2 : 3;
  /// Largest index.
  static constexpr unsigned max_index = (1U << Bits) - 1U;

  /// Bytes that hold `width` pixels, width >= 0.
  [[nodiscard]] static constexpr int row_bytes(int width) noexcept {
    return (width + pixels_per_byte - 1) >> byte_shift;
  }
  /// How far left the pixel of column `x` lies within its byte, in bits. x >= 0.
  [[nodiscard]] static constexpr unsigned shift(int x) noexcept {
    const unsigned slot = static_cast<unsigned>(x) & (pixels_per_byte - 1U);
    const unsigned from_lsb = Order == BitOrder::lsb_first ? slot : pixels_per_byte - 1U - slot;
    return from_lsb * Bits;
  }
  /// The bits of a byte that hold its pixels `slot` and onward, counted from the left; none for the slot
  /// after the last.
  [[nodiscard]] static constexpr unsigned mask_from(int slot) noexcept {
    const unsigned bits_before = static_cast<unsigned>(slot) * Bits;
    return Order == BitOrder::lsb_first ? (255U << bits_before) & 255U : 255U >> bits_before;
  }
  /// A byte full of pixels of this index; only the low `bits` bits of `index` count.
  [[nodiscard]] static constexpr std::uint8_t replicate(unsigned index) noexcept {
    return static_cast<std::uint8_t>((index & max_index) * (255U / max_index));
  }
};

template <class F>
concept PixelFormat = requires {
  { F::bits } -> std::convertible_to<int>;
  { F::row_bytes(1) } -> std::same_as<int>;
  { F::replicate(0U) } -> std::same_as<std::uint8_t>;
};

using Indexed1 = Indexed<1>;
using Indexed2 = Indexed<2>;
using Indexed4 = Indexed<4>;
using Indexed8 = Indexed<8>;
using Indexed1Lsb = Indexed<1, BitOrder::lsb_first>;
using Indexed2Lsb = Indexed<2, BitOrder::lsb_first>;
using Indexed4Lsb = Indexed<4, BitOrder::lsb_first>;

}  // namespace intaglio::image
