// SPDX-License-Identifier: MIT
#include <intaglio/raster/triangle.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace intaglio::raster::detail {

Status triangle_rows(const std::array<linear::SubPoint, 3>& vertices, const linear::Rect& clip,
                     TriangleRows& rows) noexcept {
  rows.y_begin = rows.y_end = 0;
  int leftmost = INT32_MAX;
  int rightmost = INT32_MIN;
  for (const linear::SubPoint& vertex : vertices) {
    if (!linear::in_domain(vertex)) return {Error::out_of_domain, Argument::point};
    leftmost = std::min(leftmost, vertex.x);
    rightmost = std::max(rightmost, vertex.x);
  }
  const linear::SubPoint* top = &vertices[0];
  const linear::SubPoint* middle = &vertices[1];
  const linear::SubPoint* bottom = &vertices[2];
  if (middle->y < top->y) std::swap(middle, top);
  if (bottom->y < middle->y) std::swap(bottom, middle);
  if (middle->y < top->y) std::swap(middle, top);
  const linear::SubPoint& a = *top;
  const linear::SubPoint& b = *middle;
  const linear::SubPoint& c = *bottom;

  const int y_begin = std::max(ceil_to_pixel(a.y), clip.y);
  const int y_end = std::min(ceil_to_pixel(c.y), clip.bottom());
  if (y_begin >= y_end || ceil_to_pixel(rightmost) <= clip.x || ceil_to_pixel(leftmost) >= clip.right())
    return {};

  // Which side of the long edge a-c is b on? Six 30-bit factors, two 60-bit products.
  const std::int64_t of_short = std::int64_t{b.x - a.x} * (c.y - a.y);
  const std::int64_t of_long = std::int64_t{c.x - a.x} * (b.y - a.y);
  if (of_short == of_long) return {};
  rows.bent_is_left = of_short < of_long;
  rows.y_begin = y_begin;
  rows.y_end = y_end;
  rows.y_bend = std::min(ceil_to_pixel(b.y), y_end);

  const bool bends = y_begin < rows.y_bend;
  rows.whole.start(a, c, y_begin);
  rows.bent.start(bends ? a : b, bends ? b : c, y_begin);
  if (!bends) rows.y_bend = y_end;
  if (rows.y_bend < y_end) rows.lower.start(b, c, rows.y_bend);
  return {};
}

Status triangle_rows(const std::array<linear::Point, 3>& vertices, const linear::Rect& clip,
                     TriangleRows& rows) noexcept {
  rows.y_begin = rows.y_end = 0;
  for (const linear::Point vertex : vertices)
    if (!linear::in_domain(vertex)) return {Error::out_of_domain, Argument::point};
  return triangle_rows(
      std::array<linear::SubPoint, 3>{linear::to_subpixel(vertices[0]), linear::to_subpixel(vertices[1]),
                                      linear::to_subpixel(vertices[2])},
      clip, rows);
}

}  // namespace intaglio::raster::detail
