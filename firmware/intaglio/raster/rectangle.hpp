// SPDX-License-Identifier: MIT
//
// Rectangles with sides along the axes, filled or as an outline one pixel wide, and their degenerate kin:
// rows and columns of pixels.
//
// Rule: a rectangle is the pixels of a `linear::Rect`, half-open; an outline is those of them that have a
// neighbour outside it, each drawn once, so an outline of one row or column is that row or column. A width or
// height of zero or less is no pixel, and no error.
// Bit budget: corner within 2^20, extent within 2^21, so every sum stays below 2^22.
#pragma once

#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/cursor.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

namespace intaglio::raster {

namespace detail {

/// The part of `begin .. begin+length-1` between two clip edges.
struct Interval {
  int begin;
  int end;
  constexpr Interval(int first, int length, int clip_begin, int clip_length) noexcept
      : begin(first > clip_begin ? first : clip_begin),
        end(first + length < clip_begin + clip_length ? first + length : clip_begin + clip_length) {}
};

template <SpanSink S>
constexpr void clipped_row(S& sink, int x, int y, int width) {
  const linear::Rect& clip = sink.clip();
  if (static_cast<unsigned>(y - clip.y) >= static_cast<unsigned>(clip.height)) return;
  const Interval columns(x, width, clip.x, clip.width);
  if (columns.begin < columns.end) sink.span(y, columns.begin, columns.end);
}

template <SpanSink S>
constexpr void clipped_column(S& sink, int x, int y, int height) {
  const linear::Rect& clip = sink.clip();
  if (static_cast<unsigned>(x - clip.x) >= static_cast<unsigned>(clip.width)) return;
  const Interval rows(y, height, clip.y, clip.height);
  if (rows.begin >= rows.end) return;
  auto cursor = cursor_at(sink, x, rows.begin);
  for (int left = rows.end - rows.begin;; cursor.down()) {
    cursor.put();
    if (--left == 0) return;
  }
}

}  // namespace detail

/// Draws the pixels (start.x .. start.x+width-1, start.y). Errors: out_of_domain point, width (above 2^21).
template <SpanSink S>
constexpr Status draw_horizontal(S&& sink, linear::Point start, int width) {
  // Inside the clip, and so inside the domain: nothing to cut and nothing else to check.
  const linear::Rect& clip = sink.clip();
  const unsigned column = static_cast<unsigned>(start.x) - static_cast<unsigned>(clip.x);
  const auto columns = static_cast<unsigned>(clip.width);
  if (in_clip(clip, start) && static_cast<unsigned>(width) - 1U < columns - column) {
    sink.span(start.y, start.x, start.x + width);
    return {};
  }
  if (!linear::in_domain(start)) return {Error::out_of_domain, Argument::point};
  if (!linear::length_in_domain(width)) return {Error::out_of_domain, Argument::width};
  detail::clipped_row(sink, start.x, start.y, width);
  return {};
}

/// Draws the pixels (start.x, start.y .. start.y+height-1). Errors: out_of_domain point, height (above 2^21).
template <SpanSink S>
constexpr Status draw_vertical(S&& sink, linear::Point start, int height) {
  if (!linear::in_domain(start)) return {Error::out_of_domain, Argument::point};
  if (!linear::length_in_domain(height)) return {Error::out_of_domain, Argument::height};
  detail::clipped_column(sink, start.x, start.y, height);
  return {};
}

/// Draws all pixels of a rectangle. Errors: out_of_domain rectangle.
template <SpanSink S>
constexpr Status fill_rect(S&& sink, const linear::Rect& r) {
  if (!linear::in_domain(r)) return {Error::out_of_domain, Argument::rectangle};
  const linear::Rect& clip = sink.clip();
  const detail::Interval columns(r.x, r.width, clip.x, clip.width);
  const detail::Interval rows(r.y, r.height, clip.y, clip.height);
  if (columns.begin >= columns.end || rows.begin >= rows.end) return {};
  if constexpr (BlockSink<S>) {
    sink.block({columns.begin, rows.begin, columns.end - columns.begin, rows.end - rows.begin});
  } else {
    for (int y = rows.begin; y < rows.end; ++y) sink.span(y, columns.begin, columns.end);
  }
  return {};
}

/// Draws the outermost pixels of a rectangle. Errors: out_of_domain rectangle.
template <SpanSink S>
constexpr Status draw_rect(S&& sink, const linear::Rect& r) {
  if (!linear::in_domain(r)) return {Error::out_of_domain, Argument::rectangle};
  if (r.empty()) return {};
  detail::clipped_row(sink, r.x, r.y, r.width);
  if (r.height > 1) detail::clipped_row(sink, r.x, r.bottom() - 1, r.width);
  detail::clipped_column(sink, r.x, r.y + 1, r.height - 2);
  if (r.width > 1) detail::clipped_column(sink, r.right() - 1, r.y + 1, r.height - 2);
  return {};
}

}  // namespace intaglio::raster
