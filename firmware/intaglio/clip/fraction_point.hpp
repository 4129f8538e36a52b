// SPDX-License-Identifier: MIT
//
// A place on a line, exactly: where a parameter that is a fraction leads.
//
// Rule: from a to b the parameter n/d leads to a + (b-a)*n/d, kept as two numerators over d. Rounding comes
// last, and once: `nearest` with ties towards +x and +y, which doesn't depend on the direction of the line.
//
// Bit budget: coordinates within 2^28 sub-pixels, so differences within 2^29; 0 <= n <= d <= 2^29. Numerators
// stay within 2^57 since the place lies between a and b. Error: none before rounding, then half a sub-pixel
// on each axis (`nearest`) or less than one (`floor`).
// Textbook: section 2.9.2. Worst known input: a line across the whole domain, met at a place 1/2^29 from a
// tie.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/number/fraction.hpp>

#include <cstdint>

namespace intaglio::clip {

/// The place (x / denominator, y / denominator), in 1/256 pixel.
struct FractionPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  int denominator = 1;  ///< 1 .. 2^29
  friend constexpr bool operator==(const FractionPoint&, const FractionPoint&) noexcept = default;
};

/// The place at `t`, 0 <= t <= 1, on the way from a to b, which are in the domain. Its denominator is t's.
[[nodiscard]] constexpr FractionPoint place_between(linear::SubPoint a, linear::SubPoint b,
                                                    number::Fraction t) noexcept {
  const auto along = [t](int from, int to) {
    return std::int64_t{from} * t.denominator + std::int64_t{to - from} * t.numerator;
  };
  return {along(a.x, b.x), along(a.y, b.y), t.denominator};
}

/// The nearest sub-pixel place, ties towards +x and +y. The place must be in the domain, |x/d| <= 2^28.
[[nodiscard]] linear::SubPoint nearest(const FractionPoint& p) noexcept;
/// The last sub-pixel place that isn't right of it or below it. The place must be in the domain.
[[nodiscard]] linear::SubPoint floor(const FractionPoint& p) noexcept;

}  // namespace intaglio::clip
