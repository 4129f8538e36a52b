// SPDX-License-Identifier: MIT
//
// Dashed and dotted lines one pixel wide.
//
// Rule: the pixels of `draw_line`, of which pixel i, counted along the major axis from the end given first,
// is drawn iff i mod (on + off) < on. The phase belongs to the line, not to its visible part: clipping
// changes no pixel. `clip/line_path.hpp` finds the first visible step by division, and one more division
// finds its place in the pattern, so hidden pixels cost nothing, however many there are.
//
// The walk runs to the right, so a line given from right to left is walked backwards. Its pixel at distance d
// from the start then has the mirrored place (on - 1 - d) mod (on + off), which counts up along the walk and
// is below `on` for the same pixels.
// Bit budget: d + off <= 2^21 + 2^20; on + off <= 2^21. Error: none. Textbook: none; beside section 2.3.
// Worst known inputs: 1/1 along a row (solid in LVGL #9499), a pattern along 99,999,999 pixels (a hang in
// nanosvg #290).
#pragma once

#include <intaglio/clip/line_path.hpp>
#include <intaglio/raster/cursor.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/status.hpp>

namespace intaglio::raster {

namespace detail {

/// The place of the first visible pixel in the pattern.
[[nodiscard]] constexpr int dash_phase(linear::Point a, linear::Point b, const clip::LinePath& path, int on,
                                       int off) noexcept {
  const int way = path.steep ? path.start.y - a.y : path.start.x - a.x;
  const int distance = way < 0 ? -way : way;
  const int period = on + off;
  return b.x < a.x ? period - 1 - (distance + off) % period : distance % period;
}

/// A cursor that puts every pixel or leaves it out, in turn with a pattern.
template <PixelCursor Cursor>
class DashCursor {
 public:
  constexpr DashCursor(const Cursor& cursor, int phase, int on, int period) noexcept
      : cursor_(cursor), phase_(phase), on_(on), period_(period) {}
  constexpr void put() {
    if (phase_ < on_) cursor_.put();
    if (++phase_ == period_) phase_ = 0;
  }
  constexpr void left() { cursor_.left(); }
  constexpr void right() { cursor_.right(); }
  constexpr void up() { cursor_.up(); }
  constexpr void down() { cursor_.down(); }
  constexpr void turn_over() { cursor_.turn_over(); }

 private:
  Cursor cursor_;
  int phase_;
  int on_;
  int period_;
};

}  // namespace detail

/// Draws of the line from `a` to `b`, both ends included, `on` pixels, leaves out `off`, and so on, beginning
/// at `a` (so b to a has the same line's pixels but another phase). 1, 1 is dotted; `off` = 0 is solid.
/// Errors: out_of_domain point; out_of_range steps (`on` must be 1..2^20, `off` 0..2^20); nothing is drawn
/// then. Cost: as `draw_line`, one division, and some five instructions for each visible pixel of the line.
template <SpanSink S>
constexpr Status draw_dashed_line(S&& sink, linear::Point a, linear::Point b, int on, int off) {
  if (on < 1 || on > linear::coordinate_limit || off < 0 || off > linear::coordinate_limit)
    return {Error::out_of_range, Argument::steps};
  clip::LinePath path;
  const Status status = clip::line_path(a, b, sink.clip(), path);
  if (path.count == 0) return status;
  const int phase = detail::dash_phase(a, b, path, on, off);
  const int period = on + off;
  if (path.minor_step == 0 && !path.steep) {
    const int first = path.start.x;
    const int end = first + path.count;
    for (int dash = first - phase; dash < end; dash += period) {
      const int x_begin = dash < first ? first : dash;
      const int x_end = dash + on > end ? end : dash + on;
      if (x_begin < x_end) sink.span(path.start.y, x_begin, x_end);
    }
    return {};
  }
  detail::walk(detail::DashCursor(cursor_at(sink, path.start.x, path.start.y), phase, on, period), path);
  return {};
}

}  // namespace intaglio::raster
