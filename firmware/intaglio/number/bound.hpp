// SPDX-License-Identifier: MIT
//
// Error bounds and rungs: how an approximation says how far off it can be.
//
// Rule: a way of computing a value is a type (a *rung*) with a `bound` and a call operator. The bound is an
// upper bound of |computed - true| over the rung's whole domain, in thousandths of a named unit; a test holds
// it against an exact oracle and fails when it is exceeded. Rungs for the same value form a `Family`, which
// tests and measurements walk, so that a rung can't exist without being measured.
#pragma once

#include <concepts>
#include <cstdint>

namespace intaglio::number {

/// What an error is counted in.
enum class Unit : std::uint8_t {
  lsb,             ///< The last place of the result itself (for integers: 1).
  lsb_q15,         ///< 2^-15.
  lsb_q16,         ///< 2^-16.
  pixel,           ///< The distance of two pixels.
  value,           ///< The true value itself: a relative error.
  ppm_of_value,    ///< A millionth of the true value.
  wrong_pixel,     ///< A pixel that is drawn and shouldn't be, or the other way round.
  wrong_ppm,       ///< Such a pixel among a million of the shape's.
  coverage_level,  ///< 1/255 of full coverage.
  palette_level,   ///< A step of a palette's ramp, or of 8 bits of a channel.
  cie76,           ///< The distance of two colours in L*a*b*.
  angle_step,      ///< 1/65536 turn.
};

/// |computed - true| <= thousandths / 1000 of the unit.
struct Bound {
  std::int32_t thousandths = 0;
  Unit unit = Unit::lsb;

  [[nodiscard]] constexpr bool exact() const noexcept { return thousandths == 0; }
  friend constexpr bool operator==(Bound, Bound) noexcept = default;
};

[[nodiscard]] constexpr Bound lsb_q15(std::int32_t thousandths) noexcept {
  return {thousandths, Unit::lsb_q15};
}
[[nodiscard]] constexpr Bound lsb_q16(std::int32_t thousandths) noexcept {
  return {thousandths, Unit::lsb_q16};
}

[[nodiscard]] constexpr Bound pixels(std::int32_t thousandths) noexcept { return {thousandths, Unit::pixel}; }

[[nodiscard]] constexpr Bound wrong_pixels(std::int32_t thousandths) noexcept {
  return {thousandths, Unit::wrong_pixel};
}

[[nodiscard]] constexpr Bound coverage_levels(std::int32_t thousandths) noexcept {
  return {thousandths, Unit::coverage_level};
}

[[nodiscard]] constexpr Bound parts_of_value(std::int32_t thousandths) noexcept {
  return {thousandths, Unit::value};
}

[[nodiscard]] constexpr Bound ppm_of_value(std::int32_t thousandths) noexcept {
  return {thousandths, Unit::ppm_of_value};
}

/// What never differs from the true value.
[[nodiscard]] constexpr Bound exactly(Unit unit = Unit::lsb) noexcept { return {0, unit}; }

/// A way of computing a value: callable without state, with its error bound.
template <class R>
concept Rung = std::default_initializable<R> && requires {
  { R::bound } -> std::convertible_to<Bound>;
};

/// The rungs that compute the same value, cheapest first.
template <Rung... Rungs>
struct Family {
  static constexpr int size = sizeof...(Rungs);
};

}  // namespace intaglio::number
