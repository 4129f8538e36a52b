// SPDX-License-Identifier: MIT
#include <intaglio/number/sine.hpp>
#include <intaglio/raster/smooth_line.hpp>

namespace intaglio::raster::detail {

Result<std::uint32_t> round_line_outline(
    linear::SubPoint a, linear::SubPoint b, int width,
    std::array<linear::SubPoint, smooth_line_vertices>& outline) noexcept {
  std::array<linear::SubPoint, 4> corners;
  const Status status = thick_line_corners(a, b, width, Cap::butt, corners);
  if (!status.ok()) return status;
  // The middle of a side is w/2 * (1 - cos(90 degrees / sides)) inside the circle, below 0.62 w / sides^2.
  int sides = 4;
  while (sides < round_cap_sides && 8 * sides * sides < 5 * width) sides *= 2;
  const linear::SubPoint along = half_width(a, b, width);
  for (int i = 0; i <= sides; ++i) {
    const auto angle = number::Angle::from_steps(i * (number::Angle::turn / 2 / sides));
    const std::int64_t sine = number::sine(angle).raw();
    const std::int64_t cosine = number::cosine(angle).raw();
    // To nearest, ties away from zero: the same for a line from b to a.
    const auto rounded = [](std::int64_t value) {
      constexpr int one = 1 << 15;
      return static_cast<int>((value + (value < 0 ? -one / 2 : one / 2)) / one);
    };
    const linear::SubPoint off{rounded(along.x * sine - along.y * cosine),
                               rounded(along.y * sine + along.x * cosine)};
    const linear::SubPoint beyond{b.x + off.x, b.y + off.y};
    const linear::SubPoint before{a.x - off.x, a.y - off.y};
    if (!linear::in_domain(beyond) || !linear::in_domain(before))
      return Status{Error::out_of_domain, Argument::point};
    outline[static_cast<std::size_t>(i)] = beyond;
    outline[static_cast<std::size_t>(sides + 1 + i)] = before;
  }
  return static_cast<std::uint32_t>(2 * (sides + 1));
}

}  // namespace intaglio::raster::detail
