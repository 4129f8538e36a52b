// SPDX-License-Identifier: MIT
//
// Rectangles of whole pixels: a corner and an extent, half-open (the right and bottom edges are outside).
//
// Bit budget: corner within +-2^20 and extent within 2^21, so right() and bottom() stay within 2^22.
#pragma once

#include <intaglio/linear/point.hpp>

namespace intaglio::linear {

/// The pixels x .. x+width-1 by y .. y+height-1. A width or height of zero or less means no pixel.
struct Rect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  [[nodiscard]] constexpr int right() const noexcept { return x + width; }    ///< One past the last column.
  [[nodiscard]] constexpr int bottom() const noexcept { return y + height; }  ///< One past the last row.
  [[nodiscard]] constexpr bool empty() const noexcept { return width <= 0 || height <= 0; }
  [[nodiscard]] constexpr bool contains(Point p) const noexcept {
    return static_cast<unsigned>(p.x) - static_cast<unsigned>(x) <
               static_cast<unsigned>(width > 0 ? width : 0) &&
           static_cast<unsigned>(p.y) - static_cast<unsigned>(y) <
               static_cast<unsigned>(height > 0 ? height : 0);
  }
  friend constexpr bool operator==(const Rect&, const Rect&) noexcept = default;
};

/// True if a length is one that a rectangle may have: at most 2^21, of either sign.
[[nodiscard]] constexpr bool length_in_domain(int length) noexcept {
  constexpr unsigned limit = 2U * coordinate_limit;
  return static_cast<unsigned>(length) + limit <= 2U * limit;
}

/// True if the rectangle can be drawn: corner in the domain, extent at most 2^21 either way. Negative extents
/// are in the domain and empty.
[[nodiscard]] constexpr bool in_domain(const Rect& r) noexcept {
  return in_domain(Point{r.x, r.y}) && length_in_domain(r.width) && length_in_domain(r.height);
}

/// The pixels common to both; an empty rectangle at a corner inside both ranges if there are none.
[[nodiscard]] constexpr Rect intersect(const Rect& a, const Rect& b) noexcept {
  const int left = a.x > b.x ? a.x : b.x;
  const int top = a.y > b.y ? a.y : b.y;
  const int right = a.right() < b.right() ? a.right() : b.right();
  const int bottom = a.bottom() < b.bottom() ? a.bottom() : b.bottom();
  return {left, top, right > left ? right - left : 0, bottom > top ? bottom - top : 0};
}

}  // namespace intaglio::linear
