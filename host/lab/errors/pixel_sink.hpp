// SPDX-License-Identifier: MIT
//
// A sink that keeps which pixels were drawn, for comparing with those that should be.
#pragma once

#include <intaglio/linear/rect.hpp>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace host::lab {

using Pixels = std::vector<std::pair<int, int>>;  // (y, x)

/// Keeps pixels in the order in which they are drawn; `pixels` is the caller's.
class PixelSink {
 public:
  PixelSink(const intaglio::linear::Rect& clip, Pixels& pixels) : clip_(clip), pixels_(&pixels) {}
  [[nodiscard]] const intaglio::linear::Rect& clip() const { return clip_; }
  void span(int y, int x_begin, int x_end) const {
    for (int x = x_begin; x < x_end; ++x) pixels_->emplace_back(y, x);
  }

 private:
  intaglio::linear::Rect clip_;
  Pixels* pixels_;
};

/// How many pixels are in one list and not in the other, each pixel counted once.
inline int differences(Pixels a, Pixels b) {
  for (Pixels* list : {&a, &b}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  Pixels wrong;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(wrong));
  return static_cast<int>(wrong.size());
}

}  // namespace host::lab
