// SPDX-License-Identifier: MIT
//
// Oracle: where a pixel of a turned and scaled picture comes from, in 128 bits, straight from the rule.
#pragma once

#include <tests/oracle/integer.hpp>

namespace oracle {

/// The map of one picture. Places are in 1/256 pixel, `cosine` and `sine` in 2^-15, `scale` in 2^-16.
struct Rotozoom {
  int x;
  int y;
  int pivot_x;
  int pivot_y;
  int cosine;
  int sine;
  int scale;

  /// factor / scale in 2^-16, to nearest; ties away from zero, so that the mirror image is exact.
  [[nodiscard]] Wide step(int factor) const {
    const Wide n = Wide{factor} * 131072;
    return n < 0 ? -nearest_quotient(-n, scale) : nearest_quotient(n, scale);
  }
  /// Twice the place on the source in 2^-24 pixel, along x and along y, for the target's pixel (px, py).
  [[nodiscard]] Wide twice_column(int px, int py) const {
    return Wide{131072} * pivot_x +
           2 * (step(cosine) * (Wide{256} * px - x) + step(sine) * (Wide{256} * py - y));
  }
  [[nodiscard]] Wide twice_row(int px, int py) const {
    return Wide{131072} * pivot_y +
           2 * (step(cosine) * (Wide{256} * py - y) - step(sine) * (Wide{256} * px - x));
  }
  /// The source's column and row, which may be any number.
  [[nodiscard]] Wide column(int px, int py) const {
    return nearest_quotient(twice_column(px, py), Wide{1} << 25);
  }
  [[nodiscard]] Wide row(int px, int py) const { return nearest_quotient(twice_row(px, py), Wide{1} << 25); }
};

}  // namespace oracle
