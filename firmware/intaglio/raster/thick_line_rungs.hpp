// SPDX-License-Identifier: MIT
//
// Thick lines the book's way: so many pixels along the minor axis.
//
// Rule: each pixel of the line from a to b (line.hpp, clip/line_path.hpp: exact, AB = BA, ends to 1/256
// pixel) becomes a run of t pixels along the minor axis, t/2 of them (rounded down) before it, upwards or to
// the left. So a level line is t high, a line has exactly t pixels in each column (row, if steep) from end to
// end, and each pixel is drawn once.
//
// Error: across, such a line is t * M / sqrt(M*M + m*m) wide, the cosine of its angle to the longer axis:
// from t down to t/sqrt(2) along diagonals, 29.3 % less. Its ends are cut along an axis. The middle of a run
// is at most half a pixel from the line if t is odd, one if t is even. `draw_thick_line` has none of this.
//
// How: steep lines have one run on each row. Of others, the pixels on a row are those from the first column
// whose run reaches it to the last, and both wander along the line's own steps, one ahead of the other: one
// span a row, and no product but the line's set-up. Rows and columns outside the window aren't visited. Bit
// budget: the window grows by t on the minor axis: within 2^22. Textbook: section 2.3, exercise 3. Worst
// known input: a line far outside the window, but thick enough to fill it.
#pragma once

#include <intaglio/clip/line_path.hpp>
#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/raster/row_span.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/raster/thick_line.hpp>
#include <intaglio/status.hpp>

#include <concepts>

namespace intaglio::raster {

namespace detail {

/// The runs of a line that isn't steep: its pixels on one row.
class LineRuns {
 public:
  explicit LineRuns(const clip::LinePath& path) noexcept;
  [[nodiscard]] int row() const noexcept { return row_; }  ///< Counted from the path's start, along the way.
  [[nodiscard]] int begin() const noexcept { return begin_; }
  [[nodiscard]] int end() const noexcept { return end_; }
  /// Goes on to this row or, if the path ends before, to its last.
  void go_to(int row) noexcept;

 private:
  void extend() noexcept;

  int begin_;
  int end_;
  int row_ = 0;
  int left_;
  int error_;
  int minor_step_;
  int major_step_;
};

/// The spans of a line that is thick along its minor axis, unclipped from side to side, on visible rows.
class MinorThickScan {
 public:
  /// Errors: out_of_domain point, width (thickness).
  [[nodiscard]] Status prepare(linear::SubPoint a, linear::SubPoint b, int thickness,
                               const linear::Rect& clip) noexcept;
  [[nodiscard]] bool next(RowSpan& span) noexcept;

 private:
  clip::LinePath path_{};
  int thickness_ = 0;
  int before_ = 0;  // rows of a run before the line's own, along the way
  int row_ = 0;     // next row along the way
  int end_ = 0;     // behind the last visible one
  LineRuns first_{path_};
  LineRuns last_{path_};
};

}  // namespace detail

/// Draws the line from `a` to `b`, ends in 1/256 pixel, `thickness` pixels thick along its minor axis. A
/// thickness of 1 is `draw_line`, of 0 nothing. Errors: out_of_domain point, out_of_domain width (`thickness`
/// not 0..2^20); nothing is drawn then. Cost: as `draw_line`, then about 40 instructions a visible row and 15
/// a column.
template <SpanSink S, std::same_as<linear::SubPoint> P>
Status draw_minor_thick_line(S&& sink, P a, P b, int thickness) {
  const linear::Rect& clip = sink.clip();
  detail::MinorThickScan scan;
  const Status status = scan.prepare(a, b, thickness, clip);
  if (!status.ok()) return status;
  for (RowSpan span; scan.next(span);) {
    const int begin = span.x_begin > clip.x ? span.x_begin : clip.x;
    const int end = span.x_end < clip.right() ? span.x_end : clip.right();
    if (begin < end) sink.span(span.y, begin, end);
  }
  return {};
}

/// The same between two pixels' centres.
template <SpanSink S>
Status draw_minor_thick_line(S&& sink, linear::Point a, linear::Point b, int thickness) {
  if (!linear::in_domain(a) || !linear::in_domain(b)) return {Error::out_of_domain, Argument::point};
  return draw_minor_thick_line(sink, linear::to_subpixel(a), linear::to_subpixel(b), thickness);
}

/// Rung: the width asked for, along the minor axis. Its value is the width across the line, in 1/256 pixel.
struct MinorWidth {
  static constexpr number::Bound bound = number::parts_of_value(293);
  /// Of the line from `a` to `b`, both in the domain; `width` in pixels, 0..2^20. To the nearest.
  [[nodiscard]] int operator()(linear::Point a, linear::Point b, int width) const noexcept;
  template <SpanSink S>
  static Status draw(S&& sink, linear::Point a, linear::Point b, int width) {
    return draw_minor_thick_line(sink, a, b, width);
  }
};

/// Rung: the width asked for, across the line.
struct TrueWidth {
  static constexpr number::Bound bound = number::parts_of_value(0);
  [[nodiscard]] constexpr int operator()(linear::Point, linear::Point, int width) const noexcept {
    return width * linear::subpixel_one;
  }
  template <SpanSink S>
  static Status draw(S&& sink, linear::Point a, linear::Point b, int width) {
    return draw_thick_line(sink, a, b, width);
  }
};

/// The rungs of thick lines.
using ThickLineFamily = number::Family<MinorWidth, TrueWidth>;

}  // namespace intaglio::raster
