// SPDX-License-Identifier: MIT
#include <intaglio/present/dirty_list.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace intaglio::present {

namespace {

using linear::Rect;

std::int64_t area(const Rect& r) noexcept { return static_cast<std::int64_t>(r.width) * r.height; }

Rect unite(const Rect& a, const Rect& b) noexcept {
  const int x = std::min(a.x, b.x);
  const int y = std::min(a.y, b.y);
  return {x, y, std::max(a.right(), b.right()) - x, std::max(a.bottom(), b.bottom()) - y};
}

/// Pixels that the union has more than the two together; below zero if they overlap.
std::int64_t waste(const Rect& a, const Rect& b) noexcept { return area(unite(a, b)) - area(a) - area(b); }

/// Widens begin .. end to multiples of `alignment`, but not beyond `limit`. 0 <= begin < end <= limit.
void align(int& begin, int& end, int alignment, int limit) noexcept {
  begin -= begin % alignment;
  const int beyond = end % alignment;
  if (beyond != 0) end = std::min(limit - end > alignment - beyond ? end + alignment - beyond : limit, limit);
}

}  // namespace

Status DirtyList::add(const Rect& rect) noexcept {
  if (!linear::in_domain(rect)) return {Error::out_of_domain, Argument::rectangle};
  const Rect cut = linear::intersect(rect, {0, 0, frame_.width, frame_.height});
  if (cut.empty()) return {};
  int left = cut.x;
  int right = cut.right();
  int top = cut.y;
  int bottom = cut.bottom();
  align(left, right, x_alignment_, frame_.width);
  align(top, bottom, y_alignment_, frame_.height);
  insert({left, top, right - left, bottom - top});
  return {};
}

void DirtyList::add_all() noexcept {
  rects_[0] = {0, 0, frame_.width, frame_.height};
  count_ = 1;
}

Rect DirtyList::take(int index) noexcept {
  Rect& place = rects_[static_cast<std::size_t>(index)];
  const Rect taken = place;
  place = rects_[static_cast<std::size_t>(--count_)];
  return taken;
}

void DirtyList::insert(Rect rect) noexcept {
  // Each round either ends or takes one rectangle off the list, so there are at most capacity + 1.
  for (;;) {
    int best = -1;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (int i = 0; i < count_; ++i) {
      const Rect& other = rects_[static_cast<std::size_t>(i)];
      // An overlap goes first: the list must not send a pixel twice.
      const std::int64_t cost = linear::intersect(other, rect).empty() ? waste(other, rect) : -1;
      if (cost < least) {
        least = cost;
        best = i;
      }
    }
    if (best < 0 || (least > 0 && count_ < capacity)) break;
    rect = unite(rect, take(best));
  }
  rects_[static_cast<std::size_t>(count_++)] = rect;
}

}  // namespace intaglio::present
