// SPDX-License-Identifier: MIT
#include <intaglio/raster/edge.hpp>
#include <intaglio/raster/triangle_box.hpp>

#include <utility>

namespace intaglio::raster::detail {

Status triangle_box(const std::array<linear::SubPoint, 3>& vertices, const linear::Rect& clip,
                    TriangleBox& out) noexcept {
  out.box = {};
  out.narrow = true;
  for (const linear::SubPoint& vertex : vertices)
    if (!linear::in_domain(vertex)) return {Error::out_of_domain, Argument::point};
  const linear::SubPoint& a = vertices[0];
  const linear::SubPoint* b = &vertices[1];
  const linear::SubPoint* c = &vertices[2];
  const auto [left, right] = std::minmax({a.x, b->x, c->x});
  const auto [top, bottom] = std::minmax({a.y, b->y, c->y});

  // A vertex's own pixel may belong to the triangle, so the box is closed here.
  const int x = ceil_to_pixel(left);
  const int y = ceil_to_pixel(top);
  const linear::Rect whole{x, y, (right >> linear::subpixel_bits) + 1 - x,
                           (bottom >> linear::subpixel_bits) + 1 - y};
  const linear::Rect box = linear::intersect(whole, clip);
  if (box.empty()) return {};

  const std::int64_t area = std::int64_t{b->x - a.x} * (c->y - a.y) - std::int64_t{b->y - a.y} * (c->x - a.x);
  if (area == 0) return {};
  if (area < 0) std::swap(b, c);
  out.box = box;
  out.narrow = right - left <= narrow_extent && bottom - top <= narrow_extent;
  const linear::Point first{box.x, box.y};
  out.edges = {edge_function(a, *b, first), edge_function(*b, *c, first), edge_function(*c, a, first)};
  return {};
}

}  // namespace intaglio::raster::detail
