// SPDX-License-Identifier: MIT
//
// Lines one pixel wide between two pixels, or between two points in 1/256 pixel.
//
// Rule (DESIGN.md, "Line"): on the major axis, from the end with the smaller major coordinate, the nearest
// pixel of each column (row, if steep), ties towards the larger coordinate; both ends drawn; AB = BA.
// `clip/line_path.hpp` finds the visible steps by the closed formula; here they are walked with a running
// error, which repeats the formula without a division.
// Bit budget: |error| <= 2^22, 2^29 with sub-pixel ends. Cost: see tests/target/speed_baseline.csv; work is
// bounded by the visible pixels, wherever the ends lie.
#pragma once

#include <intaglio/clip/line_path.hpp>
#include <intaglio/raster/cursor.hpp>
#include <intaglio/status.hpp>

#include <concepts>
#include <type_traits>

namespace intaglio::raster {

namespace detail {

/// Keeps compilers from executing what follows under conditions, pixel for pixel, where a jump skips it.
[[gnu::always_inline]] constexpr void stay_a_branch() noexcept {
  if (!std::is_constant_evaluated()) asm volatile("");
}

/// Walks to the right and, along y, down.
template <bool steep, class Cursor>
constexpr void walk(Cursor cursor, const clip::LinePath& path) {
  const int minor_step = path.minor_step;
  const int major_step = path.major_step;
  int error = path.error;
  for (int steps = path.count - 1; steps != 0; --steps) {
    cursor.put();
    if constexpr (steep)
      cursor.down();
    else
      cursor.right();
    error += minor_step;
    if (error < 0) continue;
    stay_a_branch();
    error -= major_step;
    if constexpr (steep)
      cursor.right();
    else
      cursor.down();
  }
  cursor.put();
}

/// Walks the path with a cursor on its start.
template <class Cursor>
constexpr void walk(Cursor cursor, const clip::LinePath& path) {
  if (path.up) cursor.turn_over();
  if (path.steep)
    walk<true>(cursor, path);
  else
    walk<false>(cursor, path);
}

template <class S>
constexpr void draw_path(S& sink, const clip::LinePath& path) {
  if (path.minor_step == 0 && !path.steep)
    sink.span(path.start.y, path.start.x, path.start.x + path.count);
  else
    walk(cursor_at(sink, path.start.x, path.start.y), path);
}

}  // namespace detail

/// Draws the line from `a` to `b`, both ends included. Errors: out_of_domain point.
template <SpanSink S>
constexpr Status draw_line(S&& sink, linear::Point a, linear::Point b) {
  clip::LinePath path;
  const Status status = clip::line_path(a, b, sink.clip(), path);
  if (path.count == 0) return status;
  detail::draw_path(sink, path);
  return {};
}

/// The same with ends in 1/256 pixel: each column (row, if steep) from that nearest to one end to that
/// nearest to the other, ties to the larger, both included, gets its pixel nearest to the line through the
/// ends. On whole pixels the same as above. Errors: out_of_domain point. (A template of the points, so that
/// {x, y} goes on meaning pixels.)
template <SpanSink S, std::same_as<linear::SubPoint> P>
constexpr Status draw_line(S&& sink, P a, P b) {
  clip::LinePath path;
  const Status status = clip::line_path(a, b, sink.clip(), path);
  if (path.count == 0) return status;
  detail::draw_path(sink, path);
  return {};
}

}  // namespace intaglio::raster
