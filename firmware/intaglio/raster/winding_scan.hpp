// SPDX-License-Identifier: MIT
//
// The rows of edges that wind around an area: what filled polygons and strokes have in common.
//
// Rule: on each row the crossings of the edges stand in order of x, each at the first pixel right of its
// edge; past it the winding number has changed by one, up or down as the edge runs. A pixel belongs to the
// area iff the winding number's bits that the mask names aren't all zero there.
//
// The edges that have visible rows, sorted by first row, wait in one list; those that cross the present row
// stand in another, sorted by x. Both lists live in the caller's workspace. What can't be seen costs neither
// memory nor rows: edges above, below or right of the clip are dropped, edges across its top start on its
// first row, and every chain of edges left of it shrinks to one upright edge at its side, which winds the
// same.
//
// Bit budget: edge.hpp; windings and edge counts are below 2^31. Error: none. Textbook: section 2.6.3.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/edge.hpp>
#include <intaglio/raster/row_span.hpp>
#include <intaglio/status.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::raster::detail {

/// The spans of an area, row by row. An `Entry` of the workspace is an edge (`start`, `x`, `next` as of
/// `Edge`) and has the scan's own row_, end_ and next_.
template <class Entry>
class WindingScan {
 public:
  /// Edges that have visible rows.
  [[nodiscard]] std::uint32_t count() const noexcept { return count_; }
  /// Puts the next span in `span`; false if there is none.
  [[nodiscard]] bool next(RowSpan& span) noexcept;

 protected:
  WindingScan(int mask, const linear::Rect& clip, const std::span<Entry>& entries) noexcept
      : entries_(entries), clip_(clip), mask_(mask) {}

  [[nodiscard]] const linear::Rect& clip() const noexcept { return clip_; }
  [[nodiscard]] int mask() const noexcept { return mask_; }
  /// Takes in a closed contour of three or more vertices.
  void add_contour(const linear::SubPoint* vertices, const linear::SubPoint* end) noexcept;
  /// A place for an edge that has the visible rows row .. end-1; null if the workspace is too small.
  [[nodiscard, gnu::always_inline]] Entry* add_entry(int row, int end, bool upwards) noexcept {
    Entry* entry = nullptr;
    if (count_ < entries_.size()) {
      entry = &entries_[count_];
      entry->row_ = row;
      entry->end_ = 2 * end + (upwards ? 1 : 0);
    }
    ++count_;
    return entry;
  }
  /// When all is taken in: puts the edges in order. Errors: workspace (too small: `needed()` entries).
  [[nodiscard, gnu::always_inline]] Status sort() noexcept {
    if (count_ > entries_.size()) return {Error::too_small, Argument::workspace, count_};
    if (count_ > 0) waiting_ = sorted(0, static_cast<int>(count_));
    return {};
  }

 private:
  static constexpr int none = -1;

  void add_edge(const linear::SubPoint& from, const linear::SubPoint& to) noexcept;
  [[nodiscard]] Entry& at(int index) noexcept { return entries_[static_cast<std::size_t>(index)]; }
  [[nodiscard]] bool before(int a, int b) noexcept;
  [[nodiscard]] int merged(int a, int b) noexcept;
  [[nodiscard]] int sorted(int begin, int end) noexcept;
  [[nodiscard, gnu::always_inline]] int pass_edge() noexcept;
  int* insert(int index, int* link) noexcept;
  [[nodiscard]] bool next_row() noexcept;
  /// The link of the active list that leads to the entry after this one.
  [[nodiscard]] int& link_after(int index) noexcept { return index == none ? active_ : at(index).next_; }

  std::span<Entry> entries_;
  linear::Rect clip_;
  int mask_;            // of the winding: which of its bits mean inside
  int waiting_ = none;  // sorted by first row, then x
  int active_ = none;   // sorted by x: those before the cursor on row y_ + 1, the others on y_
  int cursor_ = none;   // next of the active edges on this row
  int stepped_ = none;  // the last of those before it that is still active
  int stepped_x_ = 0;   // its x
  int winding_ = 0;     // left of the cursor
  int y_ = 0;
  std::uint32_t count_ = 0;
};

template <class Entry>
void WindingScan<Entry>::add_contour(const linear::SubPoint* vertices, const linear::SubPoint* end) noexcept {
  // An edge is beside the window if no pixel centre inside is to its left (left of it) or right (right of
  // it).
  const int left = clip_.x * linear::subpixel_one;
  const int right = (clip_.right() - 1) * linear::subpixel_one;
  const linear::SubPoint* from = end - 1;
  int chain = from->y;  // where the chain of edges left of the window began
  for (const linear::SubPoint* to = vertices; to != end; from = to++) {
    if (from->x <= left && to->x <= left) continue;
    if (chain != from->y) add_edge({left, chain}, {left, from->y});
    chain = to->y;
    if (from->x <= right || to->x <= right) add_edge(*from, *to);
  }
  add_edge({left, chain}, {left, from->y});
}

