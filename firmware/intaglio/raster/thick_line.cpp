// SPDX-License-Identifier: MIT
#include <intaglio/raster/thick_line.hpp>

#include <algorithm>
#include <cstddef>

namespace intaglio::raster::detail {
namespace {

/// The side from the top corner over the middle one to the bottom, on rows begin .. end-1, which it has.
ThickLineSide side_of(linear::SubPoint top, linear::SubPoint middle, linear::SubPoint bottom, int begin,
                      int end) noexcept {
  ThickLineSide side;
  side.bend = ceil_to_pixel(middle.y);
  const bool bends = begin < side.bend;
  side.upper.start(bends ? top : middle, bends ? middle : bottom, begin);
  if (bends && side.bend < end) side.lower.start(middle, bottom, side.bend);
  return side;
}

}  // namespace

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

Status thick_line_rows(linear::SubPoint a, linear::SubPoint b, int width, Cap cap, const linear::Rect& clip,
                       ThickLineRows& rows) noexcept {
  rows.y_begin = rows.y_end = 0;
  std::array<linear::SubPoint, 4> corners;
  const Status status = thick_line_corners(a, b, width, cap, corners);
  if (!status.ok()) return status;
  std::size_t first = 0;  // the highest corner
  int leftmost = corners[0].x;
  int rightmost = leftmost;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (corners[i].y < corners[first].y) first = i;
    leftmost = std::min(leftmost, corners[i].x);
    rightmost = std::max(rightmost, corners[i].x);
  }
  // The next corner in order is down the left side, the lowest is opposite.
  const auto corner = [&](std::size_t i) { return corners[(first + i) % corners.size()]; };
  const int y_begin = std::max(ceil_to_pixel(corner(0).y), clip.y);
  const int y_end = std::min(ceil_to_pixel(corner(2).y), clip.bottom());
  if (y_begin >= y_end || ceil_to_pixel(rightmost) <= clip.x || ceil_to_pixel(leftmost) >= clip.right())
    return {};
  rows.y_begin = y_begin;
  rows.y_end = y_end;
  rows.left = side_of(corner(0), corner(1), corner(2), y_begin, y_end);
  rows.right = side_of(corner(0), corner(3), corner(2), y_begin, y_end);
  return {};
}

}  // namespace intaglio::raster::detail
