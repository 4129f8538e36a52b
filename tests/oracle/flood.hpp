// SPDX-License-Identifier: MIT
//
// The region of a flood fill by breadth-first search, pixel by pixel on a plain array.
#pragma once

#include <intaglio/linear/rect.hpp>

#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace oracle {

/// 1 for each pixel of a width x height picture that the seed reaches inside the clip over pixels that
/// `belongs` says belong, 0 for the others.
inline std::vector<int> region(int width, int height, const intaglio::linear::Rect& clip, bool eight, int x,
                               int y, const std::function<bool(int, int)>& belongs) {
  std::vector<int> reached(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::queue<std::pair<int, int>> rim;
  const auto visit = [&](int px, int py) {
    if (px < 0 || py < 0 || px >= width || py >= height) return;
    if (px < clip.x || py < clip.y || px >= clip.x + clip.width || py >= clip.y + clip.height) return;
    int& mark = reached[static_cast<std::size_t>(py) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(px)];
    if (mark != 0 || !belongs(px, py)) return;
    mark = 1;
    rim.emplace(px, py);
  };
  visit(x, y);
  while (!rim.empty()) {
    const auto [px, py] = rim.front();
    rim.pop();
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (eight || dx == 0 || dy == 0) visit(px + dx, py + dy);
  }
  return reached;
}

}  // namespace oracle
