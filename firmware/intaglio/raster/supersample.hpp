// SPDX-License-Identifier: MIT
//
// Supersampling: any primitive antialiased, by drawing it enlarged.
//
// Rule: what is drawn is enlarged `scale` times each way (enlargement.hpp: places exactly, whole-pixel shapes
// by their rectangles), so that a pixel is a square of scale x scale samples. Its level is the weight of the
// samples that are covered in a window of width x width samples around its middle, in 1/255 of the window's
// whole weight, rounded to nearest, ties up. Filters:
// - box: the window is the pixel, all samples weigh the same;
// - Bartlett's (Crow's): along each axis the weights are 1 2 ... 2 1, and a sample weighs the product of two.
//   A width above `scale` overlaps (width - scale) / 2 samples of each neighbour. 3, 5 and 7 samples give the
//   book's windows of the weight 16, 81 and 256; scale and width are both odd or both even, as the window has
//   the pixel's middle.
// Weights are counted as they are and divided once: flat areas are full, exactly, and there is no bias.
//
// The primitive draws into a span sink. A span adds to a row of cells at its two ends only, wherever they
// lie; cells hold the change from pixel to pixel. As primitives draw their rows in any order, it is drawn
// once for as many rows of pixels as the caller's memory holds, under the clip of these rows: clipping
// changes no pixel. So everything that a span sink takes can be drawn smoothly, with one row of memory or
// with more.
//
// Error bound, in a pixel that one straight edge crosses, against its area: 1/(2*scale) of the pixel for the
// box, proven (along the edge's major axis every column of samples is off by half a sample at most, and where
// the edge leaves it above or below by no more); for the others the `bound` of each rung below, in
// thousandths of the pixel, found by trying all edges in steps of 0.015 degrees; each plus half a level. Bit
// budget: cells change by at most the window's weight, 400 (int16, while no pixel is drawn twice); columns
// within 2^21. Textbook: section 2.8.2. Worst known inputs: edges along rows and columns (all samples of a
// row change at once); shapes between the samples, which are lost.
#pragma once

#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/enlargement.hpp>
#include <intaglio/raster/sample_level.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace intaglio::raster {

/// How samples are weighed.
enum class SampleFilter : std::uint8_t { box, bartlett };

/// A grid of samples and the window that makes a pixel of it.
struct Supersampling {
  int scale = 4;  ///< Samples of a pixel along each axis, 2 .. 8.
  int width = 4;  ///< Samples of a window along each axis, `scale` .. 8.
  SampleFilter filter = SampleFilter::box;
  friend constexpr bool operator==(const Supersampling&, const Supersampling&) noexcept = default;
};

/// A way of supersampling, and how far it is from the area where one straight edge crosses the pixel: at most
/// so many thousandths of the pixel and half a level.
struct SupersamplingRung {
  Supersampling grid;
  int bound = 0;
};

/// All of them.
inline constexpr std::array<SupersamplingRung, 19> supersampling_rungs{{
    {{2, 2, SampleFilter::box}, 250},      {{3, 3, SampleFilter::box}, 167},
    {{4, 4, SampleFilter::box}, 125},      {{5, 5, SampleFilter::box}, 100},
    {{6, 6, SampleFilter::box}, 84},       {{7, 7, SampleFilter::box}, 72},
    {{8, 8, SampleFilter::box}, 63},       {{2, 4, SampleFilter::bartlett}, 250},
    {{2, 6, SampleFilter::bartlett}, 278}, {{2, 8, SampleFilter::bartlett}, 305},
    {{3, 3, SampleFilter::bartlett}, 250}, {{3, 5, SampleFilter::bartlett}, 167},
    {{3, 7, SampleFilter::bartlett}, 209}, {{4, 4, SampleFilter::bartlett}, 209},
    {{4, 6, SampleFilter::bartlett}, 125}, {{4, 8, SampleFilter::bartlett}, 175},
    {{5, 5, SampleFilter::bartlett}, 189}, {{5, 7, SampleFilter::bartlett}, 125},
    {{7, 7, SampleFilter::bartlett}, 170},
}};

