// SPDX-License-Identifier: MIT
#include <intaglio/number/long_division.hpp>
#include <intaglio/number/mul_div.hpp>
#include <intaglio/number/product.hpp>
#include <intaglio/number/root.hpp>
#include <intaglio/raster/sector.hpp>

namespace intaglio::raster::detail {

namespace {

struct UnitVector {
  std::uint64_t cosine;
  std::uint64_t sine;
};

constexpr int quadrant_bits = 14;

/// Cosine and sine of 2^i steps of 1/65536 turn, in 2^-62, rounded to nearest.
constexpr UnitVector unit_vectors[quadrant_bits] = {
    {4611685997232573857, 442139858824435},     {4611685933648131909, 884279713584815},
    {4611685679310367043, 1768559394657194},    {4611684661959354334, 3537118529214896},
    {4611680592556051597, 7074234977634094},    {4611664314954810277, 14148453308909941},
    {4611599204741358747, 28296773447188932},   {4611338766951757487, 56592481536850979},
    {4610297064819661174, 113176440454146016},  {4606131040650197959, 226284707652502141},
    {4589479489746651964, 452024275624069880},  {4523073764714963030, 899695310372275547},
    {4260642322793532497, 1764815834521887442}, {3260954456333195553, 3260954456333195553},
};

/// a * b in 2^-62, rounded to nearest.
std::uint64_t multiply(std::uint64_t a, std::uint64_t b) noexcept {
  const auto [high, low] = number::detail::multiply_wide(a, b);
  return (high << 2U | low >> 62U) + (low >> 61U & 1U);
}

}  // namespace

Ray::Ray(number::Angle angle) noexcept : quadrant_(angle.steps() >> quadrant_bits) {
  const auto steps = static_cast<unsigned>(angle.steps());
  for (unsigned i = 0; i < quadrant_bits; ++i) {
    if ((steps >> i & 1U) == 0) continue;
    const UnitVector& digit = unit_vectors[i];
    // The sum stays within the quadrant: both results are positive.
    const std::uint64_t cosine = multiply(cosine_, digit.cosine) - multiply(sine_, digit.sine);
    sine_ = multiply(sine_, digit.cosine) + multiply(cosine_, digit.sine);
    cosine_ = cosine;
  }
}

bool Ray::comes_after(int dx, int dy) const noexcept {
  // Turn the direction into the first quadrant: along > 0, across >= 0.
  int quadrant = 0;
  int along = dx;
  int across = dy;
  if (dx <= 0 && dy > 0) {
    quadrant = 1, along = dy, across = -dx;
  } else if (dx < 0) {
    quadrant = 2, along = -dx, across = -dy;
  } else if (dy < 0) {
    quadrant = 3, along = -dy, across = dx;
  } else if (dx == 0) {
    along = 1;
  }
  if (quadrant != quadrant_) return quadrant < quadrant_;
  // Cut to 30 bits, cosine and sine are less than a unit short: that decides but close to the ray.
  const auto p = static_cast<std::uint32_t>(across);
  const auto q = static_cast<std::uint32_t>(along);
  const std::uint64_t left = std::uint64_t{p} * static_cast<std::uint32_t>(cosine_ >> 32U);
  const std::uint64_t right = std::uint64_t{q} * static_cast<std::uint32_t>(sine_ >> 32U);
  if (left + p < right) return true;
  if (left >= right + q) return false;
  return !number::product_at_least(p, cosine_, q, sine_);
}

int Ray::same_until(int begin, int end, int dy) const noexcept {
  return detail::same_until(begin, end, [&](int dx) { return comes_after(dx, dy); });
}

linear::Point Ray::at(int distance) const noexcept {
  return turned(static_cast<int>(multiply(static_cast<std::uint64_t>(distance), cosine_)),
                static_cast<int>(multiply(static_cast<std::uint64_t>(distance), sine_)));
}

// Along the ray (c, s) the ellipse is 1 / sqrt((c/a)^2 + (s/b)^2) away, so at a*u/l and b*v/l, where u = b*c,
// v = a*s and l = sqrt(u^2 + v^2). u and v are kept to 31 bits of the larger, so u/l and v/l to 2^-29 and the
// place to 2^-9.
linear::Point Ray::on_ellipse(int x_radius, int y_radius) const noexcept {
  if (x_radius == y_radius) return at(x_radius);
  const bool odd = (quadrant_ & 1) != 0;  // the first axis of odd quadrants is y
  const auto a = static_cast<std::uint64_t>(odd ? y_radius : x_radius);
  const auto b = static_cast<std::uint64_t>(odd ? x_radius : y_radius);
  std::uint64_t u = multiply(b << 40U, cosine_);
  std::uint64_t v = multiply(a << 40U, sine_);
  if (u == 0 && v == 0) return at(static_cast<int>(a));
  while (u < std::uint64_t{1} << 60U && v < std::uint64_t{1} << 60U) {
    u <<= 1U;
    v <<= 1U;
  }
  u >>= 30U;
  v >>= 30U;
  const std::uint32_t l = number::isqrt(u * u + v * v);
  const auto nearest = [l](std::uint64_t n) {
    return static_cast<int>(number::long_divide(n + l / 2, l).quotient);
  };
  return turned(nearest(a * u), nearest(b * v));
}

linear::Point Ray::turned(int along, int across) const noexcept {
  switch (quadrant_) {
    case 0:
      return {along, across};
    case 1:
      return {-across, along};
    case 2:
      return {-along, -across};
    default:
      return {across, -along};
  }
}

Sector::Sector(number::Angle start, int sweep) noexcept
    : first_(sweep > 0 ? start : start + number::Angle::from_steps(sweep)),
      last_(sweep > 0 ? start + number::Angle::from_steps(sweep) : start) {
  const int first = start.steps() + (sweep > 0 ? 0 : sweep);
  across_zero_ = first < 0 || first + (sweep > 0 ? sweep : -sweep) >= number::Angle::turn;
}

bool Sector::holds(int dx, int dy) const noexcept {
  const bool after_first = !first_.comes_after(dx, dy);
  if (after_first == across_zero_) return across_zero_;
  return last_.comes_after(dx, dy);
}

int Sector::same_until(int begin, int end, int dy) const noexcept {
  return last_.same_until(begin, first_.same_until(begin, end, dy), dy);
}

}  // namespace intaglio::raster::detail
