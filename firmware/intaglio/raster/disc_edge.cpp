// SPDX-License-Identifier: MIT
#include <intaglio/number/root.hpp>
#include <intaglio/raster/disc_edge.hpp>

#include <cstdint>

namespace intaglio::raster {

void DiscEdge::start(linear::SubPoint centre, int diameter, bool right, int row) noexcept {
  centre_ = 2 * centre.x;
  distance_ = unit * row - 2 * centre.y;
  diameter_ = diameter;
  right_ = right;
  update();
}

void DiscEdge::next() noexcept {
  distance_ += unit;
  update();
}

void DiscEdge::update() noexcept {
  // On rows of the disc |distance| <= diameter: both factors are at least 0.
  const auto below = static_cast<std::uint32_t>(diameter_ - distance_);
  const auto above = static_cast<std::uint32_t>(diameter_ + distance_);
  const std::uint64_t square = std::uint64_t{below} * above;
  const std::uint32_t root = number::isqrt(square);
  // Integers not less than -sqrt(n) are those not less than -floor(sqrt(n)); for sqrt(n) it is the ceiling.
  const bool exact = std::uint64_t{root} * root == square;
  const int reach = static_cast<int>(root) + (right_ && !exact ? 1 : 0);
  x_ = ceil_half(right_ ? centre_ + reach : centre_ - reach);
}

}  // namespace intaglio::raster
