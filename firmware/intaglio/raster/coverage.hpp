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
// right, the height of the piece. A row holds the change of that sum from pixel to pixel, and a bit for each
// pixel that an edge touches, so those between cost nothing. Where an edge crosses the sides of rows is
// stepped by quotient and remainder, so there is no drift at any length; where it crosses the sides of
// columns inside a row follows from there by its slope.
//
// Error bound: a place on the side of a row is less than 2^-32 pixel off, a slope less than 2^-31 of itself,
// so each of the two ends of a piece changes the area in a pixel by less than 2^-29. Heights add up exactly,
// so nothing leaks to other pixels. With n edges through (or within such an error of) a pixel, its level is
// off by at most 1/2 + 2^-17 + n*2^-20 from 255 times the exact integral. What two polygons add for a shared
// edge cancels to the last bit.
//
// Bit budget: |dx|, |dy| <= 2^29, products below 2^58; columns and rows in 2^-32 pixel below 2^53; heights
// and areas in a pixel in 2^-31, so 2^20 edges sum to less than 2^52.
// Textbook: section 2.8.1, Catmull's area for one polygon. Worst known inputs: slivers thousands of pixels
// long and a fraction of a pixel wide, edges along the sides of pixels.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/contours.hpp>
#include <intaglio/raster/coverage_step.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/status.hpp>

#include <bit>
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

/// A piece of the workspace: 8 bytes. Its content is the business of `fill_coverage`.
class CoverageCell {
 private:
  friend class detail::CoverageScan;
  std::int64_t change_;  // of the covered area from the column to the left, in 2^-31 pixel
};

namespace detail {

/// Pixels of one row and one level.
struct CoverageSpan {
  int y = 0;
  int x_begin = 0;
  int x_end = 0;
  int coverage = 0;
};

/// An edge, in six cells of the workspace. Columns count from the left side of the area that is looked at.
struct CoverageEdge {
  std::int64_t x;        // where it crosses the upper side of the row, in 2^-32 column
  std::int64_t step;     // how far x goes with each row
  std::uint32_t height;  // in 1/256 pixel; while it waits, the index of its first vertex
  std::uint32_t rest;    // of the step, over `height`; while it waits, the index of its second vertex
  std::int32_t error;    // running remainder of x, -height .. -1
  std::uint32_t slope;   // rows a column: slope * 2^-slope_shift, with the highest bit set
  std::int32_t row;      // its last row; while it waits, the first of its visible ones
  std::int32_t x_end;    // its lower end, in 1/256 pixel from the left side of the area
  std::int16_t end;      // how far it reaches into its last row, in 1/256 pixel
  std::uint8_t slope_shift;
  bool upwards;  // as the contour runs
};
inline constexpr std::size_t cells_of_edge = sizeof(CoverageEdge) / sizeof(CoverageCell);
static_assert(sizeof(CoverageEdge) == 48 && alignof(CoverageEdge) == alignof(CoverageCell));

/// The coverage of a polygon, row by row.
class CoverageScan {
 public:
  /// `vertices` and `contour_lengths` must stay while rows are taken.
  CoverageScan(FillRule rule, const linear::Rect& clip, const std::span<const linear::SubPoint>& vertices,
               const std::span<const int>& contour_lengths) noexcept;

  /// Checks the arguments and finds the pixels to look at.
  [[nodiscard]] Status prepare() noexcept;
  /// How many cells it takes.
  [[nodiscard]] std::uint32_t count() const noexcept { return cell_count_; }
  /// Uses these cells. Error: workspace.
  [[nodiscard]] Status use(const std::span<CoverageCell>& cells) noexcept;
  /// Goes on to the next row; false if there is none.
  [[nodiscard]] bool next_row() noexcept;
  /// Hands over the spans of the row, and clears it.
  template <class S>
  void take_row(S& sink) noexcept {
    // As the sink may write anywhere, members would be read again after each span.
    CoverageCell* const cells = cells_;
    const linear::Rect area = area_;
    const bool even_odd = rule_ == FillRule::even_odd;
    std::int64_t sum = 0;
    int level = 0;
    int begin = 0;
    for (int first = 0; first <= area.width; first += 32) {
      std::uint32_t touched = touched_[first / 32];
      if (touched == 0) continue;
      touched_[first / 32] = 0;
      for (; touched != 0; touched &= touched - 1) {
        const int column = first + std::countr_zero(touched);
        sum += cells[column].change_;
        cells[column].change_ = 0;
        const int next_level = even_odd ? even_odd_level(sum) : non_zero_level(sum);
        if (next_level == level) continue;
        if (level != 0) sink.span(y_, area.x + begin, area.x + column, level);
        begin = column;
        level = next_level;
      }
    }
    if (level != 0 && begin < area.width) sink.span(y_, area.x + begin, area.right(), level);
  }

