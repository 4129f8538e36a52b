// SPDX-License-Identifier: MIT
//
// Square roots of integers, exact; other ways to them are in root_rungs.hpp.
//
// Rule: isqrt(n) is the largest r with r*r <= n, for every n of the type; hence monotone, and 0 for 0.
//
// One binary digit of the root a step, from the highest that can be set (the classic method of remainders:
// `rest` is what is left of n, `root` twice the root found so far, in place). Bit budget: both stay below
// 2^width(n), so no step can overflow; no multiplication, no division, no table.
// Cost: about 8 instructions a binary digit of the root, fewer digits for small numbers: on Cortex-M3 at most
// 140 for 32 bits, 550 for 64.
#pragma once

#include <intaglio/number/fixed.hpp>

#include <bit>
#include <concepts>
#include <cstdint>

namespace intaglio::number {

/// The floor of the square root of an unsigned integer of up to 64 bits. Fits 16 bits for a 32-bit argument.
template <std::unsigned_integral N>
[[nodiscard]] constexpr std::uint32_t isqrt(N n) noexcept {
  static_assert(sizeof(N) <= 8);
  using Word = decltype(n + 0U);
  Word rest = n;
  Word root = 0;
  if (rest == 0) return 0;
  // The largest power of four <= n.
  Word bit = Word{1} << (static_cast<unsigned>(std::bit_width(rest) - 1) & ~1U);
  for (; bit != 0; bit >>= 2U) {
    const Word trial = root + bit;
    root >>= 1U;
    if (rest >= trial) {
      rest -= trial;
      root += bit;
    }
  }
  return static_cast<std::uint32_t>(root);
}

/// The integer nearest to the square root (never a tie: half-way lies r*r + r + 1/4).
template <std::unsigned_integral N>
[[nodiscard]] constexpr std::uint32_t isqrt_nearest(N n) noexcept {
  const std::uint64_t root = isqrt(n);
  // (r + 1/2)^2 = r*r + r + 1/4 < n exactly if n > r*r + r. The last root of 64 bits, 2^32 - 1, stays: its
  // neighbour doesn't fit.
  const bool up = std::uint64_t{n} - root * root > root && root != 0xFFFFFFFFU;
  return static_cast<std::uint32_t>(up ? root + 1 : root);
}

/// The square root of a number in its own format; 0 for numbers below 0. Bit budget: raw * 2^F < 2^62.
/// Rounding up could leave the range only for F = 31, next to 1, and is saturated.
template <int F>
[[nodiscard]] constexpr Fixed<F> sqrt_floor(Fixed<F> x) noexcept {
  if (x.raw() <= 0) return {};
  return Fixed<F>::from_raw(saturate(isqrt(static_cast<std::uint64_t>(x.raw()) << F)));
}
template <int F>
[[nodiscard]] constexpr Fixed<F> sqrt_nearest(Fixed<F> x) noexcept {
  if (x.raw() <= 0) return {};
  return Fixed<F>::from_raw(saturate(isqrt_nearest(static_cast<std::uint64_t>(x.raw()) << F)));
}

static_assert(isqrt(0U) == 0 && isqrt(99U) == 9 && isqrt(0xFFFFFFFFFFFFFFFFULL) == 0xFFFFFFFFU);

}  // namespace intaglio::number
