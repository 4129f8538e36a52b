// SPDX-License-Identifier: MIT
//
// Oracle: bilinear interpolation of a turned picture in real numbers, straight from the rule.
#pragma once

#include <tests/oracle/turned_place.hpp>

#include <cmath>

namespace oracle {

/// Sets `exact` to the value that pixel (x, y) shows of a source of w x h, turned by `steps` / 65536 of a
/// turn about its `pivot_x`, `pivot_y`, which lies on (at_x, at_y); all in pixels. False outside the
/// outermost centres.
template <class Value>
bool turned_value(double x, double y, int w, int h, int steps, double pivot_x, double pivot_y, double at_x,
                  double at_y, Value value, double& exact) {
  const auto [u, v] = turned_place(x, y, steps, {pivot_x, pivot_y}, at_x, at_y);
  const int column = static_cast<int>(std::floor(u));
  const int row = static_cast<int>(std::floor(v));
  if (column < 0 || row < 0 || column + 1 >= w || row + 1 >= h) return false;
  const double a = value(column, row) * (column + 1 - u) + value(column + 1, row) * (u - column);
  const double b = value(column, row + 1) * (column + 1 - u) + value(column + 1, row + 1) * (u - column);
  exact = a * (row + 1 - v) + b * (v - row);
  return true;
}

}  // namespace oracle
