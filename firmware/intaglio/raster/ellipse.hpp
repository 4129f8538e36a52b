// SPDX-License-Identifier: MIT
//
// Ellipses with axes along rows and columns, and circles and discs of any diameter.
//
// Rule: filled, the pixels of an oval (oval.hpp): those that aren't beyond the pixel nearest to the curve
// along its minor direction. The outline is those of them with a neighbour outside (row_shape.hpp): each is
// within half a pixel of the curve along x or y. A circle of odd diameter is that of circle.hpp; one of even
// diameter has its middle on a corner between four pixels. Radius 0 leaves a straight line or one pixel.
//
// Only visible rows are visited: the work is bounded by what is visible, at any radius.
//
// Bit budget: centre within 2^20, radii <= 2^20 (oval.hpp has the squares). Error: none.
// Textbook: section 2.4. Worst known inputs: see oval.hpp.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/oval.hpp>
#include <intaglio/raster/row_shape.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

#include <algorithm>
#include <cstdint>

namespace intaglio::raster {

namespace detail {

/// Draws what is visible of the same span on one row or two.
template <SpanSink S>
[[gnu::noinline]] void visible_span_of_rows(S& sink, int upper, int lower, int x_begin, int x_end) {
  const linear::Rect& clip = sink.clip();
  x_begin = std::max(x_begin, clip.x);
  x_end = std::min(x_end, clip.right());
  if (x_begin >= x_end) return;
  const auto visible = [&](int y) { return clip.y <= y && y < clip.bottom(); };
  if (visible(upper)) sink.span(upper, x_begin, x_end);
  if (upper != lower && visible(lower)) sink.span(lower, x_begin, x_end);
}

/// Fills an oval by pairs of rows, from the visible ones nearest to its middle outwards.
template <class Int, SpanSink S>
void fill_row_pairs(S& sink, Oval& oval) {
  const linear::Rect clip = sink.clip();
  const int top = oval.top();
  const int bottom = oval.bottom() - 1;
  const FromEnds rows(bottom - top, clip.y - top, clip.bottom() - 1 - top);
  if (clip.empty() || rows.first > rows.last) return;
  const int left = oval.left();
  const int right = oval.right();
  const bool all_visible = clip.x <= left && right <= clip.right() && clip.y <= top && bottom < clip.bottom();
  auto walk = oval.walk_from<Int>(rows.last);
  int upper = top + rows.last;
  int lower = bottom - rows.last;
  for (const int end = top + rows.first;; --upper, ++lower) {
    const int x_begin = left + walk.inset();
    const int x_end = right - walk.inset();
    if (all_visible) {
      sink.span(upper, x_begin, x_end);
      if (upper != lower) sink.span(lower, x_begin, x_end);
    } else {
      visible_span_of_rows(sink, upper, lower, x_begin, x_end);
    }
    if (upper == end) return;
    walk.outwards();
    walk.settle();
  }
}

template <SpanSink S>
void fill_oval(S& sink, Oval&& oval) {
  if (oval.fits<std::int32_t>())
    fill_row_pairs<std::int32_t>(sink, oval);
  else
    fill_rows(sink, oval);
}

}  // namespace detail

/// Fills the ellipse around the pixel `centre` (|c| <= 2^20) with half axes of 0..2^20 pixels along x and y;
/// it is 2*x_radius + 1 wide. Errors: point, radius (outside the domain); nothing is drawn then. Cost: a few
/// comparisons of products a visible row, on top of what the sink takes.
template <SpanSink S>
Status fill_ellipse(S&& sink, linear::Point centre, int x_radius, int y_radius) {
  const Status status = detail::check_ellipse(centre, x_radius, y_radius);
  if (status.ok()) detail::fill_oval(sink, detail::Oval::around(centre, x_radius, y_radius));
  return status;
}

/// Draws the outline of the ellipse that `fill_ellipse` fills. Errors and cost as there.
template <SpanSink S>
Status draw_ellipse(S&& sink, linear::Point centre, int x_radius, int y_radius) {
  const Status status = detail::check_ellipse(centre, x_radius, y_radius);
  if (status.ok()) detail::outline_rows(sink, detail::Oval::around(centre, x_radius, y_radius));
  return status;
}

/// Fills the disc that just fits the square of `diameter` pixels with its top left pixel at `top_left`
/// (|c| <= 2^20). Diameter 0..2^21; 0 has no pixel, an odd one 2r + 1 is `fill_disc` with radius r.
/// Errors: point, size (a diameter outside the domain); nothing is drawn then. Cost as of `fill_ellipse`.
template <SpanSink S>
Status fill_disc_in(S&& sink, linear::Point top_left, int diameter) {
  const Status status = detail::check_diameter(top_left, diameter);
  if (status.ok() && diameter > 0) detail::fill_oval(sink, detail::Oval(top_left, diameter, diameter));
  return status;
}

/// Draws the outline of the disc that `fill_disc_in` fills. Errors and cost as there.
template <SpanSink S>
Status draw_circle_in(S&& sink, linear::Point top_left, int diameter) {
  const Status status = detail::check_diameter(top_left, diameter);
  if (status.ok() && diameter > 0) detail::outline_rows(sink, detail::Oval(top_left, diameter, diameter));
  return status;
}

}  // namespace intaglio::raster
