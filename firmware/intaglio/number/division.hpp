// SPDX-License-Identifier: MIT
//
// Integer division that says which way it rounds.
//
// Rule: floor_div is the largest q with q*b <= a, ceil_div the smallest q with q*b >= a, round_div the
// integer nearest to a/b, ties towards +infinity (the tie rule of every rounding in this library, so that
// moving a picture by whole pixels moves its ties along). `/` of C++ rounds towards zero instead, which kinks
// at zero.
//
// Answers exist for all arguments: the one quotient that doesn't fit, min / -1, is saturated to max, and a
// division by zero answers with the end of the range on the dividend's side (0 for 0/0).
//
// Bit budget: only the quotient and remainder of the argument type are formed, and no sum of them leaves it:
// |remainder| < |b|, and a quotient is corrected by one only when the remainder isn't zero, so it isn't at
// the end of the range. Cost: one division of that type; on a 32-bit core int is far cheaper than int64.
//
// Worst known input: min / -1 (traps on x86, answers min on Arm when left to the processor).
#pragma once

#include <concepts>
#include <limits>

namespace intaglio::number {

/// A quotient and what is left over: a = quotient * b + remainder.
template <std::signed_integral T>
struct Division {
  T quotient = 0;
  T remainder = 0;
  friend constexpr bool operator==(const Division&, const Division&) noexcept = default;
};

namespace detail {
/// The type in which a / b is computed.
template <class A, class B>
using Quotient = decltype(A{} / B{});
}  // namespace detail

/// The floor of a/b and the remainder, which has the sign of b or is zero: for b > 0 it lies in 0 .. b-1.
/// Saturated quotients (see the head of this file) come with remainder 0.
template <std::signed_integral A, std::signed_integral B>
[[nodiscard]] constexpr auto floor_divide(A a, B b) noexcept -> Division<detail::Quotient<A, B>> {
  using T = detail::Quotient<A, B>;
  using Limits = std::numeric_limits<T>;
  const T dividend = a;
  const T divisor = b;
  if (divisor == 0) return {dividend == 0 ? T{0} : dividend > 0 ? Limits::max() : Limits::min(), 0};
  if (divisor == -1 && dividend == Limits::min()) return {Limits::max(), 0};
  T quotient = dividend / divisor;
  T remainder = dividend % divisor;
  if (remainder != 0 && (remainder < 0) != (divisor < 0)) {
    --quotient;
    remainder += divisor;
  }
  return {quotient, remainder};
}

/// The largest integer <= a/b.
template <std::signed_integral A, std::signed_integral B>
[[nodiscard]] constexpr auto floor_div(A a, B b) noexcept {
  return floor_divide(a, b).quotient;
}

/// The smallest integer >= a/b.
template <std::signed_integral A, std::signed_integral B>
[[nodiscard]] constexpr auto ceil_div(A a, B b) noexcept {
  const auto [quotient, remainder] = floor_divide(a, b);
  return remainder == 0 ? quotient : quotient + 1;
}

/// The integer nearest to a/b; ties towards +infinity.
template <std::signed_integral A, std::signed_integral B>
[[nodiscard]] constexpr auto round_div(A a, B b) noexcept {
  const auto [quotient, remainder] = floor_divide(a, b);
  // With r and b of one sign, 2|r| >= |b| asked without forming 2r: is what is missing to b no more than r?
  const decltype(quotient) missing = static_cast<decltype(quotient)>(b) - remainder;
  const bool up = remainder != 0 && (b > 0 ? remainder >= missing : remainder <= missing);
  return up ? quotient + 1 : quotient;
}

static_assert(floor_div(-1, 2) == -1 && ceil_div(-1, 2) == 0 && round_div(-1, 2) == 0 &&
              round_div(1, 2) == 1);

}  // namespace intaglio::number
