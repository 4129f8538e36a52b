// SPDX-License-Identifier: MIT
//
// A coverage sink that remembers the level of each pixel, and whether a primitive broke the sink's contract
// (an empty span, one outside the clip, a level outside 1 .. 255, a pixel twice).
#pragma once

#include <intaglio/linear/rect.hpp>

#include <cstddef>
#include <vector>

namespace oracle {

/// Remembers the levels, and what broke the contract.
class LevelSink {
 public:
  explicit LevelSink(const intaglio::linear::Rect& clip)
      : clip_(clip), levels_(static_cast<std::size_t>(clip.width) * static_cast<std::size_t>(clip.height)) {}
  [[nodiscard]] const intaglio::linear::Rect& clip() const { return clip_; }
  void span(int y, int x_begin, int x_end, int coverage) {
    ++spans_;
    const bool inside = y >= clip_.y && y < clip_.y + clip_.height && x_begin >= clip_.x && x_begin < x_end &&
                        x_end <= clip_.x + clip_.width;
    bad_ |= !inside || coverage < 1 || coverage > 255;
    if (!inside) return;
    for (int x = x_begin; x < x_end; ++x) {
      bad_ |= level(x, y) != 0;
      levels_[index(x, y)] = coverage;
    }
  }
  [[nodiscard]] int level(int x, int y) const { return levels_[index(x, y)]; }
  [[nodiscard]] bool bad() const { return bad_; }
  [[nodiscard]] int spans() const { return spans_; }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - clip_.y) * static_cast<std::size_t>(clip_.width) +
           static_cast<std::size_t>(x - clip_.x);
  }
  intaglio::linear::Rect clip_;
  std::vector<int> levels_;
  int spans_ = 0;
  bool bad_ = false;
};

}  // namespace oracle
