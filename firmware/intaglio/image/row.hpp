// SPDX-License-Identifier: MIT
//
// A stretch of pixels in one row, seen as bytes: a part of a first byte, whole bytes, a part of a last byte.
//
// Rule: the pixels x_begin .. x_end-1 of row y own the `head` bits of the first byte (cut by `tail` if the
// last pixel lies in the same byte), all bits of the bytes between, and the `tail` bits of the last. Code
// that works on bytes by these masks never touches a neighbour's bit.
#pragma once

#include <intaglio/image/fill.hpp>
#include <intaglio/image/surface.hpp>

namespace intaglio::image {

/// The bytes of the pixels x_begin .. x_end-1 of row y. Precondition: x_begin < x_end, both inside `bounds()`
/// (x_end may be its right edge), y a row of it.
template <PixelFormat F>
[[nodiscard]] constexpr MaskedRun row_run(const Surface<F>& surface, int y, int x_begin, int x_end) noexcept {
  constexpr int last_slot = F::pixels_per_byte - 1;
  const int slot = surface.slot_at(x_begin);
  const int end = slot + (x_end - x_begin);  // Counted from the first pixel of the first byte.
  return {surface.byte_at(x_begin, y), end >> F::byte_shift, F::mask_from(slot),
          ~F::mask_from(end & last_slot) & 255U};
}

}  // namespace intaglio::image
