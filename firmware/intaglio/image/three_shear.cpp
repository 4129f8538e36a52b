// SPDX-License-Identifier: MIT
#include <intaglio/image/steps.hpp>
#include <intaglio/image/three_shear.hpp>
#include <intaglio/number/long_division.hpp>
#include <intaglio/number/sine.hpp>

#include <algorithm>

namespace intaglio::image::detail {

namespace {

constexpr int one = linear::subpixel_one;
constexpr int fixed_bits = 15;

struct Quotient {
  int floor;
  int remainder;
};

/// floor(n / d) and what is left, 2^15 <= d <= 2^16; |n / d| <= 2^24, so a multiple of d brings n above zero.
Quotient divide(std::int64_t n, std::int32_t d) noexcept {
  constexpr int lift = 1 << 24;
  const auto [quotient, remainder] = number::long_divide(
      static_cast<std::uint64_t>(n + std::int64_t{lift} * d), static_cast<std::uint32_t>(d));
  return {static_cast<int>(quotient) - lift, static_cast<int>(remainder)};
}

}  // namespace

ThreeShearMap::ThreeShearMap(const ThreeShear& placement, linear::Size source) noexcept
    : position_(placement.position), pivot_(placement.pivot), size_(source), origin_{0, 0}, along_{1, 0} {
  // A quarter turn takes the source's pixel (x, y) to column height-1-y, row x.
  const int eighth = number::Angle::turn / 8;
  int quarters = (placement.angle.steps() + eighth) / (2 * eighth);
  const auto rest = number::Angle::from_steps(placement.angle.steps() - quarters * 2 * eighth);
  for (; quarters > 0; --quarters) {
    origin_ = unturned(0, size_.height - 1);
    along_ = {along_.y, -along_.x};
    pivot_ = {one * (size_.height - 1) - pivot_.y, pivot_.x};
    size_ = {size_.height, size_.width};
  }
  slope_ = number::sine(rest).raw();
  divisor_ = (1 << fixed_bits) + number::cosine(rest).raw();
  const int first = divide(first_shear(0), divisor_).floor;
  const int last = divide(first_shear(size_.height - 1), divisor_).floor;
  least_shift_ = std::min(first, last);
  most_shift_ = std::max(first, last);
}

std::int64_t ThreeShearMap::first_shear(int row) const noexcept {
  const std::int64_t half = std::int64_t{one / 2} * divisor_;
  return (half - std::int64_t{slope_} * (one * row - pivot_.y)) >> linear::subpixel_bits;
}

ThreeShearRow ThreeShearMap::row(int left, int y, int width) const noexcept {
  const std::int64_t third_shear = std::int64_t{position_.x - pivot_.x + one / 2} * divisor_ -
                                   std::int64_t{slope_} * (one * y - position_.y);
  const int start = left - divide(third_shear >> linear::subpixel_bits, divisor_).floor;

  // The second shear of column x1 is floor(place / 2^15), which must be y less a row of the source.
  const std::int64_t second_shear = (std::int64_t{position_.y - pivot_.y + one / 2} * (1 << fixed_bits) +
                                     std::int64_t{slope_} * (std::int64_t{one} * start - pivot_.x)) >>
                                    linear::subpixel_bits;
  const int last_row = size_.height - 1;
  const std::int64_t place = second_shear - std::int64_t{y - last_row} * (1 << fixed_bits);
  const StepRange rows = steps_inside(place, slope_, std::int64_t{size_.height} << fixed_bits, width);

  ThreeShearRow way;
  way.first = std::max(rows.first, least_shift_ - start);
  way.last = std::min(rows.last, most_shift_ + size_.width - start);
  if (way.first >= way.last) return way;
  way.last_row_ = last_row;
  way.slope_ = slope_;
  way.divisor_ = divisor_;
  way.place_ = static_cast<std::uint32_t>(place + std::int64_t{slope_} * way.first);
  const auto [shift, remainder] = divide(first_shear(way.row()), divisor_);
  way.column_ = start + way.first - shift;
  way.remainder_ = remainder;
  return way;
}

}  // namespace intaglio::image::detail
