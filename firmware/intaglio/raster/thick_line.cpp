// SPDX-License-Identifier: MIT
#include <intaglio/raster/thick_line.hpp>

namespace intaglio::raster::detail {

Status thick_line_corners(linear::SubPoint a, linear::SubPoint b, int width, Cap cap,
                          std::array<linear::SubPoint, 4>& corners) noexcept {
  if (!linear::in_domain(a) || !linear::in_domain(b)) return {Error::out_of_domain, Argument::point};
  if (width < 0 || width > stroke_width_limit) return {Error::out_of_domain, Argument::width};
  if (cap != Cap::butt && cap != Cap::square) return {Error::out_of_range, Argument::rule};
  const linear::SubPoint along = half_width(a, b, width);
  if (cap == Cap::square) {
    a = {a.x - along.x, a.y - along.y};
    b = {b.x + along.x, b.y + along.y};
  }
  corners = sides(a, b, along);
  for (const linear::SubPoint corner : corners)
    if (!linear::in_domain(corner)) return {Error::out_of_domain, Argument::point};
  return {};
}

}  // namespace intaglio::raster::detail
