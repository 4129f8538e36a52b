// SPDX-License-Identifier: MIT
//
// Is a point inside a polygon?
//
// Rule: a half-line from the point to the left meets the edges. Those it meets downwards count +1 and those
// upwards -1: their sum is the winding number, and its lowest bit the parity of the crossings. An edge is
// closed at its upper and open at its lower end, and a point on an edge is to its right, so every point has
// one owner (the top-left rule): at pixel centres the answers are those of `fill_polygon`, pixel by pixel.
// For a convex polygon the signs of all edge functions are the same inside; on an edge the function is zero
// and the top-left rule gives the sign.
//
// Bit budget: differences of sub-pixel coordinates have 30 bits, their products 60: int64. Error: none.
// Textbook: section 2.5, with erratum E2 (its winding rule is even-odd). Worst known input: a half-line
// through vertices.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/raster/contours.hpp>
#include <intaglio/status.hpp>

#include <span>

namespace intaglio::raster {

/// How often the contours wind around the point: clockwise on screen counts negative, counter-clockwise
/// positive. The lowest bit is the parity.
/// Errors: vertices, contours (as `fill_polygon`), point (outside the domain).
/// Cost: two comparisons an edge; two multiplications for each edge that the point's row meets.
[[nodiscard]] Result<int> winding_number(const std::span<const linear::SubPoint>& vertices,
                                         const std::span<const int>& contour_lengths,
                                         linear::SubPoint point) noexcept;

/// True if the point is inside by the rule: even-odd is the parity test, non-zero the winding test.
/// Errors: as `winding_number`; rule.
[[nodiscard]] Result<bool> inside_polygon(FillRule rule, const std::span<const linear::SubPoint>& vertices,
                                          const std::span<const int>& contour_lengths,
                                          linear::SubPoint point) noexcept;

/// True if the point is inside a convex polygon (one contour, either way around), by the sign test. Repeated
/// vertices and collinear runs are allowed. For polygons that aren't convex: whether the point is on the same
/// side of all edges.
/// Errors: vertices, point (outside the domain). Cost: two multiplications an edge, up to the first of the
/// other sign.
[[nodiscard]] Result<bool> inside_convex(const std::span<const linear::SubPoint>& vertices,
                                         linear::SubPoint point) noexcept;

}  // namespace intaglio::raster
