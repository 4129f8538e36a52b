// SPDX-License-Identifier: MIT
#include <intaglio/raster/disc.hpp>

#include <algorithm>

namespace intaglio::raster::detail {

namespace {

/// Distances from `centre` to the nearest and the furthest of the coordinates begin .. end-1.
struct Reach {
  int nearest;
  int furthest;
};
Reach reach(int begin, int end, int centre) noexcept {
  const int before = centre - begin;
  const int after = end - 1 - centre;
  return {std::max({-before, -after, 0}), std::max(before, after)};
}

}  // namespace

DiscRows disc_rows(linear::Point centre, int radius, const linear::Rect& clip) noexcept {
  DiscRows rows;
  if (clip.empty()) return rows;
  const Reach across = reach(clip.x, clip.right(), centre.x);
  const Reach down = reach(clip.y, clip.bottom(), centre.y);
  // A disc is symmetric about its diagonals: the rows that reach a column are the reach of that column.
  const int last = across.nearest == 0 ? radius : half_chord(radius, across.nearest);
  rows.first = down.nearest;
  rows.last = std::min(last, down.furthest);
  if (rows.first > rows.last) return rows;
  rows.last_reach = half_chord(radius, rows.last);
  const int full = across.furthest > radius ? 0 : half_chord(radius, across.furthest) + 1;
  rows.full = std::min(full, rows.last + 1);
  return rows;
}

}  // namespace intaglio::raster::detail
