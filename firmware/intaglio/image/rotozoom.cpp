// SPDX-License-Identifier: MIT
#include <intaglio/image/rotozoom.hpp>
#include <intaglio/image/steps.hpp>
#include <intaglio/number/long_division.hpp>
#include <intaglio/number/sine.hpp>

#include <algorithm>

namespace intaglio::image::detail {

namespace {

/// A sub-pixel and half a pixel in 2^-24 pixel, and a pixel in 2^-16.
constexpr std::int64_t sub_pixel = 1 << 16;
constexpr std::int64_t one_pixel = 1 << 16;
constexpr std::int64_t half_pixel = 1 << 23;

/// factor / scale in 2^-16, to nearest, ties away from zero. |factor| <= 2^15, scale >= 2^8.
std::int32_t per_target_pixel(number::Fixed<15> factor, number::Fixed<16> scale) noexcept {
  const auto divisor = static_cast<std::uint32_t>(scale.raw());
  const bool negative = factor.raw() < 0;
  const auto magnitude = static_cast<std::uint64_t>(negative ? -factor.raw() : factor.raw());
  const std::uint64_t dividend = (magnitude << 17U) + divisor / 2U;
  const auto step = static_cast<std::int32_t>(number::long_divide(dividend, divisor).quotient);
  return negative ? -step : step;
}

}  // namespace

Status check_rotozoom(const Rotozoom& placement, linear::Size source) noexcept {
  if (placement.scale < least_rotozoom_scale || placement.scale > largest_rotozoom_scale)
    return {Error::out_of_range, Argument::size};
  return check_turned(placement.position, placement.pivot, source);
}

RotozoomMap::RotozoomMap(const Rotozoom& placement, linear::Size source) noexcept
    : position_(placement.position),
      pivot_(placement.pivot),
      source_(source),
      along_(per_target_pixel(number::cosine(placement.angle), placement.scale)),
      across_(per_target_pixel(number::sine(placement.angle), placement.scale)) {}

RotozoomRun RotozoomMap::run(int left, int y, int width) const noexcept {
  const std::int64_t dx = left * linear::subpixel_one - position_.x;
  const std::int64_t dy = y * linear::subpixel_one - position_.y;
  // In 2^-24 pixel, then in 2^-16: rounding down loses nothing, as the steps are whole multiples of 2^-16.
  const std::int64_t column = (pivot_.x * sub_pixel + half_pixel + along_ * dx + across_ * dy) >> 8;
  const std::int64_t row = (pivot_.y * sub_pixel + half_pixel - across_ * dx + along_ * dy) >> 8;
  const StepRange columns = steps_inside(column, along_, source_.width * one_pixel, width);
  const StepRange rows = steps_inside(row, -across_, source_.height * one_pixel, width);
  const int first = std::max(columns.first, rows.first);
  const int last = std::min(columns.last, rows.last);
  if (first >= last) return {0, 0, 0, 0};
  return {first, last, static_cast<std::uint32_t>(column + std::int64_t{along_} * first),
          static_cast<std::uint32_t>(row - std::int64_t{across_} * first)};
}

}  // namespace intaglio::image::detail
