// SPDX-License-Identifier: MIT
//
// Rounding of exact places: see the header for the rule.
#include <intaglio/clip/fraction_point.hpp>
#include <intaglio/number/long_division.hpp>

namespace intaglio::clip {
namespace {

/// floor(n / d) for |n / d| <= 2^29, 0 < d <= 2^30: the dividend is moved above zero by a multiple of d, so
/// it stays below 2^60.
int floor_quotient(std::int64_t n, int d) noexcept {
  constexpr int shift = 1 << 29;
  const auto above = static_cast<std::uint64_t>(n + std::int64_t{shift} * d);
  return static_cast<int>(number::long_divide(above, static_cast<std::uint32_t>(d)).quotient) - shift;
}

}  // namespace

linear::SubPoint nearest(const FractionPoint& p) noexcept {
  const auto round = [d = p.denominator](std::int64_t n) { return floor_quotient(2 * n + d, 2 * d); };
  return {round(p.x), round(p.y)};
}

linear::SubPoint floor(const FractionPoint& p) noexcept {
  return {floor_quotient(p.x, p.denominator), floor_quotient(p.y, p.denominator)};
}

}  // namespace intaglio::clip
