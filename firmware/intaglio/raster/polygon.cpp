// SPDX-License-Identifier: MIT
#include <intaglio/raster/polygon.hpp>

#include <algorithm>

namespace intaglio::raster {

namespace detail {

PolygonScan::PolygonScan(FillRule rule, const linear::Rect& clip,
                         const std::span<PolygonEdge>& edges) noexcept
    : edges_(edges), clip_(clip), mask_(winding_mask(rule)) {}

Status PolygonScan::prepare(const std::span<const linear::SubPoint>& vertices,
                            const std::span<const int>& contour_lengths) noexcept {
  if (mask_ == 0) return {Error::out_of_range, Argument::rule};
  const Status status = check_contours(vertices, contour_lengths);
  if (!status.ok()) return status;
  if (clip_.empty()) return {};

  const linear::SubPoint* contour = vertices.data();
  for (const int length : contour_lengths) {
    if (length >= 3) add_contour(contour, contour + length);
    contour += length;
  }
  if (count_ > edges_.size()) return {Error::too_small, Argument::workspace, count_};
  if (count_ > 0) waiting_ = sorted(0, static_cast<int>(count_));
  return {};
}

void PolygonScan::add_contour(const linear::SubPoint* vertices, const linear::SubPoint* end) noexcept {
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
void PolygonScan::add_edge(const linear::SubPoint& from, const linear::SubPoint& to) noexcept {
  const bool upwards = to.y < from.y;
  const linear::SubPoint& top = upwards ? to : from;
  const linear::SubPoint& bottom = upwards ? from : to;
  const int row = std::max(ceil_to_pixel(top.y), clip_.y);
  const int end = std::min(ceil_to_pixel(bottom.y), clip_.bottom());
  if (row >= end) return;
  if (count_ < edges_.size()) {
    PolygonEdge& edge = edges_[count_];
    edge.edge_.start(top, bottom, row);
    edge.row_ = row;
    edge.end_ = 2 * end + (upwards ? 1 : 0);
  }
  ++count_;
}

bool PolygonScan::before(int a, int b) noexcept {
  const PolygonEdge& first = at(a);
  const PolygonEdge& second = at(b);
  return first.row_ != second.row_ ? first.row_ < second.row_ : first.edge_.x() < second.edge_.x();
}

/// Merges two sorted lists.
int PolygonScan::merged(int a, int b) noexcept {
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
int PolygonScan::sorted(int begin, int end) noexcept {
  if (end - begin == 1) {
    at(begin).next_ = none;
    return begin;
  }
  const int middle = begin + (end - begin) / 2;
  const int first = sorted(begin, middle);
  return merged(first, sorted(middle, end));
}

bool PolygonScan::next(RowSpan& span) noexcept {
  for (;;) {
    int x = clip_.right();
    const bool was_inside = inside();
    if (cursor_ != none) {
      const PolygonEdge& edge = at(cursor_);
      cursor_ = edge.next_;
      winding_ += (edge.end_ & 1) != 0 ? -1 : 1;
      if (was_inside == inside()) continue;
      x = edge.edge_.x();
    } else if (was_inside) {
      // The edge that ends this span is right of the window and not kept.
      winding_ = 0;
    } else {
      if (!next_row()) return false;
      continue;
    }
    if (!was_inside) {
      span.x_begin = std::max(x, clip_.x);
    } else {
      span.y = y_;
      span.x_end = std::min(x, clip_.right());
      if (span.x_begin < span.x_end) return true;
    }
  }
}

/// Goes to the next row that any edge crosses and puts these edges in order.
bool PolygonScan::next_row() noexcept {
  int head = none;
  int last = none;
  const auto insert = [&](int index) {
    PolygonEdge& edge = at(index);
    const int x = edge.edge_.x();
    int* link = &head;
    if (last == none || at(last).edge_.x() <= x) {
      if (last != none) link = &at(last).next_;
      last = index;
      edge.next_ = none;
    } else {
      // Its place is before the last, so the search ends there.
      while (at(*link).edge_.x() <= x) link = &at(*link).next_;
      edge.next_ = *link;
    }
    *link = index;
  };

  ++y_;
  for (int i = active_, following; i != none; i = following) {
    PolygonEdge& edge = at(i);
    following = edge.next_;
    if (edge.end_ >> 1 <= y_) continue;
    edge.edge_.next();
    insert(i);
  }
  if (head == none && waiting_ == none) return false;
  if (head == none) y_ = at(waiting_).row_;
  while (waiting_ != none && at(waiting_).row_ == y_) {
    const int first = waiting_;
    waiting_ = at(first).next_;
    insert(first);
  }
  active_ = cursor_ = head;
  winding_ = 0;
  return true;
}

}  // namespace detail

Result<std::uint32_t> polygon_workspace(const std::span<const linear::SubPoint>& vertices,
                                        const std::span<const int>& contour_lengths,
                                        const linear::Rect& clip) noexcept {
  if (!linear::in_domain(clip)) return Status{Error::out_of_domain, Argument::rectangle};
  detail::PolygonScan scan(FillRule::even_odd, clip, {});
  const Status status = scan.prepare(vertices, contour_lengths);
  if (!status.ok() && status.argument() != Argument::workspace) return status;
  return scan.count();
}

}  // namespace intaglio::raster