/// Stores an edge if it has visible rows.
template <class Entry>
void WindingScan<Entry>::add_edge(const linear::SubPoint& from, const linear::SubPoint& to) noexcept {
  const bool upwards = to.y < from.y;
  const linear::SubPoint& top = upwards ? to : from;
  const linear::SubPoint& bottom = upwards ? from : to;
  const int row = std::max(ceil_to_pixel(top.y), clip_.y);
  const int end = std::min(ceil_to_pixel(bottom.y), clip_.bottom());
  if (row >= end) return;
  if (Entry* const entry = add_entry(row, end, upwards)) entry->start(top, bottom, row);
}

template <class Entry>
bool WindingScan<Entry>::before(int a, int b) noexcept {
  const Entry& first = at(a);
  const Entry& second = at(b);
  return first.row_ != second.row_ ? first.row_ < second.row_ : first.x() < second.x();
}

/// Merges two sorted lists.
template <class Entry>
int WindingScan<Entry>::merged(int a, int b) noexcept {
  int head = none;
  int* tail = &head;
  while (a != none && b != none) {
    int& lesser = before(b, a) ? b : a;
    *tail = lesser;
    tail = &at(lesser).next_;
    lesser = *tail;
  }
  *tail = a != none ? a : b;
  return head;
}

/// The edges begin .. end-1 as a sorted list. The depth of the recursion is log2 of their number.
template <class Entry>
int WindingScan<Entry>::sorted(int begin, int end) noexcept {
  if (end - begin == 1) {
    at(begin).next_ = none;
    return begin;
  }
  const int middle = begin + (end - begin) / 2;
  const int first = sorted(begin, middle);
  return merged(first, sorted(middle, end));
}

template <class Entry>
bool WindingScan<Entry>::next(RowSpan& span) noexcept {
  for (bool inside = false;;) {
    int x = clip_.right();
    if (cursor_ != none) {
      x = pass_edge();
      if (inside == ((winding_ & mask_) != 0)) continue;
    } else if (inside) {
      // The edge that ends this span is right of the window and not kept.
      winding_ = 0;
    } else {
      if (!next_row()) return false;
      continue;
    }
    inside = !inside;
    if (inside) {
      span.x_begin = std::max(x, clip_.x);
    } else {
      span.x_end = std::min(x, clip_.right());
      if (span.x_begin >= span.x_end) continue;
      span.y = y_;
      return true;
    }
  }
}

/// Goes past the edge at the cursor, which goes on to its next row, and says where that was.
template <class Entry>
inline int WindingScan<Entry>::pass_edge() noexcept {
  const int index = cursor_;
  Entry& edge = at(index);
  const int x = edge.x();
  winding_ += 1 - 2 * (edge.end_ & 1);
  cursor_ = edge.next_;
  const bool goes_on = edge.end_ >> 1 != y_ + 1;
  if (goes_on) {
    edge.next();
    if (edge.x() >= stepped_x_) {
      stepped_ = index;
      stepped_x_ = edge.x();
      return x;
    }
  }
  // It ends here, or crossed others on its step.
  link_after(stepped_) = cursor_;
  if (goes_on) insert(index, &active_);
  return x;
}

/// Puts an entry in its place in the active list, which isn't before this link. The link behind it.
template <class Entry>
int* WindingScan<Entry>::insert(int index, int* link) noexcept {
  Entry& edge = at(index);
  const int x = edge.x();
  while (*link != none && at(*link).x() <= x) link = &at(*link).next_;
  edge.next_ = *link;
  *link = index;
  return &edge.next_;
}

/// Goes to the next row that any edge crosses.
template <class Entry>
bool WindingScan<Entry>::next_row() noexcept {
  ++y_;
  if (active_ == none) {
    if (waiting_ == none) return false;
    y_ = at(waiting_).row_;
  }
  for (int* link = &active_; waiting_ != none && at(waiting_).row_ == y_;) {
    const int first = waiting_;
    waiting_ = at(first).next_;
    link = insert(first, link);
  }
  cursor_ = active_;
  stepped_ = none;
  stepped_x_ = INT32_MIN;
  winding_ = 0;
  return true;
}

}  // namespace intaglio::raster::detail
