// SPDX-License-Identifier: MIT
//
// Antialiased lines: the area of a thin parallelogram.
//
// Rule: the line is the parallelogram of `draw_thick_line`, of any width from 1/256 pixel on, with ends in
// 1/256 pixel; the level of a pixel is the exact area that it covers (coverage.hpp). Where the line leaves a
// column through one pixel's side that is the book's pair of areas, d^2/(2s) and (s-d)^2/(2s); here there are
// no cases, nor a division by a slope of zero, and ends and wide lines are right as well.
//
// Error bound: that of coverage.hpp, and the corners' rounding to 1/256 pixel, which moves a side by at most
// 0.71/256 pixel across itself: one level for each of the four sides that crosses the pixel. From b to a the
// levels are those from a to b. Bit budget: thick_line.hpp, coverage.hpp.
// Textbook: section 2.8.1. Worst known inputs: nearly level lines, whose slope the book divides by; a width
// below a pixel.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/thick_line.hpp>
#include <intaglio/status.hpp>

#include <array>
#include <span>

namespace intaglio::raster {

/// Hands the coverage of the line from `a` to `b` over, ends and width in 1/256 pixel. A width of 0 covers
/// nothing. `workspace` is that of `fill_coverage` for four edges: `coverage_cells(4, width of the clip)`.
/// Errors: as `draw_thick_line`, but for round caps, which have no corners (out_of_range rule); workspace
/// (too small: `needed()` cells). Cost: a square root and two divisions, then `fill_coverage` of four edges.
template <CoverageSink S>
Status draw_smooth_line(S&& sink, linear::SubPoint a, linear::SubPoint b, int width, Cap cap,
                        const std::span<CoverageCell>& workspace) {
  std::array<linear::SubPoint, 4> corners;
  const Status status = detail::thick_line_corners(a, b, width, cap, corners);
  if (!status.ok()) return status;
  return fill_coverage(sink, FillRule::non_zero, corners, workspace);
}

}  // namespace intaglio::raster
