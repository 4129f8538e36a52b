// SPDX-License-Identifier: MIT
//
// A sink that remembers: how often each pixel was drawn, and whether a primitive broke the sink's contract
// (an empty span, a span outside the clip).
//
// It takes spans only, so a primitive can be compared with what it sends to sinks that also have cursors and
// blocks. It shares no code with the library beyond the types of the interface.
#pragma once

#include <intaglio/linear/rect.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace oracle {

class RecordingSink {
 public:
  explicit RecordingSink(const intaglio::linear::Rect& clip)
      : clip_(clip), writes_(static_cast<std::size_t>(clip.width) * static_cast<std::size_t>(clip.height)) {}

  [[nodiscard]] const intaglio::linear::Rect& clip() const { return clip_; }

  void span(int y, int x_begin, int x_end) {
    ++spans_;
    if (x_begin >= x_end || y < clip_.y || y >= clip_.y + clip_.height || x_begin < clip_.x ||
        x_end > clip_.x + clip_.width) {
      if (violation_.empty())
        violation_ = "span y=" + std::to_string(y) + " x=" + std::to_string(x_begin) + ".." +
                     std::to_string(x_end) + " breaks the contract";
      return;
    }
    for (int x = x_begin; x < x_end; ++x) ++writes_[index(x, y)];
  }

  /// How often (x, y) was drawn; 0 outside the clip.
  [[nodiscard]] int writes(int x, int y) const {
    if (x < clip_.x || y < clip_.y || x >= clip_.x + clip_.width || y >= clip_.y + clip_.height) return 0;
    return writes_[index(x, y)];
  }
  /// Counters of the clip's pixels, row by row.
  [[nodiscard]] const std::vector<int>& all_writes() const { return writes_; }
  /// Pixels drawn at least once.
  [[nodiscard]] int touched() const {
    int n = 0;
    for (int w : writes_) n += w > 0 ? 1 : 0;
    return n;
  }
  /// The most often any pixel was drawn.
  [[nodiscard]] int most() const {
    int n = 0;
    for (int w : writes_) n = w > n ? w : n;
    return n;
  }
  [[nodiscard]] int spans() const { return spans_; }
  /// What the first bad span was; empty if all were good.
  [[nodiscard]] const std::string& violation() const { return violation_; }
  /// What is wrong with the drawing; empty if each pixel of the clip for which belongs(x, y) was drawn once,
  /// no other was, and the contract was kept.
  template <class Belongs>
  [[nodiscard]] std::string fault(Belongs belongs) const {
    if (!violation_.empty()) return violation_;
    for (int y = clip_.y; y < clip_.y + clip_.height; ++y)
      for (int x = clip_.x; x < clip_.x + clip_.width; ++x)
        if (writes_[index(x, y)] != (belongs(x, y) ? 1 : 0))
          return "pixel " + std::to_string(x) + "," + std::to_string(y) + " drawn " +
                 std::to_string(writes(x, y)) + " times\n" + (clip_.width < 100 ? ascii() : "");
    return "";
  }
  /// Rows of '.' (never), '#' (once) and digits (more often).
  [[nodiscard]] std::string ascii() const {
    std::string out;
    for (int y = clip_.y; y < clip_.y + clip_.height; ++y) {
      for (int x = clip_.x; x < clip_.x + clip_.width; ++x) {
        const int n = writes(x, y);
        out += n == 0 ? '.' : n == 1 ? '#' : static_cast<char>('0' + (n < 9 ? n : 9));
      }
      out += '\n';
    }
    return out;
  }
  void clear() {
    writes_.assign(writes_.size(), 0);
    spans_ = 0;
    violation_.clear();
  }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - clip_.y) * static_cast<std::size_t>(clip_.width) +
           static_cast<std::size_t>(x - clip_.x);
  }

  intaglio::linear::Rect clip_;
  std::vector<int> writes_;
  int spans_ = 0;
  std::string violation_;
};

}  // namespace oracle
