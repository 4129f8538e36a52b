// SPDX-License-Identifier: MIT
//
// Convex polygons by edge functions: no edge table, no workspace, the same pixels as `fill_polygon`.
//
// Rule: a pixel belongs to the polygon iff all edge functions own its centre (edge_function.hpp). On each
// visible row of the bounding box an edge that has the inside to its right moves the left end of what remains
// inwards until it owns it, one that has it to its left the right end.
//
// Bit budget: edge_function.hpp, int64 throughout; the turns of the convexity test are products of 30-bit
// differences. Error: none. Textbook: exercise of section 2.6 on `convex1`. Worst known input: a thin
// diagonal sliver; each row steps over the rest of the bounding box.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/row_span.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

#include <span>

namespace intaglio::raster {

/// True if the contour turns one way only, and once around (either way). Repeated vertices and collinear runs
/// are allowed. All vertices must be in the domain.
[[nodiscard]] bool is_convex(const std::span<const linear::SubPoint>& vertices) noexcept;

namespace detail {

/// What `turning` says of a contour that turns both ways or goes around more than once.
inline constexpr int not_convex = 2;
/// Which way a contour turns: 1 clockwise on screen, -1 the other way, 0 no way (no area), or `not_convex`.
[[nodiscard]] int turning(const std::span<const linear::SubPoint>& vertices) noexcept;

/// The spans of a convex polygon, row by row.
class ConvexScan {
 public:
  explicit ConvexScan(const linear::Rect& clip) noexcept : box_(clip) {}
  [[nodiscard]] Status prepare(const std::span<const linear::SubPoint>& vertices) noexcept;
  /// Puts the next span in `span`; false if there is none.
  [[nodiscard]] bool next(RowSpan& span) noexcept;

 private:
  std::span<const linear::SubPoint> vertices_;
  linear::Rect box_;  // the clip, then what is visible of the bounding box
  bool clockwise_ = true;
  int y_ = 0;
};

}  // namespace detail

/// Fills a convex polygon (in 1/256 pixel, |c| <= 2^28), either way around.
/// Errors: vertices (one is outside the domain; or malformed: not convex); nothing is drawn then.
/// Cost: on each visible row about 30 instructions an edge, and about 6 for each pixel of the visible
/// bounding box that is outside.
template <SpanSink S>
Status fill_convex(S&& sink, const std::span<const linear::SubPoint>& vertices) {
  detail::ConvexScan scan(sink.clip());
  const Status status = scan.prepare(vertices);
  if (!status.ok()) return status;
  for (RowSpan span; scan.next(span);) sink.span(span.y, span.x_begin, span.x_end);
  return {};
}

}  // namespace intaglio::raster
