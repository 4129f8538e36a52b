// SPDX-License-Identifier: MIT
//
// Ways to fill a triangle with smooth edges: how much of each pixel it covers, from all or nothing to the
// exact area.
//
// Rule: a coverage sink gets levels 1 .. 255 of what a rung takes for the covered area; each pixel once.
// Samples s by s are the textbook's supersampling (supersample.hpp), those of 3 by 3 also through Bartlett's
// window; `Masks4x4` is them by bits of a mask, `Samples15x17` by 255 samples, so that their number is the
// level; `PittewayWatkinson` takes Bresenham's error (pitteway.hpp), `ExactArea` is `fill_coverage`. Memory
// is a workspace of the rung's `Cell`s, `cells(width)` of them under a clip so wide.
//
// Error, in levels, at any pixel of any triangle: of s by s samples each row has one too many or too few at
// most, as the shape is convex, 1/s of all; and as the rows' chords grow and then shrink, their sum is at
// most 1/s off the area. Where one edge crosses a pixel it is half of that. Of pixels with corners no bound
// below the whole is proven for Pitteway and Watkinson's. Bit budget: enlargement.hpp; of 15 by 17 samples,
// places within 2^15 pixels times 17 are below 2^20. Textbook: sections 2.7. Worst known inputs: needles.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/enlargement.hpp>
#include <intaglio/raster/layer_sink.hpp>
#include <intaglio/raster/mask_buffer.hpp>
#include <intaglio/raster/pitteway.hpp>
#include <intaglio/raster/supersample.hpp>
#include <intaglio/raster/triangle.hpp>
#include <intaglio/status.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

