// SPDX-License-Identifier: MIT
//
// Filled polygons from their critical points: the same pixels as `fill_polygon`, without a table of edges.
//
// Rule: at a local minimum of y (one vertex, or a plateau of several) two chains of edges begin, one along
// the contour and one against it, and each goes down to a local maximum. The chains are the workspace: those
// that haven't begun, sorted by first row, and those that cross the present row, sorted by x. Where an edge
// ends its chain goes on with the next one that has rows; level edges have none. The spans lie between the
// chains (crossings.hpp).
//
// Bit budget: edge.hpp. Error: none. Textbook: section 2.6.4; plateaus, and several minima on one row, are
// where it takes care. Worst known input: a comb, whose every other vertex is a minimum, and which needs as
// many entries here as an edge table does.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/contours.hpp>
#include <intaglio/raster/crossings.hpp>
#include <intaglio/raster/edge.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::raster {

namespace detail {
class CriticalScan;
}

/// One chain of edges in a workspace: 44 bytes. Its content is the business of `fill_polygon_critical`.
class PolygonChain {
 public:
  [[nodiscard]] int x() const noexcept { return edge_.x(); }
  [[nodiscard]] int turn() const noexcept { return direction_; }

 private:
  friend class detail::CriticalScan;
  Edge edge_;          // the edge of the present row, or of the first while it waits
  int row_ = 0;        // the first row of the chain that is visible
  int end_ = 0;        // the row after the edge's last
  int vertex_ = 0;     // the lower end of the edge
  int direction_ = 0;  // 1: along the contour, -1: against it
  int first_ = 0;      // the contour's vertices: first_ .. last_
  int last_ = 0;
};
static_assert(sizeof(PolygonChain) == 44);

namespace detail {

/// The chains of a polygon, row by row.
class CriticalScan {
 public:
  CriticalScan(const linear::Rect& clip, const std::span<PolygonChain>& workspace) noexcept
      : chains_(workspace), clip_(clip) {}
  [[nodiscard]] Status prepare(const std::span<const linear::SubPoint>& vertices,
                               const std::span<const int>& contour_lengths) noexcept;
  /// Goes to the next row; false if there is none.
  [[nodiscard]] bool next_row() noexcept;
  [[nodiscard]] int y() const noexcept { return y_; }
  /// The chains that cross the row, sorted.
  [[nodiscard]] std::span<const PolygonChain> crossings() const noexcept { return chains_.first(active_); }

 private:
  void add_contour(int first, int last) noexcept;
  void add_chain(int vertex, int direction, int first, int last) noexcept;
  [[nodiscard]] bool go_on(PolygonChain& chain, int row) const noexcept;
  [[nodiscard]] const linear::SubPoint& at(int vertex) const noexcept {
    return vertices_[static_cast<std::size_t>(vertex)];
  }

  std::span<const linear::SubPoint> vertices_;
  std::span<PolygonChain> chains_;  // those that cross the row, a gap, those that wait
  linear::Rect clip_;
  std::size_t active_ = 0;
  std::size_t waiting_ = 0;  // the first of them
  std::size_t count_ = 0;
  int y_ = 0;
};

}  // namespace detail

/// Fills a polygon; arguments as `fill_polygon`. `workspace` holds two entries for each local minimum of y,
/// those that have no visible rows left out; as many entries as vertices always do.
/// Errors: as `fill_polygon`.
/// Cost: about 20 instructions a vertex and a sort of the minima; two divisions for each edge that has
/// visible rows; on each visible row about 60 instructions for each edge that crosses it.
template <SpanSink S>
Status fill_polygon_critical(S&& sink, FillRule rule, const std::span<const linear::SubPoint>& vertices,
                             const std::span<const int>& contour_lengths,
                             const std::span<PolygonChain>& workspace) {
  const int mask = detail::winding_mask(rule);
  if (mask == 0) return {Error::out_of_range, Argument::rule};
  const linear::Rect clip = sink.clip();
  detail::CriticalScan scan(clip, workspace);
  const Status status = scan.prepare(vertices, contour_lengths);
  if (!status.ok()) return status;
  while (scan.next_row()) detail::fill_row(sink, clip, mask, scan.y(), scan.crossings());
  return {};
}

}  // namespace intaglio::raster
