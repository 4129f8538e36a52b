// SPDX-License-Identifier: MIT
//
// Convex polygons with smooth edges at the price of Bresenham's line: Pitteway and Watkinson.
//
// Rule: for an edge with the longer difference M the error term of Bresenham's line at a pixel's centre is
// e = E / (256 * M), the distance from the edge along its minor axis, in pixels (E: edge_function.hpp). The
// edge leaves clamp(1/2 + e) of the pixel covered, in levels of 0 to 255, and takes the rest away. So each
// step along an edge has one pixel between full and nothing, the one that the line would draw, and its level
// is the error term that the line has at hand anyway. Where several edges touch a pixel, it loses what the
// edge takes that takes most, and the most that one that runs the other way (across a thin polygon, or beyond
// a sharp corner) takes.
//
// An edge that two polygons share takes levels that add up to exactly 255 from the two (a tie goes to the
// side that owns pixel centres on the edge). Corners are those of the sides' lines.
//
// Error bound: in a pixel that one edge crosses, with the slope m <= 1 to its major axis, at most m/8 of the
// pixel and 1/2 level from its area, that is 32.4 levels, where the edge leaves the pixel through the sides
// that the one pixel a step ignores; 0.5 for edges along rows and columns. In pixels with a corner it is at
// most 72 levels (held by a test on triangles and regular polygons, not proven).
//
// Bit budget: |E| < 2^60; a pixel on the edge has |E| < 128*M < 2^36, times 255: 2^44; its low 8 bits are
// dropped before it is divided by M, which changes no floor. Textbook: section 2.8.1. Worst known inputs:
// edges at 45 degrees, sharp corners.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::raster {

namespace detail {

/// The levels of a convex polygon, row by row.
class PittewayScan {
 public:
  explicit PittewayScan(const linear::Rect& clip) noexcept : box_(clip) {}
  [[nodiscard]] Status prepare(const std::span<const linear::SubPoint>& vertices) noexcept;
  /// Puts the next span in `span`; false if there is none.
  [[nodiscard]] bool next(CoverageSpan& span) noexcept;

 private:
  /// A side of the polygon, the inside to its right.
  struct Side {
    linear::SubPoint from;
    int dx;
    int dy;
    /// E at the centre of a pixel.
    [[nodiscard]] std::int64_t at(int x, int y) const noexcept;
    /// The longer difference.
    [[nodiscard]] int major() const noexcept;
  };

  template <class Function>
  void each_side(Function function) const;
  void start_row() noexcept;
  [[nodiscard]] int level(int x) const noexcept;

  std::span<const linear::SubPoint> vertices_;
  linear::Rect box_;        // the clip, then what is visible of the pixels that the polygon may touch
  std::size_t corner_ = 0;  // the first vertex of a side whose predecessor isn't on the same line
  bool clockwise_ = true;
  int y_ = 0;
  int x_ = 0;      // next pixel of row y_
  int x_end_ = 0;  // from here on nothing is covered
  int full_begin_ = 0;
  int full_end_ = 0;
};

}  // namespace detail

/// Hands the levels of a convex polygon over (in 1/256 pixel, |c| <= 2^28, either way around).
/// Errors: vertices (one is outside the domain; or malformed: not convex); nothing is handed over then.
/// Cost: on each visible row two binary searches for each edge that isn't wholly beside the visible columns;
/// a multiplication for each edge, and a short division for each that touches it, on pixels between nothing
/// and full.
template <CoverageSink S>
Status fill_convex_pitteway(S&& sink, const std::span<const linear::SubPoint>& vertices) {
  detail::PittewayScan scan(sink.clip());
  const Status status = scan.prepare(vertices);
  if (!status.ok()) return status;
  for (detail::CoverageSpan span; scan.next(span);)
    sink.span(span.y, span.x_begin, span.x_end, span.coverage);
  return {};
}

}  // namespace intaglio::raster
