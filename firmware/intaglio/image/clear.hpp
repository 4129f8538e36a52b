// SPDX-License-Identifier: MIT
//
// Clearing a surface: every pixel of its bounds gets one index.
//
// Rule: the pixels of `bounds()` and no other bit of memory. A sub-surface may begin and end inside a byte
// that it shares with its neighbours, and the gap between rows may be someone else's; both stay as they are.
#pragma once

#include <intaglio/image/row.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace intaglio::image {

namespace detail {
/// `byte` with the bits under `mask` taken from `bits`.
constexpr void merge(std::uint8_t& byte, unsigned bits, unsigned mask) noexcept {
  byte = static_cast<std::uint8_t>((byte & ~mask) | (bits & mask));
}
}  // namespace detail

/// Sets all pixels to `index`. Errors: index (more than the format holds); nothing is drawn then.
template <PixelFormat F>
Status clear(const Surface<F>& surface, unsigned index) noexcept {
  if (index > F::max_index) return {Error::out_of_range, Argument::index, F::max_index};
  if (surface.empty()) return {};
  const linear::Rect& b = surface.bounds();
  const std::uint8_t pattern = F::replicate(index);
  for (int y = b.y; y < b.bottom(); ++y) {
    const RowBytes<std::uint8_t> row = row_bytes(surface, y, b.x, b.right());
    detail::merge(*row.first, pattern, row.head_mask);
    std::memset(row.first + 1, pattern, static_cast<std::size_t>(row.whole));
    if (row.tail_mask != 0) detail::merge(row.first[row.whole + 1], pattern, row.tail_mask);
  }
  return {};
}

}  // namespace intaglio::image
