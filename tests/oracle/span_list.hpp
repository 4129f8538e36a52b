// SPDX-License-Identifier: MIT
//
// A sink that remembers the spans as they come, for pictures too large for a counter a pixel.
#pragma once

#include <intaglio/linear/rect.hpp>

#include <algorithm>
#include <tuple>
#include <vector>

namespace oracle {

/// The pixels (begin, y) .. (end - 1, y).
struct Span {
  int y, begin, end;
  bool operator==(const Span&) const = default;
};

class SpanList {
 public:
  explicit SpanList(const intaglio::linear::Rect& clip) : clip_(clip) {}
  /// With the whole domain as its clip.
  SpanList() : SpanList({-(1 << 20), -(1 << 20), 2 << 20, 2 << 20}) {}

  [[nodiscard]] const intaglio::linear::Rect& clip() const { return clip_; }
  void span(int y, int x_begin, int x_end) { spans_.push_back({y, x_begin, x_end}); }

  [[nodiscard]] const std::vector<Span>& spans() const { return spans_; }
  /// Row by row from the top, and from the left.
  [[nodiscard]] const std::vector<Span>& sorted() {
    const auto before = [](const Span& a, const Span& b) {
      return std::tie(a.y, a.begin, a.end) < std::tie(b.y, b.begin, b.end);
    };
    if (!std::is_sorted(spans_.begin(), spans_.end(), before))
      std::sort(spans_.begin(), spans_.end(), before);
    return spans_;
  }
  /// The same set of pixels as the fewest spans, row by row; a pixel drawn twice is the end of it: it shows
  /// as a span that overlaps the next.
  [[nodiscard]] std::vector<Span> joined() {
    std::vector<Span> runs;
    for (const Span& s : sorted()) {
      if (!runs.empty() && runs.back().y == s.y && runs.back().end == s.begin)
        runs.back().end = s.end;
      else
        runs.push_back(s);
    }
    return runs;
  }
  void clear() { spans_.clear(); }

 private:
  intaglio::linear::Rect clip_;
  std::vector<Span> spans_;
};

}  // namespace oracle
