// SPDX-License-Identifier: MIT
#include <intaglio/number/root.hpp>
#include <intaglio/raster/octant.hpp>

#include <cstdint>

namespace intaglio::raster {

int half_chord(int radius, int distance) noexcept {
  if (distance > radius) return -1;
  if (distance == 0) return radius;
  const auto r = static_cast<unsigned>(radius);
  const auto d = static_cast<unsigned>(distance);
  const std::uint64_t square = std::uint64_t{r - d} * (r + d);
  // No root is longer than the radius.
  std::uint32_t digit = 1;
  while (digit <= r / 2) digit += digit;
  const std::uint64_t bit = std::uint64_t{digit} * digit;
  // Is the row in an octant whose pixels are nearest along x (v >= t at t = d, which is 2d^2 - d < r^2)? Then
  // the outermost pixel is the one nearest to the root: with w = floor(root), w + 1 iff r^2 - d^2 > w^2 + w.
  // Otherwise it is the last of a run, nearest along y: the largest t with t^2 < r^2 - (d - 1/2)^2, all terms
  // integers but 1/4.
  if (square + d <= std::uint64_t{d} * d) return static_cast<int>(number::isqrt_from(square + d - 1, bit));
  const unsigned floor = number::isqrt_from(square, bit);
  return static_cast<int>(floor + (square - std::uint64_t{floor} * floor > floor ? 1U : 0U));
}

}  // namespace intaglio::raster
