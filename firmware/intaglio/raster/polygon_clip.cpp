// SPDX-License-Identifier: MIT
#include <intaglio/raster/polygon_clip.hpp>

#include <cstddef>
#include <cstdint>

namespace intaglio::raster {

Result<PolygonClip> PolygonClip::over(FillRule rule, const std::span<const linear::SubPoint>& vertices,
                                      const std::span<const int>& contour_lengths, const linear::Rect& area,
                                      const std::span<PolygonEdge>& edges,
                                      const std::span<RowSpan>& spans) noexcept {
  if (!linear::in_domain(area)) return Status{Error::out_of_domain, Argument::rectangle};
  const linear::Rect window = linear::intersect(area, area);  // no extent below zero
  detail::PolygonScan scan(rule, window, edges);
  const Status status = scan.prepare(vertices, contour_lengths);
  if (!status.ok()) return status;

  std::size_t count = 0;
  int top = 0;
  int bottom = 0;
  int left = window.right();
  int right = window.x;
  for (RowSpan span; scan.next(span); ++count) {
    if (count < spans.size()) spans[count] = span;
    if (count == 0) top = span.y;
    bottom = span.y + 1;
    left = std::min(left, span.x_begin);
    right = std::max(right, span.x_end);
  }
  if (count > spans.size())
    return Status{Error::too_small, Argument::table, static_cast<std::uint32_t>(count)};
  PolygonClip clip;
  if (count == 0) return clip;
  clip.spans_ = spans.first(count);
  clip.bounds_ = {left, top, right - left, bottom - top};
  return clip;
}

const RowSpan* PolygonClip::span_from(int x, int y) const noexcept {
  return std::partition_point(spans_.data(), end(), [x, y](const RowSpan& span) {
    return span.y != y ? span.y < y : span.x_end <= x;
  });
}

}  // namespace intaglio::raster
