// SPDX-License-Identifier: MIT
//
// What of a frame has changed: a short list of rectangles that a panel takes as partial writes.
//
// Rule: the union of the list covers every rectangle added, cut to the frame; each rectangle lies inside the
// frame and keeps the alignment; no two overlap, so no pixel is sent twice. A rectangle that overlaps
// another, or that makes a rectangle with it without waste, is united with it; if the list is full, the new
// one is united with the one that grows least. So the list may cover more than was asked, never less. Bit
// budget: rectangles come from the coordinate domain, so after the cut sides are at most 2^20 and areas at
// most 2^40.
#pragma once

#include <intaglio/linear/rect.hpp>
#include <intaglio/status.hpp>

#include <array>
#include <span>

namespace intaglio::present {

class DirtyList {
 public:
  /// Rectangles at most; one write of the panel each.
  static constexpr int capacity = 8;

  /// Of a frame of this size (sides within the domain) on a panel whose rectangles begin and end at multiples
  /// of the alignments (at least 1) or at the frame's far edges.
  constexpr DirtyList(linear::Size frame, int x_alignment, int y_alignment) noexcept
      : frame_(frame), x_alignment_(x_alignment), y_alignment_(y_alignment) {}

  /// Adds what of `rect` is inside the frame. Errors: rectangle (out of domain), and nothing is added.
  [[nodiscard]] Status add(const linear::Rect& rect) noexcept;
  /// Adds the whole frame.
  void add_all() noexcept;
  void clear() noexcept { count_ = 0; }

  [[nodiscard]] std::span<const linear::Rect> rects() const noexcept {
    return std::span(rects_).first(static_cast<std::size_t>(count_));
  }

 private:
  void insert(linear::Rect rect) noexcept;
  /// Takes rectangle `index` off the list.
  linear::Rect take(int index) noexcept;

  linear::Size frame_;
  int x_alignment_;
  int y_alignment_;
  int count_ = 0;
  std::array<linear::Rect, capacity> rects_{};
};

}  // namespace intaglio::present
