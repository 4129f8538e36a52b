// SPDX-License-Identifier: MIT
//
// Reciprocal square roots of 32-bit numbers: floor(2^31 / sqrt(n)).
//
// Rule: n is shifted up by an even number of bits to m = 2^30..2^32 - 1, whose first 8 bits find 1/sqrt(m)
// with 9 bits in a table; the answer is shifted back by half as many. A Newton step takes half of e off,
// where m*r*r = 1 + e, and leaves 3/8 e*e. Two steps leave less than the last place of most answers; the
// exact rung then moves by single places. Or the root of a quotient: floor(sqrt(floor(2^62 / n))) is the same
// number.
//
// Error bounds: against the floor, so the last place of the least answers, 2^-15, counts where all else is
// right; they hold for all 2^32 - 1 numbers. Bit budget: of m*r*r only how far it is from one matters: |e| <
// 2^-6.7, so the first step may let the product wrap at 2^32 and reads it as signed; the second forms it in
// 64 bits. Textbook: none. Worst known inputs: 1140838453 for the table, 1577009152 after one step, numbers
// just below 2^32 after two; 1 for the range.
#pragma once

#include <intaglio/number/bound.hpp>
#include <intaglio/number/root.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace intaglio::number {

namespace detail {

/// round(f(x)) - 2^8 for x = i + 64 .. i + 65: `rounded(both)` is that of f, both the sum of sqrt(x) * 2^20
/// at both ends.
template <class Rounded>
[[nodiscard]] consteval std::array<std::uint8_t, 192> table_by_roots(Rounded rounded) {
  std::array<std::uint8_t, 192> table{};
  for (std::uint64_t i = 0; i < 192; ++i) {
    const std::uint64_t both = std::uint64_t{isqrt((i + 64) << 40U)} + isqrt((i + 65) << 40U);
    table[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(rounded(both) - 256);
  }
  return table;
}
/// Of 2^12 / sqrt(x): the reciprocal of the mean of the roots at both ends.
inline constexpr std::array<std::uint8_t, 192> reciprocal_roots =
    table_by_roots([](std::uint64_t both) { return ((1ULL << 33U) + both / 2) / both; });

/// A number, shifted up, and its reciprocal root in ever better approximations.
class ReciprocalRootSeed {
 public:
  /// Precondition: n > 0.
  constexpr explicit ReciprocalRootSeed(std::uint32_t n) noexcept
      : half_shift_(static_cast<unsigned>(std::countl_zero(n)) >> 1U),
        // n > 0 has fewer than 32 leading zeros.
        normal_(n << (2 * half_shift_)),  // NOLINT(clang-analyzer-core.UndefinedBinaryOperatorResult)
        seed_(256U + reciprocal_roots[(normal_ >> 24U) - 64U]) {}

  /// How far n was shifted, halved, and n after that.
  [[nodiscard]] constexpr unsigned half_shift() const noexcept { return half_shift_; }
  [[nodiscard]] constexpr std::uint32_t normal() const noexcept { return normal_; }

  /// 2^46 / sqrt(normal), from 2^30 up to 2^31: with the seed's 9 bits,
  [[nodiscard]] constexpr std::uint32_t first() const noexcept { return seed_ << 22U; }
  /// after one Newton step, with e in 2^-36 and then 2^-28,
  [[nodiscard]] constexpr std::uint32_t second() const noexcept {
    const auto off = static_cast<std::int32_t>((normal_ >> 12U) * (seed_ * seed_));
    const std::int32_t less = static_cast<std::int32_t>(seed_) * (off >> 8) >> 7;
    return first() - static_cast<std::uint32_t>(less);
  }
  /// and after two, with e in 2^-27.
  [[nodiscard]] constexpr std::uint32_t third() const noexcept {
    const std::uint32_t r = second() >> 15U;
    const auto product = static_cast<std::int64_t>(std::uint64_t{normal_} * (r * r));
    const auto off = static_cast<std::int32_t>((product - (std::int64_t{1} << 62U)) >> 35U);
    return (r << 15U) - static_cast<std::uint32_t>(static_cast<std::int32_t>(r) * off >> 13);
  }
  /// One of these as 2^31 / sqrt(n).
  [[nodiscard]] constexpr std::uint32_t back(std::uint32_t value) const noexcept {
    return value >> (15U - half_shift_);
  }

 private:
  unsigned half_shift_;
  std::uint32_t normal_;
  std::uint32_t seed_;
};

}  // namespace detail

/// From the table. Precondition of all: n > 0. Table: 192 bytes.
struct ReciprocalRootTable {
  static constexpr Bound bound = ppm_of_value(4'608'500);

  [[nodiscard]] constexpr std::uint32_t operator()(std::uint32_t n) const noexcept {
    const detail::ReciprocalRootSeed seed(n);
    return seed.back(seed.first());
  }
};

/// With one Newton step. Table: 192 bytes.
struct ReciprocalRootNewton {
  static constexpr Bound bound = ppm_of_value(36'985);

  [[nodiscard]] constexpr std::uint32_t operator()(std::uint32_t n) const noexcept {
    const detail::ReciprocalRootSeed seed(n);
    return seed.back(seed.second());
  }
};

/// With two Newton steps: at most 3 lsb off. Table: 192 bytes.
struct ReciprocalRootNewton2 {
  static constexpr Bound bound = ppm_of_value(30'518);
  static constexpr std::string_view slack = "one lsb is less of the longer answers for smaller numbers";

  [[nodiscard]] constexpr std::uint32_t operator()(std::uint32_t n) const noexcept {
    const detail::ReciprocalRootSeed seed(n);
    return seed.back(seed.third());
  }
};

/// Exact: two Newton steps, then single places until r*r*n <= 2^62 < (r + 1)*(r + 1)*n. r*r*n stays below
/// 2^63. Table: 192 bytes.
struct ReciprocalRootNewtonExact {
  static constexpr Bound bound = exactly(Unit::ppm_of_value);

  [[nodiscard]] constexpr std::uint32_t operator()(std::uint32_t n) const noexcept {
    constexpr std::uint64_t one = std::uint64_t{1} << 62U;
    std::uint64_t r = ReciprocalRootNewton2{}(n);
    std::uint64_t product = r * r * n;
    for (; product > one; --r) product -= (2 * r - 1) * n;
    for (; product + (2 * r + 1) * n <= one; ++r) product += (2 * r + 1) * n;
    return static_cast<std::uint32_t>(r);
  }
};

/// Exact, without a table: the root of a long quotient.
struct ReciprocalRootDivision {
  static constexpr Bound bound = exactly(Unit::ppm_of_value);

  [[nodiscard]] constexpr std::uint32_t operator()(std::uint32_t n) const noexcept {
    return isqrt((std::uint64_t{1} << 62U) / n);
  }
};

/// The rungs that compute floor(2^31 / sqrt(n)).
using ReciprocalRootFamily = Family<ReciprocalRootTable, ReciprocalRootNewton, ReciprocalRootNewton2,
                                    ReciprocalRootNewtonExact, ReciprocalRootDivision>;

}  // namespace intaglio::number
