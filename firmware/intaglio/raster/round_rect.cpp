// SPDX-License-Identifier: MIT
#include <intaglio/number/long_division.hpp>
#include <intaglio/raster/round_rect.hpp>

#include <cstdint>

namespace intaglio::raster::detail {

namespace {

bool radius_in_domain(int radius) noexcept { return radius >= 0 && linear::in_domain(radius); }

}  // namespace

Status check_round_rect(const linear::Rect& r, const CornerRadii& radii) noexcept {
  if (!linear::in_domain(r)) return {Error::out_of_domain, Argument::rectangle};
  if (!radius_in_domain(radii.top_left) || !radius_in_domain(radii.top_right) ||
      !radius_in_domain(radii.bottom_right) || !radius_in_domain(radii.bottom_left))
    return {Error::out_of_domain, Argument::radius};
  return {};
}

CornerRadii fitting(const linear::Rect& r, const CornerRadii& radii) noexcept {
  // The smallest ratio so far: distance / sum.
  auto distance = std::uint32_t{1};
  auto sum = std::uint32_t{1};
  const auto fit = [&](int length, int first, int second) {
    const auto side_distance = static_cast<std::uint32_t>(length - 1);
    const auto side_sum = static_cast<std::uint32_t>(first + second);
    if (std::uint64_t{side_distance} * sum >= std::uint64_t{distance} * side_sum) return;
    distance = side_distance;
    sum = side_sum;
  };
  fit(r.width, radii.top_left, radii.top_right);
  fit(r.width, radii.bottom_left, radii.bottom_right);
  fit(r.height, radii.top_left, radii.bottom_left);
  fit(r.height, radii.top_right, radii.bottom_right);
  if (distance == sum) return radii;
  const auto smaller = [&](int radius) {
    return static_cast<int>(number::long_divide(static_cast<std::uint64_t>(radius) * distance, sum).quotient);
  };
  return {smaller(radii.top_left), smaller(radii.top_right), smaller(radii.bottom_right),
          smaller(radii.bottom_left)};
}

RoundRectShape::RoundRectShape(const linear::Rect& r, const CornerRadii& radii) noexcept
    : rect_(r), left_(radii.top_left, radii.bottom_left), right_(radii.top_right, radii.bottom_right) {}

RowSpan RoundRectShape::row(int y) noexcept {
  if (y < top() || y >= bottom()) return {y, 0, 0};
  const int from_top = y - top();
  const int from_bottom = bottom() - 1 - y;
  return {y, rect_.x + left_.inset(from_top, from_bottom),
          rect_.right() - right_.inset(from_top, from_bottom)};
}

}  // namespace intaglio::raster::detail
