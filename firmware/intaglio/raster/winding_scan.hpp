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
  WindingScan(const WindingScan&) = delete;
  WindingScan& operator=(const WindingScan&) = delete;

  /// Edges that have visible rows.
  [[nodiscard]] std::uint32_t count() const noexcept { return count_; }
  /// Puts the next span in `span`; false if there is none.
  [[nodiscard]] bool next(RowSpan& span) noexcept;

 protected:
  WindingScan(int mask, const linear::Rect& clip, const std::span<Entry>& entries) noexcept
      : entries_(entries), clip_(clip), mask_(mask) {}
  ~WindingScan() = default;

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
      entry->end_ = 4 * end + (upwards ? 2 : 0);
    }
    ++count_;
    return entry;
  }
  /// When all is taken in: puts the edges in order. Errors: workspace (too small: `needed()` entries).
  [[nodiscard, gnu::always_inline]] Status sort() noexcept {
    if (count_ > entries_.size()) return {Error::too_small, Argument::workspace, count_};
    if (count_ > 0) waiting_ = sorted(entries_.data(), count_);
    return {};
  }

 private:
  // An entry's end_: the row after its last above two bits, of which the upper is set if it runs upwards.
  [[nodiscard]] static constexpr int end_row(int end) noexcept { return end >> 2; }
  [[nodiscard]] static constexpr int turn(int end) noexcept { return 1 - (end & 2); }

  /// Goes along the active edges of a row.
  struct Cursor {
    Entry** link;  // leads to the next edge on the row
    int x;         // of the edge before it, a row further down
  };

  [[nodiscard]] Cursor row_start() noexcept { return {&active_, INT32_MIN}; }
  void add_edge(const linear::SubPoint& from, const linear::SubPoint& to) noexcept;
  [[nodiscard]] static bool before(const Entry& a, const Entry& b) noexcept;
  [[nodiscard]] static Entry* merged(Entry* a, Entry* b) noexcept;
  [[nodiscard]] static Entry* sorted(Entry* entries, std::uint32_t count) noexcept;
  void pass_edge(Cursor& cursor, Entry& edge) noexcept;
  void put_back(Entry& edge) noexcept;
  static Entry** insert(Entry& edge, Entry** link) noexcept;
  [[nodiscard]] bool next_row() noexcept;

  std::span<Entry> entries_;
  linear::Rect clip_;
  int mask_;                  // of the winding: which of its bits mean inside
  Entry* waiting_ = nullptr;  // sorted by first row, then x
  Entry* active_ = nullptr;   // sorted by x: those before the cursor on row y_ + 1, the others on y_
  Cursor cursor_ = row_start();
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
bool WindingScan<Entry>::before(const Entry& a, const Entry& b) noexcept {
  return a.row_ != b.row_ ? a.row_ < b.row_ : a.x() < b.x();
}

/// Merges two sorted lists.
template <class Entry>
Entry* WindingScan<Entry>::merged(Entry* a, Entry* b) noexcept {
  Entry* head = nullptr;
  Entry** tail = &head;
  while (a != nullptr && b != nullptr) {
    Entry*& lesser = before(*b, *a) ? b : a;
    *tail = lesser;
    tail = &lesser->next_;
    lesser = *tail;
  }
  *tail = a != nullptr ? a : b;
  return head;
}

/// So many entries as a sorted list. The depth of the recursion is log2 of their number.
template <class Entry>
Entry* WindingScan<Entry>::sorted(Entry* entries, std::uint32_t count) noexcept {
  if (count == 1) {
    entries->next_ = nullptr;
    return entries;
  }
  const std::uint32_t half = count / 2;
  Entry* const first = sorted(entries, half);
  return merged(first, sorted(entries + half, count - half));
}

template <class Entry>
bool WindingScan<Entry>::next(RowSpan& span) noexcept {
  Cursor cursor = cursor_;
  for (;;) {
    Entry* edge = *cursor.link;
    if (edge == nullptr) {
      if (!next_row()) return false;
      edge = active_;
      cursor = row_start();
    }
    // Nothing winds around what lies between two spans, so the first edge begins one.
    const int x_begin = std::max(edge->x(), clip_.x);
    int winding = turn(edge->end_);
    pass_edge(cursor, *edge);
    // The edge that ends it isn't kept if it is right of the window.
    int x_end = clip_.right();
    while ((edge = *cursor.link) != nullptr) {
      const int x = edge->x();
      winding += turn(edge->end_);
      pass_edge(cursor, *edge);
      if ((winding & mask_) == 0) {
        x_end = std::min(x, x_end);
        break;
      }
    }
    if (x_begin < x_end) {
      cursor_ = cursor;
      span = {y_, x_begin, x_end};
      return true;
    }
  }
}

/// Goes past the edge at the cursor, which goes on to its next row.
template <class Entry>
[[gnu::always_inline]] inline void WindingScan<Entry>::pass_edge(Cursor& cursor, Entry& edge) noexcept {
  const bool goes_on = end_row(edge.end_) != y_ + 1;
  if (goes_on) [[likely]] {
    edge.next();
    if (edge.x() >= cursor.x) [[likely]] {
      cursor.x = edge.x();
      cursor.link = &edge.next_;
      return;
    }
  }
  *cursor.link = edge.next_;
  if (goes_on) put_back(edge);
}

/// Finds the place of an edge that crossed others on its step. Rare, and never inlined, so that the loop over
/// the edges keeps its registers.
template <class Entry>
[[gnu::noinline]] void WindingScan<Entry>::put_back(Entry& edge) noexcept {
  insert(edge, &active_);
}

/// Puts an edge in its place in the active list, which isn't before this link. The link behind it.
template <class Entry>
Entry** WindingScan<Entry>::insert(Entry& edge, Entry** link) noexcept {
  const int x = edge.x();
  while (*link != nullptr && (*link)->x() <= x) link = &(*link)->next_;
  edge.next_ = *link;
  *link = &edge;
  return &edge.next_;
}

/// Goes to the next row that any edge crosses.
template <class Entry>
bool WindingScan<Entry>::next_row() noexcept {
  ++y_;
  if (active_ == nullptr) {
    if (waiting_ == nullptr) return false;
    y_ = waiting_->row_;
  }
  for (Entry** link = &active_; waiting_ != nullptr && waiting_->row_ == y_;) {
    Entry& first = *waiting_;
    waiting_ = first.next_;
    link = insert(first, link);
  }
  return true;
}

}  // namespace intaglio::raster::detail