namespace intaglio::raster {

using TriangleCorners = std::array<linear::SubPoint, 3>;

namespace detail {

/// What rungs without memory have.
struct NeedsNoCells {
  struct Cell {};
  [[nodiscard]] static constexpr std::size_t cells(int /*width*/) noexcept { return 0; }
};

/// All or nothing of a pixel.
template <CoverageSink S>
struct WholePixels {
  S& sink;
  [[nodiscard]] linear::Rect clip() const noexcept { return sink.clip(); }
  void span(int y, int x_begin, int x_end) const { sink.span(y, x_begin, x_end, full_coverage); }
};

/// Samples of the library. Errors: as `fill_triangle`, whose vertices may be 2^20/scale pixels away, and
/// workspace as `supersample`, which is faster with room for several rows.
template <int scale, SampleFilter filter>
struct TriangleSamples {
  static constexpr std::string_view slack =
      "held for any number of edges through a pixel; the worst pixels found have two";
  using Cell = SampleCell;
  [[nodiscard]] static constexpr std::size_t cells(int width) noexcept {
    return static_cast<std::size_t>(width);
  }
  template <CoverageSink S>
  Status operator()(S&& sink, const TriangleCorners& t, const std::span<Cell>& workspace) const {
    constexpr Supersampling grid{scale, scale, filter};
    constexpr Enlargement by(scale);
    return supersample(sink, grid, workspace, [&](const auto& samples) {
      return fill_triangle(samples, by.place(t[0]), by.place(t[1]), by.place(t[2]));
    });
  }
};

}  // namespace detail

/// Pixels are covered or not.
struct NoAntialiasing : detail::NeedsNoCells {
  static constexpr number::Bound bound = number::coverage_levels(255'000);
  template <CoverageSink S>
  Status operator()(S&& sink, const TriangleCorners& t, const std::span<Cell>& /*workspace*/ = {}) const {
    return fill_triangle(detail::WholePixels<std::remove_reference_t<S>>{sink}, t[0], t[1], t[2]);
  }
};

struct Samples2x2 : detail::TriangleSamples<2, SampleFilter::box> {
  static constexpr number::Bound bound = number::coverage_levels(255'000);
};
struct Samples3x3 : detail::TriangleSamples<3, SampleFilter::box> {
  static constexpr number::Bound bound = number::coverage_levels(170'500);
};
struct Bartlett3x3 : detail::TriangleSamples<3, SampleFilter::bartlett> {
  static constexpr number::Bound bound = number::coverage_levels(255'000);
};
struct Samples4x4 : detail::TriangleSamples<4, SampleFilter::box> {
  static constexpr number::Bound bound = number::coverage_levels(128'000);
};

/// Bits of a mask. Errors: as `Samples4x4`.
struct Masks4x4 {
  static constexpr number::Bound bound = Samples4x4::bound;
  static constexpr std::string_view slack = Samples4x4::slack;
  using Cell = MaskCell;
  [[nodiscard]] static constexpr std::size_t cells(int width) noexcept {
    return static_cast<std::size_t>(width);
  }
  template <CoverageSink S>
  Status operator()(S&& sink, const TriangleCorners& t, const std::span<Cell>& workspace) const {
    constexpr Enlargement by(4);
    return cover_by_masks(OneLayer<S&>(sink), MaskGrid::four_by_four, 1, workspace,
                          [&](int /*layer*/, MaskSink& parts) {
                            return fill_triangle(parts, by.place(t[0]), by.place(t[1]), by.place(t[2]));
                          });
  }
};

/// 17 samples along each of 15 rows. Errors: point, out_of_domain, beyond 2^15 pixels; workspace, too_small.
struct Samples15x17 {
  static constexpr std::string_view domain = "places within 2^15 pixels";
  static constexpr number::Bound bound = number::coverage_levels(32'000);
  static constexpr std::string_view slack = Samples4x4::slack;
  using Cell = std::int16_t;
  [[nodiscard]] static constexpr std::size_t cells(int width) noexcept {
    return static_cast<std::size_t>(width) + 2;
  }

  template <CoverageSink S>
  Status operator()(S&& sink, const TriangleCorners& t, const std::span<Cell>& workspace) const {
    constexpr int far = reach * linear::subpixel_one;
    for (const linear::SubPoint& p : t) {
      if (p.x < -far || p.x > far || p.y < -far || p.y > far) return {Error::out_of_domain, Argument::point};
    }
    const linear::Rect box = linear::intersect(sink.clip(), {-reach, -reach, 2 * reach, 2 * reach});
    const std::size_t needed = cells(box.width);
    if (workspace.size() < needed)
      return {Error::too_small, Argument::workspace, static_cast<std::uint32_t>(needed)};
    const auto place = [](linear::SubPoint p) {
      return linear::SubPoint{p.x * across + 128 * (across - 1), p.y * down + 128 * (down - 1)};
    };
    Rows<std::remove_reference_t<S>> rows(sink, box, workspace.first(needed));
    const Status status = fill_triangle(rows, place(t[0]), place(t[1]), place(t[2]));
    rows.hand_over(0);
    return status;
  }

 private:
  static constexpr int across = 17;
  static constexpr int down = 15;
  static constexpr int reach = 1 << 15;

  /// Adds samples up, row by row from above; `changes` of the level from the column to the left.
  template <CoverageSink S>
  class Rows {
   public:
    Rows(S& sink, const linear::Rect& box, const std::span<Cell>& changes) noexcept
        : sink_(sink), box_(box), y_(box.y), changes_(changes.data()) {
      std::ranges::fill(changes, Cell{0});
    }
    [[nodiscard]] linear::Rect clip() const noexcept {
      return {box_.x * across, box_.y * down, box_.width * across, box_.height * down};
    }
    void span(int y, int x_begin, int x_end) {
      const int row = box_.y + static_cast<int>(static_cast<unsigned>(y - box_.y * down) / down);
      if (row != y_) hand_over(row);
      add(x_begin, 1);
      add(x_end, -1);
    }
    /// Hands the row over, and goes to another.
    void hand_over(int next_row) {
      int level = 0;
      int begin = 0;
      for (int x = 0; x < box_.width; ++x) {
        Cell& change = changes_[x];
        if (change == 0) continue;
        if (level != 0) sink_.span(y_, box_.x + begin, box_.x + x, level);
        level += change;
        begin = x;
        change = 0;
      }
      if (level != 0) sink_.span(y_, box_.x + begin, box_.right(), level);
      changes_[box_.width] = 0;
      y_ = next_row;
    }

   private:
    /// All samples of a row from x on.
    void add(int x, int sign) const noexcept {
      const auto place = static_cast<unsigned>(x - box_.x * across);
      const auto left_out = static_cast<int>(place % across);
      Cell* const change = changes_ + place / across;
      change[0] = static_cast<Cell>(change[0] + sign * (across - left_out));
      change[1] = static_cast<Cell>(change[1] + sign * left_out);
    }

    S& sink_;
    linear::Rect box_;
    int y_;
    Cell* changes_;
  };
};

/// Bresenham's error as the level.
struct PittewayWatkinson : detail::NeedsNoCells {
  static constexpr number::Bound bound = number::coverage_levels(255'000);
  static constexpr std::string_view slack = "of pixels with corners no bound is proven";
  template <CoverageSink S>
  Status operator()(S&& sink, const TriangleCorners& t, const std::span<Cell>& /*workspace*/ = {}) const {
    return fill_convex_pitteway(sink, t);
  }
};

/// The area itself. Errors: as `fill_coverage`.
struct ExactArea {
  static constexpr number::Bound bound = number::coverage_levels(501);
  using Cell = CoverageCell;
  [[nodiscard]] static constexpr std::size_t cells(int width) noexcept { return coverage_cells(3, width); }
  template <CoverageSink S>
  Status operator()(S&& sink, const TriangleCorners& t, const std::span<Cell>& workspace) const {
    return fill_coverage(sink, FillRule::non_zero, t, workspace);
  }
};

/// The rungs of triangles with smooth edges.
using SmoothTriangleFamily = number::Family<NoAntialiasing, ExactArea, Samples2x2, Samples3x3, Bartlett3x3,
                                            Samples4x4, Masks4x4, Samples15x17, PittewayWatkinson>;

}  // namespace intaglio::raster
