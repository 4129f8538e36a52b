// SPDX-License-Identifier: MIT
//
// Products that don't fit 64 bits, compared.
//
// Rule: exact for all values. Where all factors have 32 bits, one comparison of 64-bit products; otherwise
// both products are held in two words (mul_div.hpp). Bit budget: 64 bits a factor.
#pragma once

#include <intaglio/number/mul_div.hpp>

#include <cstdint>

namespace intaglio::number {

/// p * q >= r * s.
[[nodiscard]] constexpr bool product_at_least(std::uint64_t p, std::uint64_t q, std::uint64_t r,
                                              std::uint64_t s) noexcept {
  if (((p | q | r | s) >> 32U) == 0) return p * q >= r * s;
  const auto [left_high, left_low] = detail::multiply_wide(p, q);
  const auto [right_high, right_low] = detail::multiply_wide(r, s);
  return left_high != right_high ? left_high > right_high : left_low >= right_low;
}

static_assert(product_at_least(~0ULL, ~0ULL, ~0ULL, ~0ULL) &&
              !product_at_least(~0ULL, 1, 1ULL << 32U, 1ULL << 32U));

}  // namespace intaglio::number
