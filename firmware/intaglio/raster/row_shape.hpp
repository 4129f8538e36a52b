// SPDX-License-Identifier: MIT
//
// Shapes of one span a row: filling them, and their outlines.
//
// Rule: a filled shape has its row's pixels. Its outline has those of them with a neighbour above, below,
// left or right that isn't in the shape; so every pixel comes once, and shape = outline + inside.
//
// Rows outside the window are never asked for, but the one above and the one below it, for the outline.
//
// Bit budget: coordinates within 2^22: int32. Error: none.
#pragma once

#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/row_span.hpp>
#include <intaglio/raster/sink.hpp>

#include <algorithm>
#include <concepts>

namespace intaglio::raster::detail {

/// Has pixels on the rows top() .. bottom()-1 and an empty span elsewhere. After look_at(x_begin, x_end) rows
/// may end anywhere outside these columns and the two beside them, if they end outside.
template <class S>
concept RowShape = requires(S& s, int y) {
  s.look_at(y, y);
  { s.row(y) } -> std::same_as<RowSpan>;
  { s.top() } -> std::convertible_to<int>;
  { s.bottom() } -> std::convertible_to<int>;
};

/// Draws what is visible of a span.
template <SpanSink S>
void visible_span(S& sink, int y, int begin, int end) {
  const linear::Rect& clip = sink.clip();
  begin = std::max(begin, clip.x);
  end = std::min(end, clip.right());
  if (begin < end) sink.span(y, begin, end);
}

/// Draws what is visible of a span but for a hole in it. The hole may be empty; otherwise it is within.
template <SpanSink S>
void visible_span_around(S& sink, const RowSpan& span, int hole_begin, int hole_end) {
  if (hole_begin >= hole_end) {
    visible_span(sink, span.y, span.x_begin, span.x_end);
    return;
  }
  visible_span(sink, span.y, span.x_begin, hole_begin);
  visible_span(sink, span.y, hole_end, span.x_end);
}

/// Fills a shape.
template <SpanSink S, RowShape Shape>
void fill_rows(S& sink, Shape shape) {
  const linear::Rect& clip = sink.clip();
  if (clip.empty()) return;
  shape.look_at(clip.x, clip.right());
  const int end = std::min(shape.bottom(), clip.bottom());
  for (int y = std::max(shape.top(), clip.y); y < end; ++y) {
    const RowSpan row = shape.row(y);
    visible_span(sink, y, row.x_begin, row.x_end);
  }
}

/// Fills what of a shape isn't in another, which lies within it on every row that it has.
template <SpanSink S, RowShape Shape, RowShape Hole>
void fill_rows_around(S& sink, Shape shape, Hole hole) {
  const linear::Rect& clip = sink.clip();
  if (clip.empty()) return;
  shape.look_at(clip.x, clip.right());
  hole.look_at(clip.x, clip.right());
  const int end = std::min(shape.bottom(), clip.bottom());
  for (int y = std::max(shape.top(), clip.y); y < end; ++y) {
    const RowSpan without = hole.row(y);
    visible_span_around(sink, shape.row(y), without.x_begin, without.x_end);
  }
}

/// Draws a shape's outline.
template <SpanSink S, RowShape Shape>
void outline_rows(S& sink, Shape shape) {
  const linear::Rect& clip = sink.clip();
  if (clip.empty()) return;
  int y = std::max(shape.top(), clip.y);
  const int end = std::min(shape.bottom(), clip.bottom());
  if (y >= end) return;
  shape.look_at(clip.x, clip.right());
  RowSpan above = shape.row(y - 1);
  RowSpan row = shape.row(y);
  for (; y < end; ++y) {
    const RowSpan below = shape.row(y + 1);
    visible_span_around(sink, row, std::max({row.x_begin + 1, above.x_begin, below.x_begin}),
                        std::min({row.x_end - 1, above.x_end, below.x_end}));
    above = row;
    row = below;
  }
}

}  // namespace intaglio::raster::detail
