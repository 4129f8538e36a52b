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

namespace intaglio::raster {

namespace detail {
/// The visible rows of a triangle and the edges on the first of them. At row `y_bend` one side goes on with
/// the edge `lower`.
struct TriangleRows {
  Edge left;
  Edge right;
  Edge lower;
  int y_begin = 0;
  int y_bend = 0;
  int y_end = 0;
  bool lower_is_left = false;
};

/// Finds them. False if no row is visible. Precondition: the vertices are in the domain.
[[nodiscard]] bool triangle_rows(linear::SubPoint a, linear::SubPoint b, linear::SubPoint c,
                                 const linear::Rect& clip, TriangleRows& rows) noexcept;
}  // namespace detail

/// Fills the triangle a, b, c (in 1/256 pixel, |c| <= 2^28), vertices in any order.
/// Errors: point (outside the domain); nothing is drawn then.
/// Cost: set-up of three edges, and about 20 instructions a visible row on top of what the sink takes.
template <SpanSink S>
Status fill_triangle(S&& sink, linear::SubPoint a, linear::SubPoint b, linear::SubPoint c) {
  if (!linear::in_domain(a) || !linear::in_domain(b) || !linear::in_domain(c))
    return {Error::out_of_domain, Argument::point};
  const linear::Rect clip = sink.clip();
  detail::TriangleRows rows;
  if (!detail::triangle_rows(a, b, c, clip, rows)) return {};
  const int clip_left = clip.x;
  const int clip_right = clip.right();
  Edge left = rows.left;
  Edge right = rows.right;
  int y = rows.y_begin;
  for (int y_stop = rows.y_bend;; y_stop = rows.y_end) {
    for (; y < y_stop; ++y) {
      const int x_begin = left.x() > clip_left ? left.x() : clip_left;
      const int x_end = right.x() < clip_right ? right.x() : clip_right;
      if (x_begin < x_end) sink.span(y, x_begin, x_end);
      left.next();
      right.next();
    }
    if (y == rows.y_end) return {};
    (rows.lower_is_left ? left : right) = rows.lower;
  }
}

/// The triangle between three pixel centres, |c| <= 2^20; otherwise as above.
template <SpanSink S>
Status fill_triangle(S&& sink, linear::Point a, linear::Point b, linear::Point c) {
  if (!linear::in_domain(a) || !linear::in_domain(b) || !linear::in_domain(c))
    return {Error::out_of_domain, Argument::point};
  return fill_triangle(sink, linear::to_subpixel(a), linear::to_subpixel(b), linear::to_subpixel(c));
}

}  // namespace intaglio::raster
