// SPDX-License-Identifier: MIT
//
// Filled polygons: any number of contours, holes, self-intersections.
//
// Rule: a pixel belongs to the polygon iff its centre is inside, by even-odd or by non-zero winding, where a
// centre on an edge counts with what lies to its right, and on a horizontal edge with what lies below (the
// top-left rule). So a polygon equals any triangulation of it, pixel by pixel, and each pixel is drawn once.
//
// A scanline fill with an edge table and an active edge table in the caller's workspace (winding_scan.hpp):
// what can't be seen costs neither memory nor rows.
//
// Bit budget: edge.hpp; windings and edge counts are below 2^31. Error: none.
// Textbook: sections 2.5, 2.6.2, 2.6.3, with errata E2 and E3. Worst known inputs: vertices thousands of
// pixels above the window that wrap into it (BangleApps #2661), shared vertices, contours that cross
// themselves.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/contours.hpp>
#include <intaglio/raster/edge.hpp>
#include <intaglio/raster/row_span.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/raster/winding_scan.hpp>
#include <intaglio/status.hpp>

#include <cstdint>
#include <span>

namespace intaglio::raster {

/// One edge in a polygon's workspace: 32 bytes on a 32-bit core. Its content is the business of
/// `fill_polygon`.
class PolygonEdge : private Edge {
 private:
  friend class detail::WindingScan<PolygonEdge>;
  int row_ = 0;                  // first row while it waits
  int end_ = 0;                  // the row after its last, and where it winds
  PolygonEdge* next_ = nullptr;  // in its list
};
static_assert(sizeof(void*) > 4 || sizeof(PolygonEdge) == 32);

namespace detail {

extern template class WindingScan<PolygonEdge>;

/// The spans of a polygon, row by row.
class PolygonScan : public WindingScan<PolygonEdge> {
 public:
  PolygonScan(FillRule rule, const linear::Rect& clip, const std::span<PolygonEdge>& edges) noexcept
      : WindingScan(winding_mask(rule), clip, edges) {}

  /// Takes the polygon in; what a call with an empty workspace needs is `count()`.
  [[nodiscard]] Status prepare(const std::span<const linear::SubPoint>& vertices,
                               const std::span<const int>& contour_lengths) noexcept;
};

}  // namespace detail

/// How many `PolygonEdge`s `fill_polygon` needs for this polygon under this clip; never more than vertices.
/// Errors: as `fill_polygon`; rectangle (clip outside the domain).
[[nodiscard]] Result<std::uint32_t> polygon_workspace(const std::span<const linear::SubPoint>& vertices,
                                                      const std::span<const int>& contour_lengths,
                                                      const linear::Rect& clip) noexcept;

/// Fills the polygon whose contours are runs of `vertices` (in 1/256 pixel, |c| <= 2^28), one after the
/// other, as long as `contour_lengths` says; each closes by itself. Contours of fewer than three vertices are
/// empty. `workspace` holds the edges that have visible rows, one entry each; as many entries as vertices
/// always do. It need not be initialised, and holds nothing of value afterwards.
/// Errors: vertices (one is outside the domain), contours (lengths that are negative or don't add up to the
/// number of vertices: mismatched), workspace (too small: `needed()` entries), rule; nothing is drawn then.
/// Cost: about 20 instructions a vertex; two divisions and a sort for each visible edge; on each visible row
/// about 45 instructions for each edge that crosses it, and what the sink takes.
template <SpanSink S>
Status fill_polygon(S&& sink, FillRule rule, const std::span<const linear::SubPoint>& vertices,
                    const std::span<const int>& contour_lengths, const std::span<PolygonEdge>& workspace) {
  detail::PolygonScan scan(rule, sink.clip(), workspace);
  const Status status = scan.prepare(vertices, contour_lengths);
  if (!status.ok()) return status;
  for (RowSpan span; scan.next(span);) sink.span(span.y, span.x_begin, span.x_end);
  return {};
}

/// The same with all vertices in one contour.
template <SpanSink S>
Status fill_polygon(S&& sink, FillRule rule, const std::span<const linear::SubPoint>& vertices,
                    const std::span<PolygonEdge>& workspace) {
  const int length = static_cast<int>(vertices.size());
  return fill_polygon(sink, rule, vertices, std::span<const int>(&length, 1), workspace);
}

}  // namespace intaglio::raster
