// SPDX-License-Identifier: MIT
//
// Edge functions: on which side of an edge is a pixel's centre?
//
// Rule: E(p) = dx*(p.y - a.y) - dy*(p.x - a.x) for the edge from a to b = a + (dx, dy): positive to the right
// of the edge as one goes along it on screen. Zero belongs to edges that run upwards or, level, to the right
// (the top-left rule for polygons that go clockwise on screen): the others get E - 1, so that the sign alone
// decides. At pixel centres E changes by multiples of 256 from one to the next; its low 8 bits are constant
// there and floor(E / 256) has the same sign. So one pixel to the right adds -dy, one down adds dx.
//
// Bit budget: |E| <= 2^30*2^29 for any two points of the domain: int64; floor(E / 256) has 52 bits. Where
// both sides of the polygon's bounding box are at most 2032 pixels and the pixel is at most 16 outside it,
// |floor(E / 256)| <= 2*2032*2048*256 < 2^31: int32 holds it. Error: none. Textbook: section 2.6.5, with
// erratum E4 (a zero has one owner).
#pragma once

#include <intaglio/linear/point.hpp>

#include <cstdint>

namespace intaglio::raster {

/// The longest side of a bounding box, in 1/256 pixel, that an `EdgeFunction<std::int32_t>` is for.
inline constexpr int narrow_extent = 2032 * linear::subpixel_one;
static_assert(std::int64_t{2} * 2032 * 2048 * linear::subpixel_one < INT32_MAX);

/// +1 if the point is on the side that an edge from a to b owns, going clockwise on screen around what is
/// inside; -1 if not. All three are in the domain. An edge without length owns nothing either way around.
[[nodiscard]] constexpr int side_of(linear::SubPoint a, linear::SubPoint b, linear::SubPoint p) noexcept {
  const std::int64_t right = std::int64_t{b.x - a.x} * (p.y - a.y);
  const std::int64_t left = std::int64_t{b.y - a.y} * (p.x - a.x);
  if (right != left) return right > left ? 1 : -1;
  return b.y < a.y || (b.y == a.y && b.x > a.x) ? 1 : -1;
}

/// floor(E / 256) at one pixel: negative outside. What it adds from pixel to pixel is `per_column` and
/// `per_row`.
template <class Int>
struct EdgeFunction {
  Int value = 0;
  Int per_column = 0;
  Int per_row = 0;
};

/// The function of the edge from a to b at a pixel. All are in the domain.
[[nodiscard]] constexpr EdgeFunction<std::int64_t> edge_function(linear::SubPoint a, linear::SubPoint b,
                                                                 linear::Point pixel) noexcept {
  const int dx = b.x - a.x;
  const int dy = b.y - a.y;
  const bool owns_zero = dy < 0 || (dy == 0 && dx > 0);
  const std::int64_t value = std::int64_t{dx} * (pixel.y * linear::subpixel_one - a.y) -
                             std::int64_t{dy} * (pixel.x * linear::subpixel_one - a.x) - (owns_zero ? 0 : 1);
  return {value >> linear::subpixel_bits, -dy, dx};
}

}  // namespace intaglio::raster
