// SPDX-License-Identifier: MIT
//
// The family of edges of polygons, stepped from row to row: with a slope of 16 fraction bits, or exactly.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/raster/edge.hpp>
#include <intaglio/raster/edge_rungs.hpp>

#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>
#include <type_traits>

namespace lab {

struct Edge {
  static constexpr std::string_view name = "edge";
  static constexpr std::string_view title = "Stepping an edge of a polygon from row to row";
  using Rungs = intaglio::raster::EdgeFamily;
  using Default = intaglio::raster::ExactEdge;
  static constexpr Load loads[] = {{"240 rows, whole pixels", 32},
                                   {"240 rows, 1/16 pixel", 32},
                                   {"1024 rows, 1/256 pixel", 16},
                                   {"8 rows, 1/256 pixel", 64}};
  static constexpr int fraction_bits[] = {0, 4, 8, 8};
  static constexpr int most_rows[] = {240, 240, 1024, 8};
  static constexpr std::string_view per = "row";

  struct Input {
    intaglio::linear::SubPoint top;
    intaglio::linear::SubPoint bottom;
  };
  static constexpr int first_row(int y) noexcept { return intaglio::raster::ceil_to_pixel(y); }
  static int units(const Input& edge) noexcept { return first_row(edge.bottom.y) - first_row(edge.top.y); }

  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i + 1));
    const int one = 1 << fraction_bits[load];
    const int rows = most_rows[load];
    const int unit = intaglio::linear::subpixel_one / one;
    const int top = random.between(0, one - 1);
    const int height = rows * one - random.between(0, one - 1);
    return {{random.between(0, 320 * one) * unit, top * unit},
            {random.between(0, 320 * one) * unit, (top + height) * unit}};
  }
  template <class R>
  static std::uint32_t run(const Input& edge) noexcept {
    const int begin = first_row(edge.top.y);
    const int end = first_row(edge.bottom.y);
    std::uint32_t sum = 0;
    R rung;
    rung.start(edge.top, edge.bottom, begin);
    for (int row = begin; row < end; ++row) {
      sum = sum * 3 + static_cast<std::uint32_t>(rung.x());
      rung.next();
    }
    return sum;
  }

  /// Rows with the wrong pixel, of a million. A row is wrong where the exact place lies between a whole
  /// column and what the error has grown to, E = (rows + 1) * 2^-16 at most. With dx/dy = p/q in lowest terms
  /// the places repeat after q rows, 1/q apart, as multiples of 1/(S*q) with S units a pixel: so at most
  /// ceil(rows/q) * (floor(E*q) + 1) rows are wrong, and none if the error only takes away (truncated) and
  /// E*S*q < 1. Rounded, that is every third row, as slopes with q = 1 and 2 are exact. Truncated on whole
  /// pixels, nothing is wrong, as E*240 < 1; with 1/16 pixel, q >= 17 leaves 15 rows; of 8 rows with 1/256
  /// pixel, E*256*q >= 1 leaves one. Over 1024 rows with 1/256 pixel, slopes below 2^-16 become nothing, or
  /// that much, and all rows may be wrong.
  template <class R>
  static constexpr number::Bound bound(int load) noexcept {
    constexpr int truncated[] = {0, 62'800'000, 1'000'000'000, 143'000'000};
    constexpr int rounded[] = {334'000'000, 334'800'000, 1'000'000'000, 429'000'000};
    int ppm = 0;
    if (std::is_same_v<R, intaglio::raster::TruncatedSlope>) ppm = truncated[load];
    if (std::is_same_v<R, intaglio::raster::RoundedSlope>) ppm = rounded[load];
    return {ppm, number::Unit::wrong_ppm};
  }
};

}  // namespace lab
