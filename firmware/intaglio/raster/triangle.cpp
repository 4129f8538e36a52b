// SPDX-License-Identifier: MIT
#include <intaglio/raster/triangle.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace intaglio::raster::detail {

bool triangle_rows(linear::SubPoint a, linear::SubPoint b, linear::SubPoint c, const linear::Rect& clip,
                   TriangleRows& rows) noexcept {
  if (clip.empty()) return false;
  if (b.y < a.y) std::swap(a, b);
  if (c.y < b.y) std::swap(b, c);
  if (b.y < a.y) std::swap(a, b);
  rows.y_begin = std::max(ceil_to_pixel(a.y), clip.y);
  rows.y_end = std::min(ceil_to_pixel(c.y), clip.bottom());
  if (rows.y_begin >= rows.y_end) return false;
  if (ceil_to_pixel(std::max({a.x, b.x, c.x})) <= clip.x ||
      ceil_to_pixel(std::min({a.x, b.x, c.x})) >= clip.right())
    return false;

  // Which side of the long edge a-c is b on? Six 30-bit factors, two 60-bit products.
  const std::int64_t of_short = std::int64_t{b.x - a.x} * (c.y - a.y);
  const std::int64_t of_long = std::int64_t{c.x - a.x} * (b.y - a.y);
  if (of_short == of_long) return false;
  rows.lower_is_left = of_short < of_long;

  const int bend = ceil_to_pixel(b.y);
  Edge upper;
  if (bend <= rows.y_begin) {
    upper = Edge(b, c, rows.y_begin);
    rows.y_bend = rows.y_end;
  } else {
    upper = Edge(a, b, rows.y_begin);
    rows.y_bend = std::min(bend, rows.y_end);
    if (bend < rows.y_end) rows.lower = Edge(b, c, bend);
  }
  const Edge whole(a, c, rows.y_begin);
  rows.left = rows.lower_is_left ? upper : whole;
  rows.right = rows.lower_is_left ? whole : upper;
  return true;
}

}  // namespace intaglio::raster::detail
