// SPDX-License-Identifier: MIT
//
// How strokes look: their width, their ends and their corners.
//
// Rule (DESIGN.md, "Thick line"): the sides of a stroke lie half its width to either hand. Half the width as
// a vector is (w*dx/(2*L), w*dy/(2*L)), L = sqrt(dx*dx + dy*dy), of which each coordinate is rounded to the
// nearest 1/256 pixel, ties away from zero; all corners follow from it by sums.
//
// dx and dy are first doubled until the longer has 30 bits, so that L, rounded to an integer, is right to one
// part in 2^30. Where that could decide the rounding, squares are compared.
// Bit budget: dx, dy < 2^30, hence dx*dx + dy*dy < 2^61 and L < 2^31; w*dx <= 2^28 * 2^30; the squares that
// are compared have 122 bits, in two words. Error: none beyond the rounding.
// Textbook: section 2.3.3. Worst known input: a half-width that ends in exactly one half.
#pragma once

#include <intaglio/linear/point.hpp>

#include <array>
#include <cstdint>

namespace intaglio::raster {

/// How a thick line or an open stroke ends.
enum class Cap : std::uint8_t {
  butt,    ///< At its end; a line without length has no pixel.
  square,  ///< Half the width beyond it; a line without length is an upright square.
  round,   ///< By the disc of its width around the end; a line without length is that disc.
};

/// What fills the gap where two segments of a stroke meet at an angle.
enum class Join : std::uint8_t {
  miter,  ///< The outer sides go on until they meet; a bevel where that is too far away.
  bevel,  ///< A straight line between their ends.
  round,  ///< The disc of the stroke's width around the vertex.
};

/// The look of a stroke, lengths in 1/256 pixel.
struct Stroke {
  int width = linear::subpixel_one;  ///< 0..2^28; 0 has no pixel.
  Join join = Join::miter;
  Cap cap = Cap::butt;
  bool closed =
      false;  ///< The last vertex is joined to the first; then only a stroke without length has caps.
  int miter_limit = 4 * linear::subpixel_one;  ///< Farthest tip, in 1/256 of half the width: 1..16 times.
};

namespace detail {

inline constexpr int stroke_width_limit = linear::coordinate_limit * linear::subpixel_one;

/// The vector of half the width along the line from `a` to `b`; to the right if they are the same point.
/// Precondition: the points and the width are in the domain.
[[nodiscard]] linear::SubPoint half_width(linear::SubPoint a, linear::SubPoint b, int width) noexcept;

/// The corners of the parallelogram around the middle line from `a` to `b`, in order: right of `a` and of
/// `b`, left of `b` and of `a`. `along` is half the width along the line. Within 2^29.
[[nodiscard]] constexpr std::array<linear::SubPoint, 4> sides(linear::SubPoint a, linear::SubPoint b,
                                                              linear::SubPoint along) noexcept {
  return {{{a.x - along.y, a.y + along.x},
           {b.x - along.y, b.y + along.x},
           {b.x + along.y, b.y - along.x},
           {a.x + along.y, a.y - along.x}}};
}

}  // namespace detail

}  // namespace intaglio::raster
