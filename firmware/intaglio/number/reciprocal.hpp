// SPDX-License-Identifier: MIT
//
// Reciprocals of 16-bit numbers: floor(2^31 / d).
//
// Rule: the divisor is shifted up to n = 2^15..2^16 - 1, whose 8 bits below the first find 1/n with 9 bits in
// a table; the answer is shifted back. One Newton step, r*(2 - n*r), squares the error, which is known to be
// below 2^-8 and so has 16 bits: no product leaves 32 bits. What is then missing in the remainder of 2^31 / d
// is made up for once more for an exact answer. Or the processor, or the compiler's library, divides.
//
// Error bounds: the largest over all 65,535 divisors, which a test goes through: 2^-8.5 of the value for the
// table; a Newton step is never above the floor and less than 1 lsb + 2^-16 below. Bit budget: see the rungs.
// Textbook: none. Worst known inputs: 137 for the table, 65174 after a Newton step; 1 for the range.
#pragma once

#include <intaglio/number/bound.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace intaglio::number {

namespace detail {

/// round(2^9 / m) - 2^8 for m in the middle of each 256th of 1..2.
[[nodiscard]] consteval std::array<std::uint8_t, 256> make_reciprocals() {
  std::array<std::uint8_t, 256> table{};
  for (unsigned i = 0; i < 256; ++i) {
    const unsigned middle = 2 * (256 + i) + 1;  // m * 2^9
    table[i] = static_cast<std::uint8_t>(((1U << 18U) + middle / 2) / middle - 256);
  }
  return table;
}
inline constexpr std::array<std::uint8_t, 256> reciprocals = make_reciprocals();

/// A divisor, shifted up, and 2^31 / d from the table.
class ReciprocalSeed {
 public:
  constexpr explicit ReciprocalSeed(std::uint16_t d) noexcept
      : shift_(static_cast<unsigned>(std::countl_zero(d))),
        normal_(unsigned{d} << shift_),
        seed_(256U + reciprocals[normal_ >> 7U & 255U]) {}
  /// 2^31 / d with the seed's 9 bits.
  [[nodiscard]] constexpr std::uint32_t first() const noexcept { return back(seed_ << 22U); }
  /// The same after a Newton step. n*r = 2^24 * (1 + e), |e| < 2^-8: e has 16 bits, and a product with r 25.
  [[nodiscard]] constexpr std::uint32_t second() const noexcept {
    const auto off = static_cast<std::int32_t>(normal_ * seed_) - (1 << 24);
    return back((seed_ << 22U) - static_cast<std::uint32_t>(static_cast<std::int32_t>(seed_) * off >> 2));
  }

 private:
  [[nodiscard]] constexpr std::uint32_t back(std::uint32_t value) const noexcept {
    return value >> (15U - shift_);
  }

  unsigned shift_;
  unsigned normal_;
  unsigned seed_;
};

}  // namespace detail

/// From the table. Precondition of all: d > 0. Table: 256 bytes.
struct ReciprocalTable256 {
  static constexpr Bound bound = ppm_of_value(2'853'400);

  [[nodiscard]] constexpr std::uint32_t operator()(std::uint16_t d) const noexcept {
    return detail::ReciprocalSeed(d).first();
  }
};

/// With one Newton step. Table: 256 bytes.
struct ReciprocalTable256Newton {
  static constexpr Bound bound = ppm_of_value(30'350);
  static constexpr std::string_view slack =
      "one lsb of the long reciprocals of small divisors is less of them";

  [[nodiscard]] constexpr std::uint32_t operator()(std::uint16_t d) const noexcept {
    return detail::ReciprocalSeed(d).second();
  }
};

/// Exact: the remainder, at most 2^14 + d, times the reciprocal itself, 2^17 after a shift; then one lsb may
/// be missing. Table: 256 bytes.
struct ReciprocalTable256NewtonExact {
  static constexpr Bound bound = exactly(Unit::ppm_of_value);

  [[nodiscard]] constexpr std::uint32_t operator()(std::uint16_t d) const noexcept {
    constexpr std::uint32_t dividend = 1U << 31U;
    std::uint32_t quotient = detail::ReciprocalSeed(d).second();
    quotient += (quotient >> 14U) * (dividend - quotient * d) >> 17U;
    return dividend - quotient * d >= d ? quotient + 1 : quotient;
  }
};

/// The language's division.
struct ReciprocalDivision {
  static constexpr Bound bound = exactly(Unit::ppm_of_value);

  [[nodiscard]] constexpr std::uint32_t operator()(std::uint16_t d) const noexcept { return (1U << 31U) / d; }
};

/// The rungs that compute floor(2^31 / d).
using ReciprocalFamily =
    Family<ReciprocalTable256, ReciprocalTable256Newton, ReciprocalTable256NewtonExact, ReciprocalDivision>;

}  // namespace intaglio::number
