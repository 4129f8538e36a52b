// SPDX-License-Identifier: MIT
//
// How much of each pixel a polygon covers: antialiasing by area.
//
// Rule: the coverage of pixel (x, y) is the integral over its square, [x-1/2, x+1/2) x [y-1/2, y+1/2), of how
// often the contours wind around a place, folded by the fill rule and rounded to the nearest of the levels 0
// to 255. Folding takes an integral w to min(|w|, 1) (non-zero) or to its distance from the nearest even
// number (even-odd).
//
// That is the exact area of the polygon in the pixel wherever
// - by even-odd, the windings met inside the pixel are k and k+1 for one k;
// - by non-zero, they are 0 and 1, or 0 and -1, or all positive, or all negative.
// So it is the area in every pixel for simple polygons of either direction, with holes that lie inside (by
// non-zero they must wind the other way) and for any contours that neither cross nor overlap. Where contours
// do cross, only the pixels in which more windings meet than named above differ from the area.
//
// An edge adds, row by row, the signed area right of its piece inside each pixel and, to all pixels further
// right, the height of the piece. A row holds the change of that sum from pixel to pixel, so pixels that no
// edge touches cost one look each. Pieces end where the edge crosses the sides of pixels; each crossing is
// divided out of the edge itself (quotient and remainder), with 16 bits beyond the 1/256 pixel.
//
// Error bound: a crossing is less than 2^-16 of 1/256 pixel off along one axis, so each of the two ends of a
// piece changes the area by less than 2^-24 pixel; rounding the product adds 2^-40. Heights add up exactly,
// so nothing leaks to other pixels. With n edges through (or within a crossing's error of) a pixel, its level
// is off by at most 1/2 + n*2^-15 from 255 times the exact integral. What two polygons add for a shared edge
// cancels to the last bit.
//
// Bit budget: |dx|, |dy| <= 2^29, products below 2^58; a height and a width inside a pixel have 24 bits,
// their product 2^49 (with the 2 of the mean), kept in 1/2^40 pixel: 2^20 edges sum to less than 2^62.
// Textbook: section 2.8.1, Catmull's area for one polygon. Worst known inputs: slivers thousands of pixels
// long and a fraction of a pixel wide, edges along the sides of pixels.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/contours.hpp>
#include <intaglio/raster/coverage_step.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/status.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::raster {

/// The level of a pixel that is covered whole.
inline constexpr int full_coverage = 255;
/// The most vertices that `fill_coverage` takes.
inline constexpr int coverage_vertex_limit = 1 << 20;

/// Takes the pixels (x_begin .. x_end-1, y), all covered to the same level, 1 to 255. `clip()` is as that of
/// a `SpanSink`.
template <class S>
concept CoverageSink = requires(S& s, int y, int x_begin, int x_end, int coverage) {
  s.span(y, x_begin, x_end, coverage);
  { s.clip() } -> std::convertible_to<linear::Rect>;
};

namespace detail {
class CoverageScan;
}

/// One visible column in the workspace: 8 bytes. Its content is the business of `fill_coverage`.
class CoverageCell {
 private:
  friend class detail::CoverageScan;
  std::int64_t change_;  // of the covered area from the column to the left, in 2^-40 pixel
};

namespace detail {

/// Pixels of one row and one level.
struct CoverageSpan {
  int y = 0;
  int x_begin = 0;
  int x_end = 0;
  int coverage = 0;
};

/// The spans of a polygon's coverage, row by row.
class CoverageScan {
 public:
  /// `vertices` and `contour_lengths` must stay while spans are taken.
  CoverageScan(FillRule rule, const linear::Rect& clip, const std::span<const linear::SubPoint>& vertices,
               const std::span<const int>& contour_lengths) noexcept;

  /// Checks the arguments and finds the pixels to look at.
  [[nodiscard]] Status prepare() noexcept;
  /// How many cells it takes: the visible columns of the polygon.
  [[nodiscard]] std::uint32_t count() const noexcept { return static_cast<std::uint32_t>(area_.width); }
  /// Uses these cells. Error: workspace.
  [[nodiscard]] Status use(const std::span<CoverageCell>& cells) noexcept;
  /// Puts the next span in `span`; false if there is none.
  [[nodiscard]] bool next(CoverageSpan& span) noexcept;

 private:
  void add_row() noexcept;
  void add_edge(const linear::SubPoint& from, const linear::SubPoint& to) noexcept;
  void add(int column, std::int64_t change) noexcept;
  [[nodiscard]] int level(std::int64_t area) const noexcept;

  std::span<const linear::SubPoint> vertices_;
  std::span<const int> contour_lengths_;
  CoverageCell* cells_ = nullptr;
  linear::Rect area_;  // the clip; once prepared, the part of it that the polygon's box touches
  FillRule rule_;
  int x_ = 0;  // next column of row y_
  int y_ = 0;
  std::int64_t sum_ = 0;  // covered area of the column before it, in 2^-40 pixel
};

}  // namespace detail

