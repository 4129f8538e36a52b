// SPDX-License-Identifier: MIT
//
// One side of a disc around any point, walked row by row: for round caps and joins.
//
// Rule: a pixel belongs to the disc of diameter w around v iff its centre p is closer to v than w/2, or just
// as far away and left of v: 4*|p - v|^2 < w^2, or = and p.x < v.x, in 1/256 pixel. That is the top-left rule
// of polygons: on each row the disc is half-open, from the first pixel with a centre not left of its left
// side to that of its right side.
//
// Bit budget: twice the distance from v to a row of the disc is at most w <= 2^28, so its square has 56 bits.
// Error: none; the root's floor decides between integers exactly. Textbook: none; beside section 2.4.
// Worst known input: a width of 2 around a pixel's centre, whose circle passes through four others.
#pragma once

#include <intaglio/linear/point.hpp>

namespace intaglio::raster {

/// Walks a side of a disc downwards. Trivially copyable, 20 bytes.
class DiscEdge {
 public:
  /// No side yet; call `start`.
  DiscEdge() noexcept = default;

  /// The first row of a disc, and the first below it. Precondition: all is in the domain.
  [[nodiscard]] static constexpr int top(linear::SubPoint centre, int diameter) noexcept {
    return ceil_half(2 * centre.y - diameter);
  }
  [[nodiscard]] static constexpr int bottom(linear::SubPoint centre, int diameter) noexcept {
    return ceil_half(2 * centre.y + diameter);
  }

  /// Becomes a side of the disc, standing on `row`. Precondition: top <= row < bottom, diameter <= 2^28.
  void start(linear::SubPoint centre, int diameter, bool right, int row) noexcept;

  /// The first pixel of this row whose centre isn't left of this side.
  [[nodiscard]] constexpr int x() const noexcept { return x_; }

  /// Goes to the row below, which must be one of the disc's. Cost: a square root.
  void next() noexcept;

 private:
  static constexpr int unit = 2 * linear::subpixel_one;  // lengths are doubled, so that w/2 is whole
  static constexpr int ceil_half(int doubled) noexcept {
    return (doubled + (unit - 1)) >> (linear::subpixel_bits + 1);
  }
  void update() noexcept;

  int x_;
  int centre_;    // its x
  int distance_;  // of the row, from the centre down
  int diameter_;
  bool right_;
};

}  // namespace intaglio::raster
