// SPDX-License-Identifier: MIT
//
// Filled polygons the basic way: the same pixels as `fill_polygon`, with less to remember and more to do.
//
// Rule: on each visible row the crossings with all edges are computed anew, each by exact division, and
// sorted; the spans lie between them (crossings.hpp). An edge has the rows from its upper end on, without
// those from its lower end on, and a level edge none, so a vertex counts once, twice or not at all as it
// must.
//
// Bit budget: edge.hpp. Error: none. Textbook: section 2.6.1, with the rule for vertices of 2.6.2. Worst
// known input: many edges on many rows; each row looks at every edge.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/contours.hpp>
#include <intaglio/raster/crossings.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::raster {

namespace detail {
class BasicScan;
}

/// One crossing of the present row in a workspace: 8 bytes. Its content is the business of
/// `fill_polygon_basic`.
class PolygonCrossing {
 public:
  [[nodiscard]] int x() const noexcept { return x_; }
  [[nodiscard]] int turn() const noexcept { return turn_; }

 private:
  friend class detail::BasicScan;
  int x_ = 0;
  int turn_ = 0;
};

namespace detail {

/// The crossings of a polygon, row by row.
class BasicScan {
 public:
  BasicScan(const linear::Rect& clip, const std::span<PolygonCrossing>& workspace) noexcept
      : workspace_(workspace), clip_(clip) {}
  [[nodiscard]] Status prepare(const std::span<const linear::SubPoint>& vertices,
                               const std::span<const int>& contour_lengths) noexcept;
  /// Goes to the next row; false if there is none.
  [[nodiscard]] bool next_row() noexcept;
  [[nodiscard]] int y() const noexcept { return y_; }
  /// The crossings of the row, sorted.
  [[nodiscard]] std::span<const PolygonCrossing> crossings() const noexcept {
    return workspace_.first(count_);
  }

 private:
  std::span<const linear::SubPoint> vertices_;
  std::span<const int> lengths_;
  std::span<PolygonCrossing> workspace_;
  linear::Rect clip_;
  std::size_t count_ = 0;
  int y_ = 0;
  int y_end_ = 0;
};

}  // namespace detail

/// Fills a polygon; arguments as `fill_polygon`. `workspace` holds the crossings of one row; as many entries
/// as vertices always do.
/// Errors: as `fill_polygon`; `needed()` is the number of edges that have visible rows.
/// Cost: on each visible row about 15 instructions for every edge of the polygon, and two divisions and a
/// place in a sort for each that crosses it.
template <SpanSink S>
Status fill_polygon_basic(S&& sink, FillRule rule, const std::span<const linear::SubPoint>& vertices,
                          const std::span<const int>& contour_lengths,
                          const std::span<PolygonCrossing>& workspace) {
  const int mask = detail::winding_mask(rule);
  if (mask == 0) return {Error::out_of_range, Argument::rule};
  const linear::Rect clip = sink.clip();
  detail::BasicScan scan(clip, workspace);
  const Status status = scan.prepare(vertices, contour_lengths);
  if (!status.ok()) return status;
  while (scan.next_row()) detail::fill_row(sink, clip, mask, scan.y(), scan.crossings());
  return {};
}

}  // namespace intaglio::raster
