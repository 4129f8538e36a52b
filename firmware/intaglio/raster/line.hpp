// SPDX-License-Identifier: MIT
//
// Lines one pixel wide between two pixels.
//
// Rule (DESIGN.md, "Line"): on the major axis, from the end with the smaller major coordinate, the nearest
// pixel of each column (row, if steep), ties towards the larger coordinate; both ends drawn; AB = BA.
// `clip/line_path.hpp` finds the visible steps by the closed formula; here they are walked with a running
// error, which repeats the formula without a division.
// Bit budget: |error| <= 2^22. Cost: see tests/target/speed_baseline.csv; work is bounded by the visible
// pixels, wherever the ends lie.
#pragma once

#include <intaglio/clip/line_path.hpp>
#include <intaglio/raster/cursor.hpp>
#include <intaglio/status.hpp>

namespace intaglio::raster {

namespace detail {

/// Walks to the right and, along y, down.
template <bool steep, class Cursor>
constexpr void walk(Cursor cursor, const clip::LinePath& path) {
  const int minor_step = path.minor_step;
  const int major_step = path.major_step;
  int error = path.error;
  int left = path.count;
  while (true) {
    cursor.put();
    if (--left == 0) return;
    error += minor_step;
    if constexpr (steep)
      cursor.down();
    else
      cursor.right();
    if (error >= 0) {
      error -= major_step;
      if constexpr (steep)
        cursor.right();
      else
        cursor.down();
    }
  }
}

}  // namespace detail

/// Draws the line from `a` to `b`, both ends included. Errors: out_of_domain point.
template <SpanSink S>
constexpr Status draw_line(S&& sink, linear::Point a, linear::Point b) {
  clip::LinePath path;
  const Status status = clip::line_path(a, b, sink.clip(), path);
  if (path.count == 0) return status;
  if (path.minor_step == 0 && !path.steep) {
    sink.span(path.start.y, path.start.x, path.start.x + path.count);
    return {};
  }
  auto cursor = cursor_at(sink, path.start.x, path.start.y);
  if (path.up) cursor.turn_over();
  if (path.steep)
    detail::walk<true>(cursor, path);
  else
    detail::walk<false>(cursor, path);
  return {};
}

}  // namespace intaglio::raster
