// SPDX-License-Identifier: MIT
//
// Between pixels and sub-pixels: rounding of points, and rectangles with sub-pixel edges.
//
// Rule: a pixel is its integer centre. A point belongs to the nearest pixel, ties towards +x and +y. A
// rectangle is half-open like a filled polygon: it owns the pixels whose centres lie inside it or on its left
// or top edge, so rectangles that share an edge share no pixel and leave none out.
//
// Bit budget: corners within 2^28 and extents within 2^29, so right() and bottom() stay within 2^30.
#pragma once

#include <intaglio/linear/rect.hpp>

namespace intaglio::linear {

/// The pixel whose centre is nearest, ties towards +x and +y. The point must be in the domain.
[[nodiscard]] constexpr Point to_pixel_nearest(SubPoint p) noexcept {
  return {(p.x + subpixel_one / 2) >> subpixel_bits, (p.y + subpixel_one / 2) >> subpixel_bits};
}
/// The last pixel whose centre is not right of or below the point. The point must be in the domain.
[[nodiscard]] constexpr Point to_pixel_floor(SubPoint p) noexcept {
  return {p.x >> subpixel_bits, p.y >> subpixel_bits};
}

/// A rectangle in 1/256 pixel: a corner and an extent, half-open. An extent of zero or less means no area.
struct SubRect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  [[nodiscard]] constexpr int right() const noexcept { return x + width; }    ///< The right edge, outside.
  [[nodiscard]] constexpr int bottom() const noexcept { return y + height; }  ///< The bottom edge, outside.
  [[nodiscard]] constexpr bool empty() const noexcept { return width <= 0 || height <= 0; }
  friend constexpr bool operator==(const SubRect&, const SubRect&) noexcept = default;
};

/// True if the corner is in the domain and the extents are at most 2^21 pixels either way.
[[nodiscard]] constexpr bool in_domain(const SubRect& r) noexcept {
  constexpr int limit = 2 * coordinate_limit * subpixel_one;
  return in_domain(SubPoint{r.x, r.y}) && r.width <= limit && r.height <= limit && r.width >= -limit &&
         r.height >= -limit;
}

/// The pixels that a rectangle owns: those whose centres it contains. The rectangle must be in the domain.
[[nodiscard]] constexpr Rect pixels_of(const SubRect& r) noexcept {
  if (r.empty()) return {};
  const auto first_at_or_after = [](int edge) { return (edge + subpixel_one - 1) >> subpixel_bits; };
  const int left = first_at_or_after(r.x);
  const int top = first_at_or_after(r.y);
  return {left, top, first_at_or_after(r.right()) - left, first_at_or_after(r.bottom()) - top};
}

/// The rectangle between the centres of a rectangle's first pixels and of those after its last; it owns the
/// same pixels. The rectangle must be in the domain.
[[nodiscard]] constexpr SubRect to_subpixel(const Rect& r) noexcept {
  return {r.x * subpixel_one, r.y * subpixel_one, r.width * subpixel_one, r.height * subpixel_one};
}

}  // namespace intaglio::linear
