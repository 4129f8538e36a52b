// SPDX-License-Identifier: MIT
#include <intaglio/number/long_division.hpp>

namespace intaglio::number {

namespace {

#if defined(__arm__) && !defined(__ARM_FEATURE_IDIV)
constexpr bool has_divider = false;
#else
constexpr bool has_divider = true;
#endif

}  // namespace

LongDivision long_divide(std::uint64_t n, std::uint32_t d) noexcept {
  if constexpr (has_divider) {
    const auto narrow = static_cast<std::uint32_t>(n);
    if (narrow == n) return {narrow / d, narrow % d};
    return {static_cast<std::uint32_t>(n / d), static_cast<std::uint32_t>(n % d)};
  }
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

}  // namespace intaglio::number
