// SPDX-License-Identifier: MIT
//
// Oracle: where the pixels of a picture land that is turned by three shears, each followed forwards in 128
// bits, straight from the rule.
#pragma once

#include <tests/oracle/integer.hpp>

namespace oracle {

/// One picture of width x height pixels, in quarter turns and a rest. Places are in 1/256 pixel, `sine` and
/// `cosine` are the rest's, in 2^-15.
struct ThreeShear {
  int width;
  int height;
  int x;
  int y;
  int pivot_x;
  int pivot_y;
  int quarters;
  int sine;
  int cosine;

  struct Place {
    Wide x, y;
  };

  /// The target's pixel of a pixel of the source.
  [[nodiscard]] Place land(Wide column, Wide row) const {
    Wide px = pivot_x;
    Wide py = pivot_y;
    int w = width;
    int h = height;
    for (int i = 0; i < quarters; ++i) {
      const Wide new_column = h - 1 - row;
      row = column;
      column = new_column;
      const Wide new_px = Wide{256} * (h - 1) - py;
      py = px;
      px = new_px;
      const int new_w = h;
      h = w;
      w = new_w;
    }
    const Wide one = 32768;
    const Wide both = one + cosine;
    const Wide x1 = column + nearest_quotient(-sine * (256 * row - py), 256 * both);
    const Wide y2 = row + nearest_quotient(one * (y - py) + sine * (256 * x1 - px), 256 * one);
    const Wide x3 = x1 + nearest_quotient(both * (x - px) - sine * (256 * y2 - y), 256 * both);
    return {x3, y2};
  }
};

}  // namespace oracle
