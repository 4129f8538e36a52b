// SPDX-License-Identifier: MIT
//
// A stretch of pixels in one row, seen as bytes: a part of a first byte, whole bytes, a part of a last byte.
//
// Rule: the pixels x_begin .. x_end-1 of row y own exactly the bits of `head_mask` in byte 0, all bits of
// bytes 1 .. whole, and the bits of `tail_mask` in byte whole+1. A mask of 0 means that the byte isn't part
// of the stretch and may not exist; a stretch inside one byte is all head. Code that works on bytes thus
// never touches a neighbour's bit.
#pragma once

#include <intaglio/image/surface.hpp>

#include <cstdint>

namespace intaglio::image {

/// The bits of a byte that hold its pixels `slot`, slot+1, ... counted from the left. 0 <= slot <= a byteful.
template <PixelFormat F>
[[nodiscard]] constexpr std::uint8_t mask_from(int slot) noexcept {
  const auto bits = static_cast<unsigned>(slot * F::bits);
  return static_cast<std::uint8_t>(F::order == BitOrder::msb_first ? 0xFFU >> bits : 0xFFU << bits);
}

/// Which bytes and bits a stretch of a row is made of. `Byte` as in `PixelView`.
template <class Byte>
struct RowBytes {
  Byte* first = nullptr;       ///< Byte 0: the one under `head_mask`, even if that is 0.
  int whole = 0;               ///< Whole bytes, from `first + 1` on.
  std::uint8_t head_mask = 0;  ///< Bits of the stretch in `first[0]`.
  std::uint8_t tail_mask = 0;  ///< Bits of the stretch in `first[whole + 1]`.
};

/// The pixels x_begin .. x_end-1 of row y. Precondition: x_begin < x_end, both inside `bounds()` (x_end may
/// be its right edge), y a row of it. A head that fills its byte counts as a head, not as a whole byte.
template <PixelFormat F, class Byte>
[[nodiscard]] constexpr RowBytes<Byte> row_bytes(const PixelView<F, Byte>& view, int y, int x_begin,
                                                 int x_end) noexcept {
  constexpr int byteful = F::pixels_per_byte;
  const auto shift = static_cast<int>(view.shift_at(x_begin)) / F::bits;
  const int slot = F::order == BitOrder::lsb_first ? shift : byteful - 1 - shift;
  const int end = slot + (x_end - x_begin);  // Counted from the first pixel of byte 0.
  RowBytes<Byte> row{view.byte_at(x_begin, y), 0, mask_from<F>(slot), 0};
  if (end <= byteful) {
    row.head_mask = static_cast<std::uint8_t>(row.head_mask & ~mask_from<F>(end));
  } else {
    row.whole = (end >> F::byte_shift) - 1;
    row.tail_mask = static_cast<std::uint8_t>(~mask_from<F>(end & (byteful - 1)));
  }
  return row;
}

}  // namespace intaglio::image
