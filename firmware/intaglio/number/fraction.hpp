// SPDX-License-Identifier: MIT
//
// Fractions that are compared, never rounded.
//
// Rule: two fractions are compared by cross multiplication, so the order is that of the rational numbers and
// 1/3 equals 2/6. Nothing is ever divided.
//
// Bit budget: numerators within 2^31, denominators 1 .. 2^31-1: the products fit int64. Error: none.
// Textbook: section 2.9.2, the parameters of clipped lines. Worst known input: parameters that differ by less
// than 2^-58, which rounded ones confuse.
#pragma once

#include <compare>
#include <cstdint>
#include <numeric>

namespace intaglio::number {

/// numerator / denominator, with a denominator above zero.
struct Fraction {
  int numerator = 0;
  int denominator = 1;

  /// By value: 1/3 == 2/6.
  friend constexpr std::strong_ordering operator<=>(Fraction a, Fraction b) noexcept {
    return std::int64_t{a.numerator} * b.denominator <=> std::int64_t{b.numerator} * a.denominator;
  }
  friend constexpr bool operator==(Fraction a, Fraction b) noexcept {
    return std::int64_t{a.numerator} * b.denominator == std::int64_t{b.numerator} * a.denominator;
  }
};

/// n / d for d != 0 of either sign; |n| and |d| are below 2^31.
[[nodiscard]] constexpr Fraction fraction(int n, int d) noexcept {
  return d < 0 ? Fraction{-n, -d} : Fraction{n, d};
}

/// The same number in lowest terms. Cost: Euclid's algorithm, at most 45 divisions of 32 bits.
[[nodiscard]] constexpr Fraction reduced(Fraction f) noexcept {
  const int divisor = std::gcd(f.numerator, f.denominator);
  return {f.numerator / divisor, f.denominator / divisor};
}

}  // namespace intaglio::number
