// SPDX-License-Identifier: MIT
//
// Ways to step an edge of a polygon from row to row: with a slope of 16 fraction bits, or exactly.
//
// Rule: `start(top, bottom, row)` puts the edge on a row that it has, `x()` is the first pixel there whose
// centre isn't left of it, `next()` goes to the row below; as `Edge` (edge.hpp), which is `ExactEdge`.
//
// Error: how far the edge is from the true one, in pixels. Each row adds the error of the slope: below 2^-16
// pixel if it is rounded down (`TruncatedSlope`), up to half of that if to nearest (`RoundedSlope`); the
// first row adds up to two units of the last place. An edge has up to 2^14 rows, so that is 0.25004 or
// 0.12504 pixel at most. Bit budget: places within 2^13 pixels and edges of a pixel and more in height, so
// the slope has 30 bits and the first row's product 2^30 * 2^8. Textbook: section 2.6.3, erratum E3. Worst
// known inputs: slopes like 1/3, of which each rounded edge misses whole columns on every third row.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/number/long_division.hpp>
#include <intaglio/raster/edge.hpp>

#include <cstdint>
#include <string_view>

namespace intaglio::raster {

namespace detail {

/// An edge whose column and slope have 16 fraction bits, rounded to the nearest or down.
template <bool nearest>
class FixedEdge {
 public:
  static constexpr std::string_view domain = "edges of a pixel and more in height, within 2^13 pixels";

  /// Preconditions: as Edge::start; coordinates within 2^13 pixels, bottom.y at least a pixel below top.y.
  void start(const linear::SubPoint& top, const linear::SubPoint& bottom, int row) noexcept {
    const int height = bottom.y - top.y;
    const std::int64_t across = std::int64_t{bottom.x - top.x} * one + (nearest ? height / 2 : 0);
    // Below zero, ~across = -across - 1 is divided instead: floor(a / b) = ~floor(~a / b).
    const std::int64_t sign = across >> 63U;
    const auto quotient =
        number::long_divide(static_cast<std::uint64_t>(across ^ sign), static_cast<unsigned>(height))
            .quotient;
    const std::int64_t slope = std::int64_t{quotient} ^ sign;
    const std::int64_t first = slope * (row * linear::subpixel_one - top.y);
    x_ = static_cast<std::uint32_t>(std::int64_t{top.x} * (one / linear::subpixel_one) +
                                    ((first + (nearest ? 128 : 0)) >> 8U));
    slope_ = static_cast<std::uint32_t>(slope);
  }
  [[nodiscard]] int x() const noexcept { return static_cast<int>(x_ + (one - 1)) >> 16U; }
  void next() noexcept { x_ += slope_; }

 private:
  static constexpr int one = 1 << 16;
  // Two's complement: past the last row of a level edge they may wrap.
  std::uint32_t x_ = 0;
  std::uint32_t slope_ = 0;
};

}  // namespace detail

/// The slope rounded down.
struct TruncatedSlope : detail::FixedEdge<false> {
  static constexpr number::Bound bound = number::pixels(251);
};
/// The slope rounded to nearest.
struct RoundedSlope : detail::FixedEdge<true> {
  static constexpr number::Bound bound = number::pixels(126);
};
/// Quotient and remainder, the library's: `Edge`.
struct ExactEdge : Edge {
  static constexpr number::Bound bound = number::exactly(number::Unit::pixel);
};

/// The rungs of edges.
using EdgeFamily = number::Family<TruncatedSlope, RoundedSlope, ExactEdge>;

}  // namespace intaglio::raster
