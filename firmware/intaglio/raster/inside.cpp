// SPDX-License-Identifier: MIT
#include <intaglio/raster/edge_function.hpp>
#include <intaglio/raster/inside.hpp>

#include <cstddef>
#include <cstdint>

namespace intaglio::raster {

Result<int> winding_number(const std::span<const linear::SubPoint>& vertices,
                           const std::span<const int>& contour_lengths, linear::SubPoint point) noexcept {
  const Status status = detail::check_contours(vertices, contour_lengths);
  if (!status.ok()) return status;
  if (!linear::in_domain(point)) return Status{Error::out_of_domain, Argument::point};
  int turns = 0;
  const linear::SubPoint* contour = vertices.data();
  for (const int length : contour_lengths) {
    if (length == 0) continue;
    const linear::SubPoint* const end = contour + length;
    for (const linear::SubPoint *to = contour, *from = end - 1; to != end; from = to++) {
      const bool upwards = to->y < from->y;
      const linear::SubPoint& top = upwards ? *to : *from;
      const linear::SubPoint& bottom = upwards ? *from : *to;
      if (point.y < top.y || point.y >= bottom.y) continue;
      // An edge that runs upwards owns what lies to its right and on it.
      if (side_of(bottom, top, point) > 0) turns += upwards ? -1 : 1;
    }
    contour = end;
  }
  return turns;
}

Result<bool> inside_polygon(FillRule rule, const std::span<const linear::SubPoint>& vertices,
                            const std::span<const int>& contour_lengths, linear::SubPoint point) noexcept {
  const int mask = detail::winding_mask(rule);
  if (mask == 0) return Status{Error::out_of_range, Argument::rule};
  const Result<int> turns = winding_number(vertices, contour_lengths, point);
  if (!turns.ok()) return turns.status();
  return (turns.value() & mask) != 0;
}

Result<bool> inside_convex(const std::span<const linear::SubPoint>& vertices,
                           linear::SubPoint point) noexcept {
  for (const linear::SubPoint& vertex : vertices)
    if (!linear::in_domain(vertex)) return Status{Error::out_of_domain, Argument::vertices};
  if (!linear::in_domain(point)) return Status{Error::out_of_domain, Argument::point};
  if (vertices.empty()) return false;
  int side = 0;
  linear::SubPoint from = vertices.back();
  for (const linear::SubPoint& to : vertices) {
    if (from == to) continue;
    const int here = side_of(from, to, point);
    if (side != 0 && here != side) return false;
    side = here;
    from = to;
  }
  return side != 0;
}

}  // namespace intaglio::raster