 private:
  static constexpr std::uint32_t whole_pixel = 1U << 31U;

  [[nodiscard]] static constexpr int level_of(std::uint32_t folded) noexcept {
    return static_cast<int>((((folded + 64U) >> 7U) * full_coverage + (1U << 23U)) >> 24U);
  }
  [[nodiscard]] static constexpr int even_odd_level(std::int64_t area) noexcept {
    // The low word is the area modulo two pixels.
    const auto folded = static_cast<std::uint32_t>(area);
    return level_of(folded > whole_pixel ? ~folded + 1 : folded);
  }
  [[nodiscard]] static constexpr int non_zero_level(std::int64_t area) noexcept {
    const auto size = static_cast<std::uint64_t>(area < 0 ? -area : area);
    return size < whole_pixel ? level_of(static_cast<std::uint32_t>(size)) : full_coverage;
  }

  template <class Visit>
  void visit_edges(Visit visit) const noexcept;
  void start(CoverageEdge& edge) noexcept;
  void add_piece(const CoverageEdge& edge, std::int64_t x, std::int64_t x_end, std::uint32_t height) noexcept;
  void add_columns(const CoverageEdge& edge, std::int64_t left, std::int64_t right,
                   std::uint32_t height) noexcept;
  void add(int column, std::uint32_t own, std::uint32_t height, bool upwards) noexcept;

  std::span<const linear::SubPoint> vertices_;
  std::span<const int> contour_lengths_;
  CoverageCell* cells_ = nullptr;     // a column each, and one more
  std::uint32_t* touched_ = nullptr;  // a bit each
  CoverageEdge* edges_ = nullptr;     // those on the row, then those that wait, a heap by their first row
  std::uint32_t cell_count_ = 0;
  int edge_count_ = 0;
  int active_ = 0;     // how many are on the row
  int waiting_ = 0;    // how many wait, at the end
  linear::Rect area_;  // the clip; once prepared, the part of it that the polygon's box touches
  int y_ = 0;
  FillRule rule_;
};

}  // namespace detail

/// How many `CoverageCell`s are always enough for polygons with so many vertices under a clip so wide.
[[nodiscard]] constexpr std::size_t coverage_cells(std::size_t vertices, int clip_width) noexcept {
  const auto columns = static_cast<std::size_t>(clip_width > 0 ? clip_width : 0) + 1;
  return columns + (columns + 63) / 64 + detail::cells_of_edge * vertices;
}

/// How many `CoverageCell`s `fill_coverage` needs for this polygon under this clip: one for each of its
/// visible columns and one more, one for 64 of those, and six for each edge that is neither level, nor above
/// or below the clip, nor right of it. Errors: as `fill_coverage`; rectangle (clip outside the domain).
[[nodiscard]] Result<std::uint32_t> coverage_workspace(const std::span<const linear::SubPoint>& vertices,
                                                       const std::span<const int>& contour_lengths,
                                                       const linear::Rect& clip) noexcept;

/// Hands the coverage of the polygon over, in spans of one level, each pixel that has a level of 1 or more
/// once. The polygon is given as to `fill_polygon`: contours are runs of `vertices` (in 1/256 pixel, |c| <=
/// 2^28, at most 2^20 of them), as long as `contour_lengths` says; those of fewer than three vertices are
/// empty. `workspace` needs `coverage_workspace` cells (`coverage_cells` are always enough). It need not be
/// initialised, and holds nothing of value afterwards. The level is at most 1/2 + 2^-17 + n*2^-20 from 255
/// times the exact area, with n edges through the pixel; see the head of this file for polygons that cross
/// themselves. Errors: vertices (one is outside the domain; or too_large, with the limit), contours
/// (mismatched), workspace (too small: `needed()` cells), rule; nothing is handed over then. Cost: up to six
/// divisions an edge; then about 60 instructions for each row that an edge crosses and for each pixel that it
/// touches; and what the sink takes.
template <CoverageSink S>
Status fill_coverage(S&& sink, FillRule rule, const std::span<const linear::SubPoint>& vertices,
                     const std::span<const int>& contour_lengths, const std::span<CoverageCell>& workspace) {
  detail::CoverageScan scan(rule, sink.clip(), vertices, contour_lengths);
  Status status = scan.prepare();
  if (status.ok()) status = scan.use(workspace);
  if (!status.ok()) return status;
  while (scan.next_row()) scan.take_row(sink);
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
    const unsigned step = index(coverage);
    if constexpr (F::bits == 8) {
      // On the boundary of a shape most spans are this long.
      if (x_end - x_begin == 1) {
        *surface_.byte_at(x_begin, y) = static_cast<std::uint8_t>(step);
        return;
      }
    }
    Solid<F>(surface_, step).span(y, x_begin, x_end);
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
