// SPDX-License-Identifier: MIT
//
// Clipping to a polygon: a sink that lets through to another what lies inside.
//
// Rule: a pixel is inside iff `fill_polygon` would draw it, by the same fill rule and with any number of
// contours. Whatever is drawn through a `PolygonClipped` sink is what would be drawn without it, restricted
// to these pixels; a pixel that came once comes once. The clip of the sink behind it goes on to hold, and
// that may be the top of a `clip::ClipStack`, or of another `PolygonClipped`: polygons can be nested, too.
//
// Primitives send their rows in any order, so the polygon's spans are computed once, by the scan of
// `polygon.hpp`, and kept in the caller's memory, sorted by row and column. A span that is to be drawn finds
// the first of them that it can meet by bisection, and then meets its neighbours. A cursor remembers the one
// it was in last.
//
// Bit budget: polygon.hpp. Error: none. Memory: 12 bytes for each span of the polygon (one a row if it is
// convex), and while it is made 32 bytes for each edge. Textbook: section 2.9, for any primitive; the point
// of section 2.9.1 is in or out by section 2.5. Worst known inputs: combs, whose every row has many spans;
// shared vertices and edges.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/cursor.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/row_span.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

#include <algorithm>
#include <span>

namespace intaglio::raster {

/// The pixels of a polygon, for many primitives. A view: the spans lie in the caller's memory.
class PolygonClip {
 public:
  /// No pixel.
  PolygonClip() noexcept = default;

  /// The pixels of the polygon inside `area`, which is as large as anything that will be drawn: a surface's
  /// bounds or a sink's clip. The polygon is given as to `fill_polygon`. `edges` is needed only during the
  /// call, `spans` as long as the clip is used.
  /// Errors: rectangle (`area` is outside the domain); vertices, contours, rule and too_small workspace (the
  /// edges), as `fill_polygon`; too_small table (the spans: `needed()` entries).
  /// Cost: as `fill_polygon`; a span is stored instead of drawn.
  [[nodiscard]] static Result<PolygonClip> over(FillRule rule,
                                                const std::span<const linear::SubPoint>& vertices,
                                                const std::span<const int>& contour_lengths,
                                                const linear::Rect& area, const std::span<PolygonEdge>& edges,
                                                const std::span<RowSpan>& spans) noexcept;

  /// The smallest rectangle that holds all its pixels.
  [[nodiscard]] constexpr const linear::Rect& bounds() const noexcept { return bounds_; }
  /// Its spans, row by row and from left to right.
  [[nodiscard]] constexpr std::span<const RowSpan> spans() const noexcept { return spans_; }

  /// The first span that ends right of the pixel, on its row or on a later one; the end if there is none.
  /// Cost: one step for each doubling of the number of spans.
  [[nodiscard]] const RowSpan* span_from(int x, int y) const noexcept;
  /// One past the last span.
  [[nodiscard]] constexpr const RowSpan* end() const noexcept { return spans_.data() + spans_.size(); }

 private:
  std::span<const RowSpan> spans_;
  linear::Rect bounds_{};
};

namespace detail {

/// A cursor that puts the pixels inside.
template <PixelCursor Cursor>
class PolygonClippedCursor {
 public:
  PolygonClippedCursor(const Cursor& cursor, const PolygonClip& polygon, int x, int y) noexcept
      : cursor_(cursor), polygon_(&polygon), here_(polygon.end()), x_(x), y_(y) {}
  void put() {
    if (!is_inside()) here_ = polygon_->span_from(x_, y_);
    if (is_inside()) cursor_.put();
  }
  void left() { --x_, cursor_.left(); }
  void right() { ++x_, cursor_.right(); }
  void up() { y_ -= down_, cursor_.up(); }
  void down() { y_ += down_, cursor_.down(); }
  void turn_over() { down_ = -down_, cursor_.turn_over(); }

 private:
  [[nodiscard]] bool is_inside() const noexcept {
    return here_ != polygon_->end() && here_->y == y_ && here_->x_begin <= x_ && x_ < here_->x_end;
  }

  Cursor cursor_;
  const PolygonClip* polygon_;
  const RowSpan* here_;
  int x_;
  int y_;
  int down_ = 1;
};

}  // namespace detail

/// Draws through another sink the pixels inside a polygon. Sinks whose spans carry a value (levels of
/// coverage) get it unchanged. Sink and polygon must outlive it.
template <class S>
class PolygonClipped {
 public:
  constexpr PolygonClipped(S& sink, const PolygonClip& polygon) noexcept
      : sink_(&sink), polygon_(&polygon), clip_(linear::intersect(sink.clip(), polygon.bounds())) {}

  /// What the sink behind and the polygon's bounds have in common.
  [[nodiscard]] constexpr const linear::Rect& clip() const noexcept { return clip_; }

  /// Cost: a bisection, and a span of the sink behind for each of the polygon that this one meets.
  template <class... Value>
  void span(int y, int x_begin, int x_end, Value... value) const {
    for (const RowSpan* part = polygon_->span_from(x_begin, y);
         part != polygon_->end() && part->y == y && part->x_begin < x_end; ++part)
      sink_->span(y, std::max(part->x_begin, x_begin), std::min(part->x_end, x_end), value...);
  }

  /// Stands on a pixel inside the clip.
  [[nodiscard]] auto cursor(int x, int y) const requires SpanSink<S> {
    return detail::PolygonClippedCursor(cursor_at(*sink_, x, y), *polygon_, x, y);
  }

 private:
  S* sink_;
  const PolygonClip* polygon_;
  linear::Rect clip_;
};

}  // namespace intaglio::raster
