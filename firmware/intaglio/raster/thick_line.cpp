// SPDX-License-Identifier: MIT
//
// The corners of a thick line: see the header for the rule.
//
// Half the width along the line is the vector (w*dx/(2*L), w*dy/(2*L)), L = sqrt(dx*dx + dy*dy); across it,
// the same with its coordinates exchanged and one negated. dx and dy are first doubled until the longer has
// 30 bits, so that L, rounded to an integer, is right to one part in 2^30: the half-width is off by at most
// w/2 / 2^30 and rounding.
// Bit budget: dx, dy < 2^30, hence dx*dx + dy*dy < 2^61 and L < 2^31; w*dx <= 2^28 * 2^30; corners within
// 2^28 + 2 * 2^27.
#include <intaglio/number/long_division.hpp>
#include <intaglio/number/root.hpp>
#include <intaglio/raster/thick_line.hpp>

namespace intaglio::raster::detail {
namespace {

constexpr int width_limit = linear::coordinate_limit * linear::subpixel_one;

constexpr std::uint32_t magnitude(int c) noexcept { return static_cast<std::uint32_t>(c < 0 ? -c : c); }

/// The vector of half the width along the line from `a` to `b`; to the right if they are the same point.
linear::SubPoint half_width(linear::SubPoint a, linear::SubPoint b, int width) noexcept {
  std::uint32_t dx = magnitude(b.x - a.x);
  std::uint32_t dy = magnitude(b.y - a.y);
  if (dx == 0 && dy == 0) dx = 1;
  for (; ((dx | dy) >> 29U) == 0; dx <<= 1U) dy <<= 1U;
  const std::uint32_t length = number::isqrt_nearest(std::uint64_t{dx} * dx + std::uint64_t{dy} * dy);
  const auto part = [&](std::uint32_t d) {
    const std::uint64_t twice = std::uint64_t{d} * static_cast<std::uint32_t>(width);
    return static_cast<int>(number::long_divide(twice + length, 2 * length).quotient);
  };
  const int x = part(dx);
  const int y = part(dy);
  return {b.x < a.x ? -x : x, b.y < a.y ? -y : y};
}

}  // namespace

Status thick_line_corners(linear::SubPoint a, linear::SubPoint b, int width, Cap cap,
                          std::array<linear::SubPoint, 4>& corners) noexcept {
  if (!linear::in_domain(a) || !linear::in_domain(b)) return {Error::out_of_domain, Argument::point};
  if (width < 0 || width > width_limit) return {Error::out_of_domain, Argument::width};
  if (cap != Cap::butt && cap != Cap::square) return {Error::out_of_range, Argument::rule};
  const linear::SubPoint along = half_width(a, b, width);
  if (cap == Cap::square) {
    a = {a.x - along.x, a.y - along.y};
    b = {b.x + along.x, b.y + along.y};
  }
  corners = {{{a.x - along.y, a.y + along.x},
              {b.x - along.y, b.y + along.x},
              {b.x + along.y, b.y - along.x},
              {a.x + along.y, a.y - along.x}}};
  for (const linear::SubPoint corner : corners)
    if (!linear::in_domain(corner)) return {Error::out_of_domain, Argument::point};
  return {};
}

}  // namespace intaglio::raster::detail
