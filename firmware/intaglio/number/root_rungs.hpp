// SPDX-License-Identifier: MIT
//
// Other ways to the square root of a 32-bit number: rungs beside the one of root.hpp.
//
// Rule: all answer about floor(sqrt(n)), for every n, 0 for 0:
// - digit by digit (root.hpp);
// - from a table: n is shifted up by an even number of bits, its first 8 find the root with 9 bits, and that
// is
//   shifted back by half as many;
// - r' = (r + n/r) / 2, with the division of the processor or the compiler's library, from the table's root
// or
//   from a power of two. With floors r' is never below the floor of the root, so the first r that isn't
//   smaller than its successor is it; from the table's root one step leaves at most one too much;
// - n times its reciprocal root (reciprocal_root.hpp) after one Newton step: at most 3 too little, which
//   the exact rung adds.
//
// Error bounds: in whole numbers, against the floor; for all 2^32 numbers, of which a full test run asks the
// exact rungs.
// Bit budget: 32 bits unsigned throughout, see each rung. Textbook: none. Worst known inputs: squares and
// their neighbours; 2^32 - 1, whose root rounds up to 17 bits on the way.
#pragma once

#include <intaglio/number/bound.hpp>
#include <intaglio/number/reciprocal_root.hpp>
#include <intaglio/number/root.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace intaglio::number {

namespace detail {

/// Of 2^5 * sqrt(x): the mean of both ends.
inline constexpr std::array<std::uint8_t, 192> roots =
    table_by_roots([](std::uint64_t both) { return (both + (1ULL << 15U)) / (1ULL << 16U); });

/// The root from the table; n > 0.
[[nodiscard]] constexpr std::uint32_t root_by_table(std::uint32_t n) noexcept {
  const unsigned half_shift = static_cast<unsigned>(std::countl_zero(n)) >> 1U;
  return (256U + roots[(n << (2 * half_shift) >> 24U) - 64U]) << 7U >> half_shift;
}

/// sqrt(m) from the reciprocal root r of m in 16 bits, rounded down: at most 3 too little. r <= 2^31 /
/// sqrt(m) * (1 + 2^-18), so the product, sqrt(m) * 2^16, stays below 2^32: where it could reach that, r is
/// 2^15.
[[nodiscard]] constexpr std::uint32_t root_by_reciprocal(const ReciprocalRootSeed& seed) noexcept {
  return (seed.normal() >> 15U) * (seed.second() >> 15U) >> 16U;
}

}  // namespace detail

/// Digit by digit: `isqrt`.
struct RootBitwise {
  static constexpr Bound bound = exactly();

  [[nodiscard]] constexpr std::uint32_t operator()(std::uint32_t n) const noexcept { return isqrt(n); }
};

/// From the table. Table: 192 bytes.
struct RootTable {
  static constexpr Bound bound{180'000};
  static constexpr std::string_view slack = "what is 2^-8 of a large root is less of a small one";

  [[nodiscard]] constexpr std::uint32_t operator()(std::uint32_t n) const noexcept {
    return n == 0 ? 0 : detail::root_by_table(n);
  }
};

/// The number times its reciprocal root. Table: 192 bytes.
struct RootReciprocalNewton {
  static constexpr Bound bound{3'000};
  static constexpr std::string_view slack = "small roots are shifted from large ones, and so is their error";

  [[nodiscard]] constexpr std::uint32_t operator()(std::uint32_t n) const noexcept {
    if (n == 0) return 0;
    const detail::ReciprocalRootSeed seed(n);
    return detail::root_by_reciprocal(seed) >> seed.half_shift();
  }
};

/// The same, made exact: while the rest of m is more than 2r, there is one more. Table: 192 bytes.
struct RootReciprocalNewtonExact {
  static constexpr Bound bound = exactly();

  [[nodiscard]] constexpr std::uint32_t operator()(std::uint32_t n) const noexcept {
    if (n == 0) return 0;
    const detail::ReciprocalRootSeed seed(n);
    std::uint32_t root = detail::root_by_reciprocal(seed);
    for (std::uint32_t rest = seed.normal() - root * root; rest > 2 * root; ++root) rest -= 2 * root + 1;
    return root >> seed.half_shift();
  }
};

/// One step with a division from the table's root. Table: 192 bytes.
struct RootTableDivision {
  static constexpr Bound bound = exactly();

  [[nodiscard]] constexpr std::uint32_t operator()(std::uint32_t n) const noexcept {
    if (n == 0) return 0;
    const std::uint32_t near = detail::root_by_table(n);
    const std::uint32_t root = (near + n / near) >> 1U;
    // root * root > n, without 2^16 squared.
    return (root - 1) * (root + 1) >= n ? root - 1 : root;
  }
};

/// Steps with divisions from the power of two above the root.
struct RootNewtonDivision {
  static constexpr Bound bound = exactly();

  [[nodiscard]] constexpr std::uint32_t operator()(std::uint32_t n) const noexcept {
    if (n == 0) return 0;
    std::uint32_t root = std::uint32_t{1} << (static_cast<unsigned>(std::bit_width(n) + 1) >> 1U);
    for (;;) {
      const std::uint32_t next = (root + n / root) >> 1U;
      if (next >= root) return root;
      root = next;
    }
  }
};

/// The rungs that compute a square root.
using RootFamily = Family<RootTable, RootReciprocalNewton, RootTableDivision, RootReciprocalNewtonExact,
                          RootNewtonDivision, RootBitwise>;

}  // namespace intaglio::number
