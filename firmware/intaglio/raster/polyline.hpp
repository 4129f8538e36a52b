// SPDX-License-Identifier: MIT
//
// Polylines of true width: strokes with joins and caps, each pixel once.
//
// Rule (DESIGN.md, "Thick line"): the stroke is the union of
// - each segment's parallelogram, as of thick_line.hpp with butt ends;
// - at each vertex where the direction changes, a join: with v the vertex and A and B the ends there of the
// two
//   segments' outer sides, the triangle v A B (bevel); the triangles v A M and v M B (miter), M being where
//   the outer sides, exactly parallel to their segments, meet if continued, rounded to 1/256 pixel; or the
//   disc (round). Where the way turns straight back, only a round join adds anything;
// - caps at the two ends of an open stroke: none (butt), the end moved out by half the width along its
// segment
//   (square), or the disc (round).
// Triangles and parallelograms own pixels by the top-left rule, discs as of disc_edge.hpp. A pixel belongs to
// the stroke iff it belongs to a piece; it is drawn once. A miter becomes a bevel if |M - v| is more than the
// limit times half the width (after rounding), or M isn't beyond both ends (which happens by rounding alone).
// Repeated points count once; a stroke that has a single point, open or closed, has only its caps, the square
// one upright. From the last vertex to the first a polyline has the same pixels.
//
// How: all pieces wind the same way, so their union is what winds at least once: one scan (winding_scan.hpp)
// over the edges of all visible pieces in the caller's workspace.
//
// Bit budget: products of differences have 60 bits, M is a ratio of a product of 90 and one of 60
// (mul_div.hpp); the limit compares 80 bits. Error: none but the rounding of the corners and of M to 1/256
// pixel. Textbook: none; beside section 2.3.3. Worst known inputs: a turn next to 180 degrees (the miter is
// far away), a turn of less than the rounding (outer sides that meet behind their ends), repeated points,
// joins that overlap segments shorter than the width.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/disc_edge.hpp>
#include <intaglio/raster/row_span.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/raster/stroke.hpp>
#include <intaglio/raster/winding_scan.hpp>
#include <intaglio/status.hpp>

#include <cstdint>
#include <span>

namespace intaglio::raster {

namespace detail {
class StrokeScan;
}

/// One edge in a stroke's workspace: 36 bytes on a 32-bit core. Its content is the business of
/// `draw_polyline`.
class StrokeEdge {
 private:
  friend class detail::WindingScan<StrokeEdge>;
  friend class detail::StrokeScan;

  /// Becomes a straight edge, as of `Edge::start`.
  void start(const linear::SubPoint& top, const linear::SubPoint& bottom, int row) noexcept {
    round_ = false;
    shape_.line.start(top, bottom, row);
  }
  /// Becomes a side of a disc, as of `DiscEdge::start`.
  void start(linear::SubPoint centre, int diameter, bool right, int row) noexcept {
    round_ = true;
    shape_.disc.start(centre, diameter, right, row);
  }
  [[nodiscard]] int x() const noexcept { return round_ ? shape_.disc.x() : shape_.line.x(); }
  void next() noexcept { round_ ? shape_.disc.next() : shape_.line.next(); }

  union Shape {
    Edge line;
    DiscEdge disc;
  } shape_;
  bool round_ = false;  // which of them it is
  int row_ = 0;
  int end_ = 0;
  StrokeEdge* next_ = nullptr;
};
static_assert(sizeof(void*) > 4 || sizeof(StrokeEdge) == 36);

namespace detail {

/// What a line with round caps needs: four sides, and two of each disc.
inline constexpr int round_line_edges = 8;

extern template class WindingScan<StrokeEdge>;

/// The spans of a stroke, row by row.
class StrokeScan : public WindingScan<StrokeEdge> {
 public:
  /// A clip without columns gets no rows: nothing is visible then, and no edge needs an entry.
  StrokeScan(const linear::Rect& clip, const std::span<StrokeEdge>& edges) noexcept
      : WindingScan(-1, clip.empty() ? linear::Rect{} : clip, edges) {}

  /// Takes the stroke in; what a call with an empty workspace needs is `count()`.
  [[nodiscard]] Status prepare(const std::span<const linear::SubPoint>& points,
                               const Stroke& stroke) noexcept;

 private:
  struct Segment;

  [[nodiscard]] bool add_segment(const Segment& segment) noexcept;
  [[nodiscard]] bool add_join(const Segment& from, const Segment& to, const Stroke& stroke) noexcept;
  void add_triangle(linear::SubPoint a, linear::SubPoint b, linear::SubPoint c) noexcept;
  void add_disc(linear::SubPoint centre, int diameter) noexcept;
  [[nodiscard]] bool add_point(linear::SubPoint point, const Stroke& stroke) noexcept;
  [[nodiscard]] bool add_segments(const std::span<const linear::SubPoint>& points,
                                  const Stroke& stroke) noexcept;
};

}  // namespace detail

/// How many `StrokeEdge`s `draw_polyline` needs for this stroke under this clip: at most 4 a segment, 3 a
/// bevel, 6 a miter and 2 a disc. Errors: as `draw_polyline`; rectangle (clip outside the domain).
[[nodiscard]] Result<std::uint32_t> polyline_workspace(const std::span<const linear::SubPoint>& points,
                                                       const Stroke& stroke,
                                                       const linear::Rect& clip) noexcept;

/// Draws the stroke along the points (in 1/256 pixel, |c| <= 2^28). `workspace` holds the edges that have
/// visible rows, one entry each (`polyline_workspace` tells); it need not be initialised, and holds nothing
/// of value afterwards. Errors: out_of_domain vertices (a point, a corner of a segment or a tip of a miter),
/// out_of_domain width, out_of_range rule (`join`, `cap`) or limit, too_small workspace (`needed()` entries);
/// nothing is drawn then. Cost: a square root and two divisions a segment, two long divisions a miter, then
/// that of a polygon of all pieces' edges; each visible row of a disc takes two square roots.
template <SpanSink S>
Status draw_polyline(S&& sink, const std::span<const linear::SubPoint>& points, const Stroke& stroke,
                     const std::span<StrokeEdge>& workspace) {
  detail::StrokeScan scan(sink.clip(), workspace);
  const Status status = scan.prepare(points, stroke);
  if (!status.ok()) return status;
  for (RowSpan span; scan.next(span);) sink.span(span.y, span.x_begin, span.x_end);
  return {};
}

}  // namespace intaglio::raster
