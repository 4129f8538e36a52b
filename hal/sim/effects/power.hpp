// SPDX-License-Identifier: MIT
//
// Logarithms and powers of two in integers, so that light is the same on every machine.
//
// Rule: log2 by squaring the mantissa, a bit a step; 2^-y by multiplying the roots 2^-(2^-i) of y's bits.
// Bounds: `log2_of` is within 2^-29; `two_to_minus` within 2^-27 of its value; `power` within 2^-25 of the
// whole for exponents up to 5. Budget: mantissas have 32 bits, products 64.
#pragma once

#include <cstdint>

namespace hal::sim {

/// log2(x) in 1/2^32. x >= 1.
[[nodiscard]] std::uint64_t log2_of(std::uint32_t x);
/// 2^-y in 1/2^32, y in 1/2^32; 2^32 for y = 0.
[[nodiscard]] std::uint64_t two_to_minus(std::uint64_t y);
/// (numerator / denominator) ^ (hundredths / 100) in 1/2^32. 0 <= numerator <= denominator, denominator >= 1,
/// hundredths 1..500.
[[nodiscard]] std::uint64_t power(std::uint32_t numerator, std::uint32_t denominator, int hundredths);

}  // namespace hal::sim
