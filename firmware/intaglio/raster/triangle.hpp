// SPDX-License-Identifier: MIT
//
// Filled triangles.
//
// Rule: a pixel belongs to the triangle iff its centre lies inside, or on an edge with the interior to its
// right, or on a horizontal edge with the interior below it (the top-left rule): row y has the pixels
// ceil(x_left) <= x < ceil(x_right) of the rows ceil(y_top) <= y < ceil(y_bottom). Triangles that share an
// edge share no pixel and leave none out; the order of the vertices doesn't matter; no area, no pixel.
//
// The longest edge (in y) and the two others are walked together, each by exact quotient and remainder, from
// the first visible row on.
// Bit budget: coordinates have 30 bits, so the products of the orientation test have 60: int64. Edges: see
// edge.hpp. Error: none. Textbook: section 2.6.5 (edge walking), with erratum E4.
// Worst known inputs: (314,11)(14,200)(97,237) overflows int16 products, (0,0)(60000,0)(0,60000) int32 ones.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/edge.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

#include <array>

namespace intaglio::raster {

namespace detail {
/// The visible rows of a triangle and its edges: `whole` has all rows, `bent` those down to `y_bend`, where
/// it goes on as `lower`. Each stands on its first visible row.
struct TriangleRows {
  Edge whole;  // none of this counts if there is no row: y_begin >= y_end
  Edge bent;
  Edge lower;
  int y_begin;
  int y_bend;
  int y_end;
  bool bent_is_left;
};

/// Finds them; no row if none is visible. Errors: as `fill_triangle`.
[[nodiscard]] Status triangle_rows(const std::array<linear::SubPoint, 3>& vertices, const linear::Rect& clip,
                                   TriangleRows& rows) noexcept;
[[nodiscard]] Status triangle_rows(const std::array<linear::Point, 3>& vertices, const linear::Rect& clip,
                                   TriangleRows& rows) noexcept;

template <class V, SpanSink S>
Status fill_triangle(S& sink, std::array<V, 3>&& vertices) {
  const linear::Rect clip = sink.clip();
  TriangleRows rows;
  const Status status = triangle_rows(vertices, clip, rows);
  if (rows.y_begin >= rows.y_end) return status;
  const int clip_left = clip.x;
  const int clip_right = clip.right();
  Edge left = rows.bent_is_left ? rows.bent : rows.whole;
  Edge right = rows.bent_is_left ? rows.whole : rows.bent;
  int y = rows.y_begin;
  for (int y_stop = rows.y_bend;; y_stop = rows.y_end) {
    for (; y < y_stop; ++y) {
      const int x_begin = left.x() > clip_left ? left.x() : clip_left;
      const int x_end = right.x() < clip_right ? right.x() : clip_right;
      if (x_begin < x_end) sink.span(y, x_begin, x_end);
      left.next();
      right.next();
    }
    if (y == rows.y_end) return status;
    (rows.bent_is_left ? left : right) = rows.lower;
  }
}
}  // namespace detail

/// Fills the triangle a, b, c (in 1/256 pixel, |c| <= 2^28), vertices in any order.
/// Errors: point (outside the domain); nothing is drawn then.
/// Cost: set-up of three edges, and about 20 instructions a visible row on top of what the sink takes.
template <SpanSink S>
Status fill_triangle(S&& sink, linear::SubPoint a, linear::SubPoint b, linear::SubPoint c) {
  return detail::fill_triangle<linear::SubPoint>(sink, {a, b, c});
}

/// The triangle between three pixel centres, |c| <= 2^20; otherwise as above.
template <SpanSink S>
Status fill_triangle(S&& sink, linear::Point a, linear::Point b, linear::Point c) {
  return detail::fill_triangle<linear::Point>(sink, {a, b, c});
}

}  // namespace intaglio::raster
