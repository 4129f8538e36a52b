// SPDX-License-Identifier: MIT
#include <intaglio/raster/disc_scan.hpp>

#include <algorithm>

namespace intaglio::raster::detail {

namespace {

/// Distances from `centre` to the nearest and the furthest of the `length` coordinates from `begin` on.
struct Reach {
  int nearest;
  int furthest;
};
Reach reach(int begin, int length, int centre) noexcept {
  const int before = centre - begin;
  const int after = length - 1 - before;
  return {std::max({-before, -after, 0}), std::max(before, after)};
}

}  // namespace

Status check_circle(linear::Point centre, int radius) noexcept {
  if (!linear::in_domain(centre)) return {Error::out_of_domain, Argument::point};
  if (radius < 0 || !linear::in_domain(radius)) return {Error::out_of_domain, Argument::radius};
  return {};
}

bool wholly_visible(linear::Point centre, int radius, const linear::Rect& clip) noexcept {
  return centre.x - radius >= clip.x && centre.x + radius < clip.right() && centre.y - radius >= clip.y &&
         centre.y + radius < clip.bottom();
}

DiscScan::DiscScan(linear::Point centre, int radius, const linear::Rect& clip, Part part) noexcept
    : radius_(radius) {
  const Reach down = reach(clip.y, clip.height, centre.y);
  const Reach across = reach(clip.x, clip.width, centre.x);
  first_ = down.nearest;
  if (clip.empty()) return;
  // A disc is symmetric about its diagonals: the rows that reach a column are the reach of that column.
  last_ = std::min(down.furthest, half_chord(radius, across.nearest));
  full_ = half_chord(radius, across.furthest + 1) + 1;
  if (part == Part::outline) {
    // What is two rows inside these is wholly hidden beyond the window's sides.
    first_ = std::max(first_, full_ - 1);
    full_ = 0;
    inner_ = half_chord(radius, last_ + 1) + 1;
  }
  full_ = std::min(full_, last_ + 1);
  if (first_ <= last_) walk_ = Octant(radius, half_chord(radius, last_));
}

}  // namespace intaglio::raster::detail