namespace detail {
class SampleRows;
}

/// One visible column of one row in the workspace: 2 bytes. Its content is the business of `supersample`.
class SampleCell {
 private:
  friend class detail::SampleRows;
  std::int16_t change_;  // of the weight from the column to the left
};

namespace detail {

/// Rows of pixels that samples are added to.
class SampleRows {
 public:
  /// Precondition: `check` was content.
  SampleRows(const Supersampling& grid, const linear::Rect& clip,
             const std::span<SampleCell>& cells) noexcept;

  /// Errors: as `supersample`.
  [[nodiscard]] static Status check(const Supersampling& grid, const linear::Rect& clip,
                                    const std::span<SampleCell>& cells) noexcept;

  /// Goes to the next rows; false if there are none.
  [[nodiscard]] bool next_pass() noexcept;
  /// The samples that these rows look at, in enlarged pixels.
  [[nodiscard]] const linear::Rect& samples() const noexcept { return samples_; }
  /// Adds a span of samples. Precondition: inside `samples()`.
  void add(int y, int x_begin, int x_end) noexcept;
  /// Puts the next span of pixels in `span`; false if these rows have none left.
  [[nodiscard]] bool next(CoverageSpan& span) noexcept;

 private:
  void add_from(SampleCell* row, int x, int weight) const noexcept;

  int scale_;
  int width_;
  int margin_;  // samples of a neighbour in a window
  linear::Rect clip_;
  SampleCell* cells_;
  int most_rows_;
  linear::Rect rows_{};
  linear::Rect samples_{};
  std::array<std::int16_t, Enlargement::limit> weights_{};
  std::array<std::int16_t, Enlargement::limit + 1> tails_{};  // the weight of a window from a sample on
  SampleLevels levels_;
  int x_ = 0;  // next pixel
  int y_ = 0;
  int sum_ = 0;  // the weight of the column before it
};

}  // namespace detail

/// The span sink that an enlarged primitive is drawn into.
class SampleSink {
 public:
  explicit SampleSink(detail::SampleRows& rows) noexcept : rows_(&rows) {}
  /// The enlarged pixels that are looked at.
  [[nodiscard]] const linear::Rect& clip() const noexcept { return rows_->samples(); }
  /// Covers the samples x_begin .. x_end-1 of row y.
  void span(int y, int x_begin, int x_end) const noexcept { rows_->add(y, x_begin, x_end); }

 private:
  detail::SampleRows* rows_;
};

/// Hands over how much of each pixel an enlarged drawing covers. `draw` is called with a `SampleSink` and
/// draws what is to be seen, enlarged by `Enlargement(grid.scale)`, each enlarged pixel once; it answers with
/// a `Status`. It is called once for each so many rows of the sink's clip as `workspace` has room for: a cell
/// a column and row, one row at least; once under an empty clip. Errors: steps (a scale outside 2 .. 8),
/// width (a window below the scale, above 8, other than the scale with the box, or odd for an even scale and
/// the reverse), rule (the filter), workspace (too small: `needed()` cells); those of `draw`, which nothing
/// is handed over after. Cost: what it draws, and for each span of samples about 60 instructions for each row
/// of windows that it lies in; a look at each visible column a row.
template <CoverageSink S, class Draw>
Status supersample(S&& sink, const Supersampling& grid, const std::span<SampleCell>& workspace, Draw draw) {
  const linear::Rect clip = Enlargement(grid.scale).window(sink.clip());
  Status status = detail::SampleRows::check(grid, clip, workspace);
  if (!status.ok()) return status;
  detail::SampleRows rows(grid, clip, workspace);
  SampleSink samples(rows);
  // Where nothing is visible the drawing still says if it is one.
  if (!rows.next_pass()) return draw(samples);
  do {
    status = draw(samples);
    if (!status.ok()) return status;
    for (detail::CoverageSpan span; rows.next(span);)
      sink.span(span.y, span.x_begin, span.x_end, span.coverage);
  } while (rows.next_pass());
  return {};
}

}  // namespace intaglio::raster
