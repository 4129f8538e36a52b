// SPDX-License-Identifier: MIT
//
// a * b / c on 64-bit integers, as if the product had 128 bits.
//
// Rule: mul_div_floor is the largest q with q*c <= a*b; mul_div_nearest the integer nearest to a*b/c, ties
// towards +infinity. A quotient that doesn't fit in 64 bits is saturated; c = 0 answers with the end of the
// range on the product's side (0 for 0/0), as division.hpp does.
//
// Bit budget: magnitudes are unsigned, |a|, |b|, |c| <= 2^63; the product is held in two 64-bit words made of
// four 32x32 products; the remainder is < |c| <= 2^63, so doubling it stays in 64 bits. No 128-bit type is
// needed, and where the product fits in 64 bits one ordinary division does. Otherwise 64 steps of shift and
// subtract: about 750 instructions on a Cortex-M3 (else 120), for set-up code and never for a pixel.
//
// Worst known input: min * min / -1, saturated; min * min / min = min.
#pragma once

#include <cstdint>
#include <limits>

namespace intaglio::number {

namespace detail {

/// high * 2^64 + low.
struct Wide {
  std::uint64_t high = 0;
  std::uint64_t low = 0;
};

/// The full product.
[[nodiscard]] constexpr Wide multiply_wide(std::uint64_t a, std::uint64_t b) noexcept {
  constexpr std::uint64_t low_half = 0xFFFFFFFFU;
  const std::uint64_t a_low = a & low_half;
  const std::uint64_t a_high = a >> 32U;
  const std::uint64_t b_low = b & low_half;
  const std::uint64_t b_high = b >> 32U;
  const std::uint64_t low = a_low * b_low;
  // (2^32-1)^2 + 2 * (2^32-1) = 2^64 - 1: neither middle sum can carry out.
  const std::uint64_t middle = a_high * b_low + (low >> 32U);
  const std::uint64_t carry = a_low * b_high + (middle & low_half);
  return {a_high * b_high + (middle >> 32U) + (carry >> 32U), carry << 32U | (low & low_half)};
}

struct UnsignedDivision {
  std::uint64_t quotient = 0;
  std::uint64_t remainder = 0;
};

/// n / d for n.high < d <= 2^63, so that the quotient fits.
[[nodiscard]] constexpr UnsignedDivision divide_wide(Wide n, std::uint64_t d) noexcept {
  if (n.high == 0) return {n.low / d, n.low % d};
  std::uint64_t remainder = n.high;
  std::uint64_t quotient = n.low;
  for (int bit = 0; bit < 64; ++bit) {
    remainder = remainder << 1U | quotient >> 63U;
    quotient <<= 1U;
    if (remainder >= d) {
      remainder -= d;
      quotient |= 1U;
    }
  }
  return {quotient, remainder};
}

[[nodiscard]] constexpr std::uint64_t magnitude(std::int64_t value) noexcept {
  return value < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
}

/// a * b / c with the remainder turned into a step of the quotient by `step_down` (below zero, away from it)
/// or `step_up` (above zero); each is asked with the remainder (never 0) and |c|.
template <class StepUp, class StepDown>
[[nodiscard]] constexpr std::int64_t mul_div(std::int64_t a, std::int64_t b, std::int64_t c, StepUp step_up,
                                             StepDown step_down) noexcept {
  constexpr std::int64_t max = std::numeric_limits<std::int64_t>::max();
  constexpr std::int64_t min = std::numeric_limits<std::int64_t>::min();
  const bool negative = (a < 0) != ((b < 0) != (c < 0));
  const Wide product = multiply_wide(magnitude(a), magnitude(b));
  const std::uint64_t divisor = magnitude(c);
  if (product.high == 0 && product.low == 0) return 0;
  if (product.high >= divisor) return negative ? min : max;  // Too large for 64 bits, or c = 0.
  const UnsignedDivision division = divide_wide(product, divisor);
  std::uint64_t quotient = division.quotient;
  // One below the limits, a step still lands inside or exactly at the end; above them nothing changes.
  constexpr std::uint64_t limit = std::uint64_t{1} << 63U;
  if (division.remainder != 0 && quotient < limit)
    quotient += negative ? step_down(division.remainder, divisor) : step_up(division.remainder, divisor);
  if (negative) return quotient >= limit ? min : -static_cast<std::int64_t>(quotient);
  return quotient >= limit ? max : static_cast<std::int64_t>(quotient);
}

}  // namespace detail

/// The largest integer <= a*b/c, saturated.
[[nodiscard]] constexpr std::int64_t mul_div_floor(std::int64_t a, std::int64_t b, std::int64_t c) noexcept {
  return detail::mul_div(
      a, b, c, [](std::uint64_t, std::uint64_t) { return 0U; },
      [](std::uint64_t, std::uint64_t) { return 1U; });
}

/// The integer nearest to a*b/c, ties towards +infinity, saturated.
[[nodiscard]] constexpr std::int64_t mul_div_nearest(std::int64_t a, std::int64_t b,
                                                     std::int64_t c) noexcept {
  return detail::mul_div(
      a, b, c, [](std::uint64_t rest, std::uint64_t d) { return rest >= d - rest ? 1U : 0U; },
      [](std::uint64_t rest, std::uint64_t d) { return rest > d - rest ? 1U : 0U; });
}

static_assert(mul_div_floor(-7, 1, 2) == -4 && mul_div_nearest(-7, 1, 2) == -3 &&
              mul_div_nearest(7, 1, 2) == 4);

}  // namespace intaglio::number
