// SPDX-License-Identifier: MIT
//
// A sink that only counts, for pictures too large to remember.
#pragma once

#include <intaglio/linear/rect.hpp>

#include <cstdint>

namespace oracle {

class CountingSink {
 public:
  explicit CountingSink(const intaglio::linear::Rect& clip) : clip_(clip) {}

  [[nodiscard]] const intaglio::linear::Rect& clip() const { return clip_; }
  void span(int /*y*/, int x_begin, int x_end) {
    ++spans_;
    pixels_ += std::int64_t{x_end} - x_begin;
  }
  [[nodiscard]] std::int64_t pixels() const { return pixels_; }
  [[nodiscard]] std::int64_t spans() const { return spans_; }

 private:
  intaglio::linear::Rect clip_;
  std::int64_t pixels_ = 0;
  std::int64_t spans_ = 0;
};

}  // namespace oracle
