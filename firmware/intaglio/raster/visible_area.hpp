// SPDX-License-Identifier: MIT
//
// Catmull's ideal: the visible area of each polygon of a set, front first.
//
// Rule: in each pixel a polygon has the area of its inside, by its own fill rule, that no polygon in front of
// it covers. Polygons may cross themselves and each other, touch, share edges, and be as many as one likes.
// Levels add up as layer_sink.hpp says. This is the ideal that other ways are measured against; it is exact
// and slow.
//
// How: a pixel is cut into slabs at every end of an edge, and where an edge crosses another or a side of the
// pixel. Within a slab edges keep their order, so what is visible between two of them is one polygon, and its
// area is the width in the slab's middle times the height.
//
// What is exact: the order of edges and who is in front; heights; ends of edges. What is rounded: the x of an
// edge at a height, down to 2^-24 pixel, from the edge itself and the same for all polygons that share it;
// and the height of a crossing, to 2^-24 pixel. Error bound: with n edges through the pixel's rows, less than
// (n + n^2) * 2^-24 of the pixel's area for each area and for all sums of areas, and the rounding to levels:
// less than 1 level and (n + n^2) * 2^-15. What polygons add for a shared edge cancels to the last bit.
//
// Bit budget: places have 46 bits (16 beyond the 1/256 pixel); an edge's x is a quotient of 75 bits by 30
// (mul_div.hpp); widths are clipped to the pixel: a width of 26 bits (twice the middle) times a height of 25
// gives areas in 2^-49 pixel. Textbook: section 2.8.1, Catmull. Worst known inputs: many crossings in one
// pixel; edges almost on each other.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/contours.hpp>
#include <intaglio/raster/layer_sink.hpp>
#include <intaglio/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::raster {

/// One polygon of a set, given as to `fill_polygon`.
struct DepthPolygon {
  FillRule rule = FillRule::even_odd;
  std::span<const linear::SubPoint> vertices;
  std::span<const int> contour_lengths;
};

namespace detail {
class VisibleScan;
}

/// One edge or polygon in the workspace: 56 bytes. Its content is the business of `cover_front_to_back`.
class VisibleEntry {
 private:
  friend class detail::VisibleScan;
  linear::SubPoint top_;
  linear::SubPoint bottom_;
  int layer_ = 0;
  int turn_ = 0;          // 1 downwards, -1 upwards; of a polygon: the winding of the place at hand
  int first_column_ = 0;  // columns that the edge touches on this row
  int last_column_ = 0;
  std::int64_t x_ = 0;            // where the slab begins, in 2^-24 pixel
  std::int64_t sum_or_area_ = 0;  // twice the x in the slab's middle; of a polygon: its area
};

namespace detail {

/// The visible areas, run by run.
class VisibleScan {
 public:
  VisibleScan(const linear::Rect& clip, const std::span<const DepthPolygon>& polygons,
              const std::span<VisibleEntry>& workspace) noexcept
      : clip_(clip), polygons_(polygons), entries_(workspace) {}

  [[nodiscard]] Status prepare() noexcept;
  /// Goes to the next pixels that look alike; false if there are none.
  [[nodiscard]] bool next(CoverageSpan& span) noexcept;
  /// How much of the pixels' area is taken by a layer and those in front of it, in levels.
  [[nodiscard]] int level_up_to(int layer) const noexcept;

 private:
  void start_row() noexcept;
  void add_edge(int layer, const linear::SubPoint& from, const linear::SubPoint& to) noexcept;
  void measure(int column) noexcept;
  [[nodiscard]] std::int64_t slab_end(std::int64_t begin, std::int64_t left) noexcept;
  void add_slab(std::int64_t begin, std::int64_t end, std::int64_t left) noexcept;
  [[nodiscard]] int front() const noexcept;

  linear::Rect clip_;
  std::span<const DepthPolygon> polygons_;
  std::span<VisibleEntry> entries_;  // first the polygons, then the edges
  std::span<VisibleEntry> layers_;
  std::span<VisibleEntry> edges_;   // of the row
  std::span<VisibleEntry> active_;  // of the slab: the first of the edges
  int x_ = 0;
  int y_ = 0;
};

}  // namespace detail

/// Hands over what is visible of each polygon of a set, front first; at most 2^16 polygons of 2^20 vertices
/// in all. `workspace` needs an entry for each vertex and one for each polygon. Errors: vertices, contours,
/// rule (as `fill_polygon`, of any polygon), count (too many polygons), vertices (too_large: too many),
/// workspace (too small: `needed()` entries); nothing is handed over then. Cost: on each row a look at each
/// edge, and for each pixel that edges touch a few thousand instructions a slab and edge: for measuring, not
/// for shows.
template <LayerSink S>
Status cover_front_to_back(S&& sink, const std::span<const DepthPolygon>& polygons,
                           const std::span<VisibleEntry>& workspace) {
  detail::VisibleScan scan(sink.clip(), polygons, workspace);
  const Status status = scan.prepare();
  if (!status.ok()) return status;
  const int layers = static_cast<int>(polygons.size());
  for (detail::CoverageSpan span; scan.next(span);) {
    int before = 0;
    for (int layer = 0; layer < layers; ++layer) {
      const int here = scan.level_up_to(layer);
      if (here != before) sink.span(layer, span.y, span.x_begin, span.x_end, here - before);
      before = here;
    }
  }
  return {};
}

}  // namespace intaglio::raster
