// SPDX-License-Identifier: MIT
//
// Points and sizes in the plane, in whole pixels and in sub-pixels.
//
// y grows downwards; a pixel is its integer centre, so `Point{3, 4}` is the middle of a pixel, not its
// corner. Domain: |c| <= 2^20 pixels. `SubPoint` counts 1/256 pixel, so |c| <= 2^28. Bit budget: a difference
// of two sub-pixel coordinates has 30 bits, a product of two differences 60: both signs fit int64 with three
// bits to spare. Pixel differences have 22 bits, their products 44.
#pragma once

#include <cstdint>

namespace intaglio::linear {

static_assert(sizeof(int) >= 4, "coordinates are plain ints of at least 32 bits");

/// Largest magnitude of a coordinate, in pixels.
inline constexpr int coordinate_limit = 1 << 20;
/// Fraction bits of a sub-pixel coordinate.
inline constexpr int subpixel_bits = 8;
/// Sub-pixels in a pixel.
inline constexpr int subpixel_one = 1 << subpixel_bits;

/// A pixel.
struct Point {
  int x = 0;
  int y = 0;
  friend constexpr bool operator==(Point, Point) noexcept = default;
};

/// A place in 1/256 pixel; (0, 0) is the centre of pixel (0, 0).
struct SubPoint {
  int x = 0;
  int y = 0;
  friend constexpr bool operator==(SubPoint, SubPoint) noexcept = default;
};

/// An extent in pixels.
struct Size {
  int width = 0;
  int height = 0;
  friend constexpr bool operator==(Size, Size) noexcept = default;
};

/// True if |value| is inside the domain of pixel coordinates.
[[nodiscard]] constexpr bool in_domain(int value) noexcept {
  return static_cast<unsigned>(value) + static_cast<unsigned>(coordinate_limit) <= 2U * coordinate_limit;
}
[[nodiscard]] constexpr bool in_domain(Point p) noexcept { return in_domain(p.x) && in_domain(p.y); }
/// True if both coordinates are inside the domain of sub-pixel coordinates, |c| <= 2^28.
[[nodiscard]] constexpr bool in_domain(SubPoint p) noexcept {
  constexpr unsigned limit = static_cast<unsigned>(coordinate_limit) << subpixel_bits;
  return static_cast<unsigned>(p.x) + limit <= 2U * limit && static_cast<unsigned>(p.y) + limit <= 2U * limit;
}

/// The sub-pixel place of a pixel's centre. The pixel must be in the domain.
[[nodiscard]] constexpr SubPoint to_subpixel(Point p) noexcept {
  return {p.x * subpixel_one, p.y * subpixel_one};
}

}  // namespace intaglio::linear
