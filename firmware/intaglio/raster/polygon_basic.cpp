// SPDX-License-Identifier: MIT
#include <intaglio/raster/edge.hpp>
#include <intaglio/raster/polygon_basic.hpp>

#include <algorithm>

namespace intaglio::raster::detail {

namespace {

/// Calls `take(from, to)` for every edge, contour by contour.
template <class Take>
void for_each_edge(const std::span<const linear::SubPoint>& vertices, const std::span<const int>& lengths,
                   Take take) {
  const linear::SubPoint* contour = vertices.data();
  for (const int length : lengths) {
    if (length == 0) continue;
    const linear::SubPoint* const end = contour + length;
    for (const linear::SubPoint *to = contour, *from = end - 1; to != end; from = to++) take(*from, *to);
    contour = end;
  }
}

}  // namespace

Status BasicScan::prepare(const std::span<const linear::SubPoint>& vertices,
                          const std::span<const int>& contour_lengths) noexcept {
  const Status status = check_contours(vertices, contour_lengths);
  if (!status.ok()) return status;
  if (clip_.empty()) return {};
  vertices_ = vertices;
  lengths_ = contour_lengths;
  std::uint32_t visible = 0;
  int first = clip_.bottom();
  for_each_edge(vertices, contour_lengths, [&](const linear::SubPoint& from, const linear::SubPoint& to) {
    const int row = std::max(ceil_to_pixel(std::min(from.y, to.y)), clip_.y);
    const int end = std::min(ceil_to_pixel(std::max(from.y, to.y)), clip_.bottom());
    if (row >= end) return;
    ++visible;
    first = std::min(first, row);
    y_end_ = visible == 1 ? end : std::max(y_end_, end);
  });
  if (visible > workspace_.size()) return {Error::too_small, Argument::workspace, visible};
  if (visible > 0) y_ = first - 1;
  if (visible == 0) y_end_ = y_;
  return {};
}

bool BasicScan::next_row() noexcept {
  if (y_ + 1 >= y_end_) return false;
  ++y_;
  count_ = 0;
  const int height = y_ * linear::subpixel_one;
  for_each_edge(vertices_, lengths_, [&](const linear::SubPoint& from, const linear::SubPoint& to) {
    const bool upwards = to.y < from.y;
    const linear::SubPoint& top = upwards ? to : from;
    const linear::SubPoint& bottom = upwards ? from : to;
    if (height < top.y || height >= bottom.y) return;
    PolygonCrossing& crossing = workspace_[count_++];
    crossing.x_ = Edge(top, bottom, y_).x();
    crossing.turn_ = upwards ? -1 : 1;
  });
  const auto row = workspace_.first(count_);
  const auto by_x = [](const PolygonCrossing& a, const PolygonCrossing& b) { return a.x() < b.x(); };
  std::make_heap(row.begin(), row.end(), by_x);
  std::sort_heap(row.begin(), row.end(), by_x);
  return true;
}

}  // namespace intaglio::raster::detail
