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
  return detail::long_divide_by_steps(n, d);
}

}  // namespace intaglio::number
