// SPDX-License-Identifier: MIT
//
// Division of a long number by a word, for set-ups of lines and edges.
//
// Rule: quotient = floor(n / d), remainder = n - quotient*d, both exact.
//
// A core with a divider uses it. One without (Cortex-M0+, ARM926) subtracts shifted divisors, one binary
// digit of the quotient a step: slopes have short quotients, so this is as fast as the compiler's division
// there and a twentieth of its size (its 64-bit division and what that needs weigh 1.6 KiB).
//
// Bit budget: n < 2^63 and n / d < 2^32, so the shifted divisor stays at or below n, and its double in 64
// bits. Cost without a divider: about 25 instructions, and 22 for each digit of the quotient.
#pragma once

#include <cstdint>

namespace intaglio::number {

/// A quotient and what is left over.
struct LongDivision {
  std::uint32_t quotient;
  std::uint32_t remainder;
};

namespace detail {
/// The way of cores without a divider. Precondition: as `long_divide`.
[[nodiscard]] constexpr LongDivision long_divide_by_steps(std::uint64_t n, std::uint32_t d) noexcept {
  std::uint64_t shifted = d;
  std::uint32_t digit = 1;
  for (; shifted + shifted <= n; shifted += shifted) digit += digit;
  std::uint32_t quotient = 0;
  for (; digit != 0; digit >>= 1U, shifted >>= 1U) {
    if (n < shifted) continue;
    n -= shifted;
    quotient += digit;
  }
  return {quotient, static_cast<std::uint32_t>(n)};
}
}  // namespace detail

/// Divides. Precondition: n < 2^63, d > 0, n / d < 2^32.
[[nodiscard]] LongDivision long_divide(std::uint64_t n, std::uint32_t d) noexcept;

}  // namespace intaglio::number
