// SPDX-License-Identifier: MIT
//
// The part of a line segment inside a window, by three classical clippers that agree to the last bit.
//
// Rule: the window is closed: its edges and corners belong to it, and a segment that only touches it leaves
// one point. The answer is the interval of parameters [enter, leave] as fractions in lowest terms, and the
// places they lead to, exactly. Parameters come from the segment as it was given, never from a clipped one,
// and are compared by cross multiplication, never rounded: so Cohen-Sutherland ends after at most four cuts,
// no clipper changes a slope, and from B to A the answer is that from A to B turned round.
//
// This is geometry. Lines are drawn by `line_path.hpp`, which clips the range of pixels instead.
//
// Bit budget: end points within 2^28 sub-pixels, window edges within 2^30, as are their differences,
// parameters over a denominator of at most 2^29, products within 2^60. Error: none.
// Textbook: section 2.9.2. Skala's table finds the edges that the *line* crosses; the segment may end sooner,
// so its parameters are cut to 0 .. 1. Worst known inputs: segments through a corner, along an edge, or of no
// length, which rounded parameters lose or never finish.
#pragma once

#include <intaglio/clip/fraction_point.hpp>
#include <intaglio/linear/sub_rect.hpp>
#include <intaglio/number/fraction.hpp>
#include <intaglio/status.hpp>

#include <cstdint>

namespace intaglio::clip {

/// What of a segment from a to b is inside. If nothing is, only `visible` counts.
struct ClippedLine {
  bool visible = false;
  number::Fraction enter{};  ///< Where it begins, 0 (at a) .. 1 (at b), in lowest terms.
  number::Fraction leave{};  ///< Where it ends; never before `enter`.
  FractionPoint from{};      ///< The place at `enter`.
  FractionPoint to{};        ///< The place at `leave`.
  friend constexpr bool operator==(const ClippedLine&, const ClippedLine&) noexcept = default;
};

// The bits of a region code.
inline constexpr unsigned left_of = 1;   ///< x < left
inline constexpr unsigned right_of = 2;  ///< x > right
inline constexpr unsigned above = 4;     ///< y < top
inline constexpr unsigned below = 8;     ///< y > bottom

/// The region code of a place: which edges of the window it lies beyond; 0 inside and on the edges.
[[nodiscard]] constexpr unsigned region_code(linear::SubPoint p, const linear::SubRect& window) noexcept {
  return (p.x < window.x ? left_of : 0U) | (p.x > window.right() ? right_of : 0U) |
         (p.y < window.y ? above : 0U) | (p.y > window.bottom() ? below : 0U);
}

/// The two window edges that a line crosses, by the sides on which it has the corners: bit i of `corners` is
/// set if corner i is on the one side; corners are numbered top left, top right, bottom right, bottom left.
/// Bit i of the answer is the edge from corner i to the next. Answers 0 if all are on one side.
[[nodiscard]] constexpr unsigned skala_edges(unsigned corners) noexcept {
  constexpr std::uint8_t crossed[16] = {0, 9, 3, 10, 6, 15, 5, 12, 12, 5, 15, 6, 10, 3, 9, 0};
  return crossed[corners & 15U];
}

/// Cohen-Sutherland: region codes accept, reject or cut at one edge.
/// `window` has edges in 1/256 pixel; an extent of zero is a line or a point, a negative one is empty.
/// Errors: out_of_domain point, rectangle. Cost: none to four cuts, each one code of six 64-bit products.
[[nodiscard]] Result<ClippedLine> cohen_sutherland(linear::SubPoint a, linear::SubPoint b,
                                                   const linear::SubRect& window) noexcept;
/// Skala: the sides of the four corners name the two edges to cut at. Arguments and answer as above.
/// Cost: eight 64-bit products, two cuts.
[[nodiscard]] Result<ClippedLine> skala(linear::SubPoint a, linear::SubPoint b,
                                        const linear::SubRect& window) noexcept;
/// Liang-Barsky: t * p <= q for each of the four edges. Arguments and answer as above.
/// Cost: two to six comparisons of fractions, two 64-bit products each.
[[nodiscard]] Result<ClippedLine> liang_barsky(linear::SubPoint a, linear::SubPoint b,
                                               const linear::SubRect& window) noexcept;

}  // namespace intaglio::clip
