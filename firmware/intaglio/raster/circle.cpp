// SPDX-License-Identifier: MIT
#include <intaglio/raster/circle.hpp>

#include <algorithm>
#include <utility>

namespace intaglio::raster::detail {

namespace {

constexpr int leftwards = 1;
constexpr int upwards = 2;
constexpr int steep = 4;

struct Interval {
  int first;
  int last;
};

/// The distances from `centre`, counted in one direction, of the coordinates begin .. end-1. May be negative.
Interval distances(int begin, int end, int centre, bool backwards) noexcept {
  if (backwards) return {centre - (end - 1), centre - begin};
  return {begin - centre, end - 1 - centre};
}

}  // namespace

CircleScan::CircleScan(linear::Point centre, int radius, const linear::Rect& clip) noexcept
    : centre_(centre),
      radius_(radius),
      clip_(clip),
      octant_(clip.empty() ? 7 : -1),
      walk_(radius, 0, radius) {}

/// Finds the visible interval of t of this octant.
void CircleScan::start() noexcept {
  const bool mirrored = (octant_ & ((octant_ & steep) != 0 ? upwards : leftwards)) != 0;
  Interval t = distances(clip_.x, clip_.right(), centre_.x, (octant_ & leftwards) != 0);
  Interval v = distances(clip_.y, clip_.bottom(), centre_.y, (octant_ & upwards) != 0);
  if ((octant_ & steep) != 0) std::swap(t, v);
  t_last_ = -1;
  // The point on the axis belongs to the octant that isn't mirrored; the dot of radius 0 to the first.
  int first = std::max(t.first, mirrored ? 1 : 0);
  int last = std::min(t.last, radius_);
  if (radius_ == 0 && octant_ > 0) return;
  if (v.last < 0 || v.first > radius_ || first > last) return;
  // v falls as t grows: the rows v.first .. v.last are the t up to the reach of row v.first and beyond that
  // of row v.last + 1.
  if (v.first > 0) last = std::min(last, half_chord(radius_, v.first));
  if (v.last < radius_) first = std::max(first, half_chord(radius_, v.last + 1) + 1);
  if (first > last) return;
  walk_ = Octant(radius_, first);
  t_last_ = last;
}

bool CircleScan::next(RowSpan& span) noexcept {
  const auto more = [this] {
    // Diagonal pixels belong to the octants that aren't steep.
    return walk_.t() <= t_last_ && walk_.t() <= walk_.v() - ((octant_ & steep) != 0 ? 1 : 0);
  };
  while (!more()) {
    if (octant_ == 7) return false;
    ++octant_;
    start();
  }
  const int t = walk_.t();
  const int v = walk_.v();
  const int down = (octant_ & upwards) != 0 ? -1 : 1;
  const int right = (octant_ & leftwards) != 0 ? -1 : 1;
  if ((octant_ & steep) != 0) {
    walk_.next();
    const int x = centre_.x + right * v;
    span = {centre_.y + down * t, x, x + 1};
    return true;
  }
  while (!walk_.next() && more()) {
  }
  const int begin = centre_.x + right * t;
  const int end = centre_.x + right * (walk_.t() - 1);
  span = {centre_.y + down * v, std::min(begin, end), std::max(begin, end) + 1};
  return true;
}

}  // namespace intaglio::raster::detail
