// SPDX-License-Identifier: MIT
//
// Antialiased lines: the area of a thin parallelogram.
//
// Rule: the line is the parallelogram of `draw_thick_line`, of any width from 1/256 pixel on, with ends in
// 1/256 pixel; the level of a pixel is the exact area that it covers (coverage.hpp). Where the line leaves a
// column through one pixel's side that is the book's pair of areas, d^2/(2s) and (s-d)^2/(2s); here there are
// no cases, nor a division by a slope of zero, and ends and wide lines are right as well. Round ends are half
// circles around them, as polygons of 4 to 64 sides.
//
// Error bound: that of coverage.hpp, and the corners' rounding to 1/256 pixel, which moves a side by at most
// 0.71/256 pixel across itself: one level for each of the four sides that crosses the pixel. A side of a
// round end is inside the circle by at most 1/256 pixel, but width/6600 of lines wider than 25 pixels, and
// its vertices, rounded, are within 1.42/256 pixel of theirs (and width/65000 for the sine): 2.5 levels for
// each pixel that the outline is long there; 2.02 at most in all, found by trying. From b to a the levels
// are those from a to b. Bit budget: thick_line.hpp, coverage.hpp. Textbook: section 2.8.1. Worst known
// inputs: nearly level lines, whose slope the book divides by; a width below a pixel.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/thick_line.hpp>
#include <intaglio/status.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::raster {

/// The most sides of a round end, and the most vertices of a line with two of them.
inline constexpr int round_cap_sides = 64;
inline constexpr std::size_t smooth_line_vertices = 2 * (round_cap_sides + 1);

namespace detail {

/// Puts the outline of a line with round ends in the first vertices of `outline` and says how many they are.
/// Errors: as `draw_thick_line`.
[[nodiscard]] Result<std::uint32_t> round_line_outline(
    linear::SubPoint a, linear::SubPoint b, int width,
    std::array<linear::SubPoint, smooth_line_vertices>& outline) noexcept;

}  // namespace detail

/// Hands the coverage of the line from `a` to `b` over, ends and width in 1/256 pixel. A width of 0 covers
/// nothing; a line without length is a disc if its ends are round. `workspace` is that of `fill_coverage` for
/// four edges: `coverage_cells(4, width of the clip)`; with round ends for `smooth_line_vertices`. Errors: as
/// `draw_thick_line`; workspace (too small: `needed()` cells). Cost: a square root and two divisions, then
/// `fill_coverage` of four edges; with round ends 10 to 130 of them, and their sines.
template <CoverageSink S>
Status draw_smooth_line(S&& sink, linear::SubPoint a, linear::SubPoint b, int width, Cap cap,
                        const std::span<CoverageCell>& workspace) {
  if (cap == Cap::round) {
    std::array<linear::SubPoint, smooth_line_vertices> outline;
    const Result<std::uint32_t> vertices = detail::round_line_outline(a, b, width, outline);
    if (!vertices.ok()) return vertices.status();
    return fill_coverage(sink, FillRule::non_zero, std::span(outline).first(vertices.value()), workspace);
  }
  std::array<linear::SubPoint, 4> corners;
  const Status status = detail::thick_line_corners(a, b, width, cap, corners);
  if (!status.ok()) return status;
  return fill_coverage(sink, FillRule::non_zero, corners, workspace);
}

}  // namespace intaglio::raster
