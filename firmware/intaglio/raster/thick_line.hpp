// SPDX-License-Identifier: MIT
//
// Lines of true perpendicular width.
//
// Rule (DESIGN.md, "Thick line"): the parallelogram (a rectangle, but for the rounding of its corners to
// 1/256 pixel) whose middle line runs from end to end and whose sides lie half the width to either hand,
// filled by the top-left rule; square caps move its ends out by half the width, round ones add the disc of
// that diameter around each end (disc_edge.hpp has its rule). So thick lines that touch along a side share no
// pixel, each pixel is drawn once, and a line from b to a is the line from a to b.
//
// Each row is one span between the parallelogram's left and right sides, walked from the first visible row
// on. A line with round caps is a polyline of one segment (polyline.hpp). Error: the corners lie at the ends
// plus and minus one and the same offset, whose two coordinates are the true ones rounded to the nearest
// 1/256 pixel (stroke.hpp). So the sides are exactly parallel to the line. Bit budget: corners within 2^28 +
// 2 * 2^27. Textbook: section 2.3.3, whose line is thick along the minor axis only, hence 1/sqrt(2) too thin
// along diagonals. Worst known inputs: a width of 1 along a diagonal; ends that fall together.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/edge.hpp>
#include <intaglio/raster/polyline.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/raster/stroke.hpp>
#include <intaglio/status.hpp>

#include <array>
#include <concepts>

namespace intaglio::raster {

namespace detail {

/// The corners of a thick line, in order round it. Errors: as `draw_thick_line`; round caps have none.
[[nodiscard]] Status thick_line_corners(linear::SubPoint a, linear::SubPoint b, int width, Cap cap,
                                        std::array<linear::SubPoint, 4>& corners) noexcept;

/// A side of a thick line on its visible rows: an edge down to `bend`, another from there on. Each stands on
/// its first row.
struct ThickLineSide {
  Edge upper;
  Edge lower;
  int bend;
};

/// The visible rows of a thick line; none if y_begin >= y_end, and then nothing else counts.
struct ThickLineRows {
  ThickLineSide left;
  ThickLineSide right;
  int y_begin;
  int y_end;
};
/// Finds them. Errors: as above.
[[nodiscard]] Status thick_line_rows(linear::SubPoint a, linear::SubPoint b, int width, Cap cap,
                                     const linear::Rect& clip, ThickLineRows& rows) noexcept;

template <SpanSink S>
Status draw_cornered_line(S& sink, linear::SubPoint a, linear::SubPoint b, int width, Cap cap) {
  const linear::Rect clip = sink.clip();
  ThickLineRows rows;
  const Status status = thick_line_rows(a, b, width, cap, clip, rows);
  if (rows.y_begin >= rows.y_end) return status;
  const int clip_left = clip.x;
  const int clip_right = clip.right();
  Edge left = rows.left.upper;
  Edge right = rows.right.upper;
  for (int y = rows.y_begin;;) {
    int y_stop = rows.y_end;
    if (rows.left.bend > y && rows.left.bend < y_stop) y_stop = rows.left.bend;
    if (rows.right.bend > y && rows.right.bend < y_stop) y_stop = rows.right.bend;
    for (; y < y_stop; ++y) {
      const int x_begin = left.x() > clip_left ? left.x() : clip_left;
      const int x_end = right.x() < clip_right ? right.x() : clip_right;
      if (x_begin < x_end) sink.span(y, x_begin, x_end);
      left.next();
      right.next();
    }
    if (y == rows.y_end) return status;
    if (y == rows.left.bend) left = rows.left.lower;
    if (y == rows.right.bend) right = rows.right.lower;
  }
}

/// The ends of a line between pixels in 1/256 pixel. Errors: point, width.
[[nodiscard]] inline Status check_thick_line(linear::Point a, linear::Point b, int width) noexcept {
  if (!linear::in_domain(a) || !linear::in_domain(b)) return {Error::out_of_domain, Argument::point};
  if (!linear::in_domain(width)) return {Error::out_of_domain, Argument::width};
  return {};
}

}  // namespace detail

/// Draws the line from `a` to `b` and of that width, all in 1/256 pixel, with butt ends. A width of 0 has no
/// pixel. Errors: out_of_domain point (an end or a corner), out_of_domain width (not 0..2^28); nothing is
/// drawn then. Cost: a square root, ten divisions, and about 20 instructions a
/// visible row on top of what the sink takes.
template <SpanSink S, std::same_as<linear::SubPoint> P>
Status draw_thick_line(S&& sink, P a, P b, int width) {
  return detail::draw_cornered_line(sink, a, b, width, Cap::butt);
}

/// The same with caps. Errors: as above, out_of_range rule (`cap`). Cost: with round caps that of a polyline,
/// whose code is linked where this is called.
template <SpanSink S, std::same_as<linear::SubPoint> P>
Status draw_thick_line(S&& sink, P a, P b, int width, Cap cap) {
  if (cap != Cap::round) return detail::draw_cornered_line(sink, a, b, width, cap);
  const std::array<linear::SubPoint, 2> ends{a, b};
  std::array<StrokeEdge, detail::round_line_edges> workspace;
  const Status status = draw_polyline(sink, ends, Stroke{.width = width, .cap = cap}, workspace);
  return status.argument() == Argument::vertices ? Status{status.error(), Argument::point} : status;
}

/// The same between two pixels' centres, with the width in pixels, 0..2^20.
template <SpanSink S>
Status draw_thick_line(S&& sink, linear::Point a, linear::Point b, int width) {
  const Status status = detail::check_thick_line(a, b, width);
  if (!status.ok()) return status;
  return draw_thick_line(sink, linear::to_subpixel(a), linear::to_subpixel(b), width * linear::subpixel_one);
}
template <SpanSink S>
Status draw_thick_line(S&& sink, linear::Point a, linear::Point b, int width, Cap cap) {
  const Status status = detail::check_thick_line(a, b, width);
  if (!status.ok()) return status;
  return draw_thick_line(sink, linear::to_subpixel(a), linear::to_subpixel(b), width * linear::subpixel_one,
                         cap);
}

}  // namespace intaglio::raster
