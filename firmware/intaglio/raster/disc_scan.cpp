// SPDX-License-Identifier: MIT
#include <intaglio/raster/disc_scan.hpp>

#include <algorithm>

namespace intaglio::raster::detail {

namespace {

/// The distance to the nearest of the coordinates from `before` left of here to `after` right of here.
int nearest(int before, int after) noexcept { return before < 0 ? -before : after < 0 ? -after : 0; }

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
  const int above = centre.y - clip.y;
  const int below = clip.height - 1 - above;
  filled_ = first_ = nearest(above, below);
  if (clip.empty()) return;
  // A disc is symmetric about its diagonals: the rows that reach a column are the reach of that column.
  const int left = centre.x - clip.x;
  const int right = clip.width - 1 - left;
  last_ = half_chord(radius, nearest(left, right));
  const int furthest_row = above > below ? above : below;
  if (last_ > furthest_row) last_ = furthest_row;
  const int full = half_chord(radius, (left > right ? left : right) + 1) + 1;
  // What of an outline is two rows inside these is wholly hidden beyond the window's sides.
  const bool outline = part == Part::outline;
  first_ = std::max(first_, outline ? full - 1 : std::min(full, last_ + 1));
  if (outline) filled_ = first_;
  if (first_ <= last_ && last_ >= radius / 2) {
    if (outline) inner_ = half_chord(radius, last_ + 1) + 1;
    walk_ = Octant(radius, half_chord(radius, last_));
  }
}

}  // namespace intaglio::raster::detail
