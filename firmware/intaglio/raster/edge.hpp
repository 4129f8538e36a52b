// SPDX-License-Identifier: MIT
//
// An edge of a polygon, walked row by row.
//
// Rule: on row y the edge from (x0, y0) to (x1, y1), y0 < y1, stands at the first pixel whose centre isn't
// left of it: x(y) = ceil((x0 + dx*(256*y - y0)/dy) / 256), dx = x1 - x0, dy = y1 - y0, in 1/256 pixel. It
// has the rows ceil(y0/256) <= y < ceil(y1/256). Two edges then bound the half-open span of the top-left
// rule.
//
// With X = floor(x0/256), f = x0 - 256*X and N(y) = f*dy + dx*(256*y - y0) this is X + ceil(N / (256*dy)) =
// X + ceil(M/dy) with M = ceil(N/256). A row more adds 256*dx to N, hence exactly dx to M: the fraction bits
// leave the problem at set-up, and quotient and remainder of dx/dy step the quotient and remainder of M/dy
// without any error, however long the edge. The same set-up starts on any row: no stepping over hidden rows.
//
// Bit budget: |dx|, dy <= 2^29 and 256*y - y0 <= dy < 2^30, so |N| <= 2^37 + 2^59 and set-up needs int64
// (divided in 32 bits where the numerator fits). Stepping is int32: the error lies in [-dy, 0) and a
// remainder in [0, dy), so their sum stays within 2^30; |x| <= 2^21 on rows of the edge, |dx/dy| <= 2^29.
// Error: none. Textbook: section 2.6.3, with erratum E3. Worst known input: 16.16 slopes drift by a pixel on
// 0.35 % of the rows of a 1024-row edge; int16 products wrap for (314,11)(14,200)(97,237).
#pragma once

#include <intaglio/linear/point.hpp>

namespace intaglio::raster {

/// The first row whose centre isn't above `y` (in 1/256 pixel); also the first column not left of an x.
[[nodiscard]] constexpr int ceil_to_pixel(int y) noexcept {
  return (y + (linear::subpixel_one - 1)) >> linear::subpixel_bits;
}

/// Walks an edge downwards. Trivially copyable, 20 bytes.
class Edge {
 public:
  /// No edge yet; call `start`.
  Edge() noexcept = default;
  Edge(const linear::SubPoint& top, const linear::SubPoint& bottom, int row) noexcept {
    start(top, bottom, row);
  }

  /// Becomes the edge between two points of the domain, standing on `row`.
  /// Precondition: top.y < bottom.y and ceil(top.y/256) <= row < ceil(bottom.y/256).
  void start(const linear::SubPoint& top, const linear::SubPoint& bottom, int row) noexcept;

  /// The first pixel of this row whose centre isn't left of the edge.
  [[nodiscard]] constexpr int x() const noexcept { return x_; }

  /// Goes to the row below. The result means nothing past the edge's last row. Always inlined: optimising for
  /// size, compilers would keep the edge in memory and call this for each row.
  [[gnu::always_inline]] constexpr void next() noexcept {
    int x = x_ + step_;
    int error = error_ + remainder_;
    if (error >= 0) {
      error -= height_;
      --x;
    }
    x_ = x;
    error_ = error;
  }

 private:
  // x_ * height_ - M = error_ + height_: the distance to the exact crossing, in 1/height_ pixel, less height_
  // so that its sign says when to carry.
  int x_;
  int error_;
  int step_;
  int remainder_;
  int height_;
};

}  // namespace intaglio::raster
