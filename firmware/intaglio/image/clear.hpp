// SPDX-License-Identifier: MIT
//
// Clearing a surface: every pixel of its bounds gets one index.
//
// Rule: the pixels of `bounds()` and no other bit of memory. A sub-surface may begin and end inside a byte
// that it shares with its neighbours, and the gap between rows may be someone else's; both stay as they are.
#pragma once

#include <intaglio/image/fill.hpp>
#include <intaglio/image/row.hpp>
#include <intaglio/image/surface.hpp>

namespace intaglio::image {

/// Sets all pixels to `index`. Errors: index (more than the format holds); nothing is drawn then.
template <PixelFormat F>
Status clear(const Surface<F>& surface, unsigned index) noexcept {
  if (index > F::max_index) return {Error::out_of_range, Argument::index, F::max_index};
  if (surface.empty()) return {};
  const linear::Rect& b = surface.bounds();
  const Pattern pattern(F::replicate(index));
  if constexpr (F::bits == 8)
    Replace::rows(surface.byte_at(b.x, b.y), b.width, b.height, surface.stride(), pattern);
  else
    Replace::rows(row_run(surface, b.y, b.x, b.right()), b.height, surface.stride(), pattern);
  return {};
}

}  // namespace intaglio::image
