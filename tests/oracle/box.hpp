// SPDX-License-Identifier: MIT
//
// Oracle: the mean over the box of a stretched picture's pixel, straight from the rule.
#pragma once

#include <algorithm>
#include <cstdint>

namespace oracle {

/// w * h times the mean over the box of pixel (x, y) of to_w x to_h, of a source of w x h whose whole values
/// are value(column, row). Sides to 2^15 and values to 255 stay below 2^38.
template <class Value>
std::int64_t box_sum(int x, int y, int w, int h, int to_w, int to_h, Value value) {
  // How much of source pixel i lies in the box of pixel `at`, in 1/to.
  const auto common = [](std::int64_t at, std::int64_t i, std::int64_t from, std::int64_t to) {
    return std::max<std::int64_t>(std::min((i + 1) * to, (at + 1) * from) - std::max(i * to, at * from), 0);
  };
  std::int64_t sum = 0;
  for (auto row = std::int64_t{y} * h / to_h; row < h && row * to_h < (std::int64_t{y} + 1) * h; ++row)
    for (auto column = std::int64_t{x} * w / to_w; column < w && column * to_w < (std::int64_t{x} + 1) * w;
         ++column)
      sum += common(x, column, w, to_w) * common(y, row, h, to_h) *
             value(static_cast<int>(column), static_cast<int>(row));
  return sum;
}

}  // namespace oracle