/// How many `CoverageCell`s `fill_coverage` needs for this polygon under this clip: its visible columns,
/// never more than the clip is wide. Errors: as `fill_coverage`; rectangle (clip outside the domain).
[[nodiscard]] Result<std::uint32_t> coverage_workspace(const std::span<const linear::SubPoint>& vertices,
                                                       const std::span<const int>& contour_lengths,
                                                       const linear::Rect& clip) noexcept;

/// Hands the coverage of the polygon over, in spans of one level, each pixel that has a level of 1 or more
/// once. The polygon is given as to `fill_polygon`: contours are runs of `vertices` (in 1/256 pixel, |c| <=
/// 2^28, at most 2^20 of them), as long as `contour_lengths` says; those of fewer than three vertices are
/// empty. `workspace` needs a cell for each column of the clip (or `coverage_workspace`), however many edges
/// there are. It need not be initialised, and holds nothing of value afterwards. The level is at most 1/2 +
/// n*2^-15 from 255 times the exact area, with n edges through the pixel; see the head of this file for
/// polygons that cross themselves. Errors: vertices (one is outside the domain; or too_large, with the
/// limit), contours (mismatched), workspace (too small: `needed()` cells), rule; nothing is handed over then.
/// Cost: on each visible row a look at each edge, four to six divisions for each that crosses the row and two
/// for each pixel it goes on to; a look at each visible column of the polygon's box; and what the sink takes.
template <CoverageSink S>
Status fill_coverage(S&& sink, FillRule rule, const std::span<const linear::SubPoint>& vertices,
                     const std::span<const int>& contour_lengths, const std::span<CoverageCell>& workspace) {
  detail::CoverageScan scan(rule, sink.clip(), vertices, contour_lengths);
  Status status = scan.prepare();
  if (status.ok()) status = scan.use(workspace);
  if (!status.ok()) return status;
  for (detail::CoverageSpan span; scan.next(span);)
    sink.span(span.y, span.x_begin, span.x_end, span.coverage);
  return {};
}

/// The same with all vertices in one contour.
template <CoverageSink S>
Status fill_coverage(S&& sink, FillRule rule, const std::span<const linear::SubPoint>& vertices,
                     const std::span<CoverageCell>& workspace) {
  const int length = static_cast<int>(vertices.size());
  return fill_coverage(sink, rule, vertices, std::span<const int>(&length, 1), workspace);
}

/// Stores a step of a ramp of palette entries: the first for no coverage, the last for a whole pixel, between
/// them the nearest, first + round(coverage * (steps - 1) / 255). With 256 steps from index 0 the indices are
/// the levels themselves. The ramp (`image/ramp.hpp`) leads from the colour of what is there to that of the
/// polygon.
template <image::PixelFormat F>
class RampCoverage {
 public:
  /// A ramp of `steps` entries from index `first` on. `clip` as that of `Solid`.
  /// Errors: index (the format has no `first`), steps (none, or more than indices from `first` on: `needed()`
  /// is how many there are).
  [[nodiscard]] static constexpr Result<RampCoverage> over(const image::Surface<F>& surface, unsigned first,
                                                           int steps, const linear::Rect& clip) noexcept {
    if (first > F::max_index) return Status{Error::out_of_range, Argument::index};
    if (steps < 1) return Status{Error::empty, Argument::steps};
    const unsigned most = F::max_index + 1 - first;
    if (static_cast<unsigned>(steps) > most) return Status{Error::too_large, Argument::steps, most};
    return RampCoverage(surface, first, static_cast<unsigned>(steps) - 1, clip);
  }
  /// The same on all of the surface.
  [[nodiscard]] static constexpr Result<RampCoverage> over(const image::Surface<F>& surface, unsigned first,
                                                           int steps) noexcept {
    return over(surface, first, steps, surface.bounds());
  }

  /// Draws nothing.
  constexpr RampCoverage() noexcept = default;

  /// Where it can draw.
  [[nodiscard]] constexpr const linear::Rect& clip() const noexcept { return clip_; }
  /// The index for a level of 0 to 255.
  [[nodiscard]] constexpr unsigned index(int coverage) const noexcept {
    return first_ + coverage_step(coverage, last_);
  }
  /// Writes the pixels x_begin .. x_end-1 of row y. Precondition: they are inside the clip; x_begin < x_end.
  void span(int y, int x_begin, int x_end, int coverage) const noexcept {
    Solid<F>(surface_, index(coverage)).span(y, x_begin, x_end);
  }

 private:
  constexpr RampCoverage(const image::Surface<F>& surface, unsigned first, unsigned last,
                         const linear::Rect& clip) noexcept
      : surface_(surface), clip_(Solid<F>(surface, first, clip).clip()), first_(first), last_(last) {}

  image::Surface<F> surface_{};
  linear::Rect clip_{};
  unsigned first_ = 0;
  unsigned last_ = 0;  // steps - 1
};

static_assert(CoverageSink<RampCoverage<image::Indexed8>> && CoverageSink<RampCoverage<image::Indexed4>>);

}  // namespace intaglio::raster
