// SPDX-License-Identifier: MIT
#include <intaglio/raster/polygon.hpp>

namespace intaglio::raster {

namespace detail {

template class WindingScan<PolygonEdge>;

Status PolygonScan::prepare(const std::span<const linear::SubPoint>& vertices,
                            const std::span<const int>& contour_lengths) noexcept {
  if (mask() == 0) return {Error::out_of_range, Argument::rule};
  const Status status = check_contours(vertices, contour_lengths);
  if (!status.ok()) return status;
  if (clip().empty()) return {};

  const linear::SubPoint* contour = vertices.data();
  for (const int length : contour_lengths) {
    if (length >= 3) add_contour(contour, contour + length);
    contour += length;
  }
  return sort();
}

}  // namespace detail

Result<std::uint32_t> polygon_workspace(const std::span<const linear::SubPoint>& vertices,
                                        const std::span<const int>& contour_lengths,
                                        const linear::Rect& clip) noexcept {
  if (!linear::in_domain(clip)) return Status{Error::out_of_domain, Argument::rectangle};
  detail::PolygonScan scan(FillRule::even_odd, clip, {});
  const Status status = scan.prepare(vertices, contour_lengths);
  if (!status.ok() && status.argument() != Argument::workspace) return status;
  return scan.count();
}

}  // namespace intaglio::raster
