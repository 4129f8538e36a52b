// SPDX-License-Identifier: MIT
//
// The upper half of a product of words.
//
// Rule: floor(a * b / 2^32), exactly. Cores without a product of 64 bits (Cortex-M0+) put it together from
// four of halves, which takes less than half of what the compiler's function for 64-bit products does.
// Bit budget: each sum there is at most (2^16 - 1)^2 + 2 * (2^16 - 1) < 2^32.
#pragma once

#include <cstdint>

namespace intaglio::number {

namespace detail {
/// The way of cores without a product of 64 bits.
[[nodiscard]] constexpr std::uint32_t multiply_high_by_halves(std::uint32_t a, std::uint32_t b) noexcept {
  constexpr std::uint32_t half = 0xFFFF;
  const std::uint32_t a_high = a >> 16U;
  const std::uint32_t b_high = b >> 16U;
  const std::uint32_t upper = a_high * (b & half) + ((a & half) * (b & half) >> 16U);
  const std::uint32_t lower = (a & half) * b_high + (upper & half);
  return a_high * b_high + (upper >> 16U) + (lower >> 16U);
}
}  // namespace detail

/// The upper 32 bits of a * b.
[[nodiscard]] constexpr std::uint32_t multiply_high(std::uint32_t a, std::uint32_t b) noexcept {
#if defined(__ARM_ARCH_6M__)
  return detail::multiply_high_by_halves(a, b);
#else
  return static_cast<std::uint32_t>(std::uint64_t{a} * b >> 32U);
#endif
}

}  // namespace intaglio::number
