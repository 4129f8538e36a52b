// SPDX-License-Identifier: MIT
#include <intaglio/raster/octant.hpp>

#include <cstdint>

namespace intaglio::raster {

int half_chord(int radius, int distance) noexcept {
  if (distance > radius) return -1;
  if (distance == 0) return radius;
  const auto r = static_cast<unsigned>(radius);
  const auto d = static_cast<unsigned>(distance);
  const std::uint64_t square = std::uint64_t{r - d} * (r + d);
  // Is the row in an octant whose pixels are nearest along x (v >= t at t = d, which is 2d^2 - d < r^2)? Then
  // the outermost pixel is the one nearest to the root, the largest w with (w - 1/2)^2 < r^2 - d^2. Otherwise
  // it is the last of a run, nearest along y: the largest w with w^2 < r^2 - (d - 1/2)^2. All terms are
  // integers but 1/4, so either is the largest w with w*(w - nearest) <= bound.
  const unsigned nearest = square + d > std::uint64_t{d} * d ? 1 : 0;
  const std::uint64_t bound = square - 1 + (nearest != 0 ? 0 : d);
  // Digit by digit; no w is longer than the radius.
  unsigned digit = 1;
  while (digit <= r / 2) digit += digit;
  unsigned w = 0;
  for (; digit != 0; digit /= 2) {
    const unsigned longer = w + digit;
    if (std::uint64_t{longer} * (longer - nearest) <= bound) w = longer;
  }
  return static_cast<int>(w);
}

}  // namespace intaglio::raster
