// SPDX-License-Identifier: MIT
//
// An octant of a circle, walked without roots, and the exact search that starts the walk anywhere.
//
// Rule: for 0 <= t <= v the outline of radius r has the pixel (t, v), v the integer nearest to
// sqrt(r^2 - t^2), that is (v - 1/2)^2 < r^2 - t^2 < (v + 1/2)^2; the seven other octants mirror it. With
// e = t^2 + v^2 - v - r^2 "v is near enough" reads e < 0: a step of t adds 2t + 1, a step of v takes 2v - 2.
// Within the octant v falls by at most one a step, so one comparison a step is exact.
//
// Bit budget: r <= 2^20, so r^2 has 41 bits; it is formed only to start. On the octant -2v <= e < 0, and
// before v steps e <= 2t, so the walk stays within 2^22: int32.
// Error: none. Textbook: section 2.4 (Hanrahan's variant). Worst known inputs: r > 46340 (squares leave
// int32), r = 0, 1, 2 (mirrored pixels coincide on the axes and diagonals).
#pragma once

#include <intaglio/linear/point.hpp>

namespace intaglio::raster {

/// How far the disc of this radius reaches to either side on the rows `distance` above and below its centre;
/// -1 where it has no pixel. Also its reach up and down on a column. Exact; 0 <= distance, radius in the
/// domain.
/// Cost: a multiplication and a comparison for each binary digit of the radius.
[[nodiscard]] int half_chord(int radius, int distance) noexcept;

/// Walks the octant from t = `t` on.
class Octant {
 public:
  /// Precondition: 0 <= t <= radius.
  constexpr Octant(int radius, int t, int v) noexcept
      : t_(t),
        v_(v),
        error_(static_cast<int>(square(t) + square(v) - static_cast<unsigned>(v) - square(radius))) {}
  Octant(int radius, int t) noexcept : Octant(radius, t, half_chord(radius, t)) {}

  [[nodiscard]] constexpr int t() const noexcept { return t_; }
  [[nodiscard]] constexpr int v() const noexcept { return v_; }

  /// Steps t; true if v fell.
  constexpr bool next() noexcept {
    error_ += 2 * t_ + 1;
    ++t_;
    if (error_ < 0) return false;
    --v_;
    error_ -= 2 * v_;
    return true;
  }

 private:
  /// Modulo 2^32: the sum of the squares is small, so what is lost in them cancels.
  static constexpr unsigned square(int n) noexcept {
    return static_cast<unsigned>(n) * static_cast<unsigned>(n);
  }

  int t_;
  int v_;
  int error_;
};

}  // namespace intaglio::raster
