// SPDX-License-Identifier: MIT
//
// Oracle: bilinear interpolation of a stretched picture in real numbers, straight from the rule.
#pragma once

#include <algorithm>
#include <cmath>

namespace oracle {

/// The value of pixel (x, y) of to_w x to_h, of a source of w x h whose values are value(column, row).
template <class Value>
double bilinear(int x, int y, int w, int h, int to_w, int to_h, Value value) {
  const auto place = [](int at, int from, int to) {
    const double centre = (2.0 * at + 1) * from / (2.0 * to) - 0.5;
    return std::clamp(centre, 0.0, from - 1.0);
  };
  const double u = place(x, w, to_w);
  const double v = place(y, h, to_h);
  const int column = static_cast<int>(std::floor(u));
  const int row = static_cast<int>(std::floor(v));
  const int right = std::min(column + 1, w - 1);
  const int below = std::min(row + 1, h - 1);
  const double a = value(column, row) * (column + 1 - u) + value(right, row) * (u - column);
  const double b = value(column, below) * (column + 1 - u) + value(right, below) * (u - column);
  return a * (row + 1 - v) + b * (v - row);
}

}  // namespace oracle
