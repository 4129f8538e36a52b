// SPDX-License-Identifier: MIT
//
// From levels of coverage to steps.
//
// Rule: round(coverage * last / 255). There are no ties, as 255 is odd: a quotient is 1/510 or more from the
// next, so 2^24/255, rounded down, is as good as the fraction: products with it are off by less than 2^-8 of
// 1/255. Bit budget: 255 * 255 * 2^24/255 and half a step, below 2^32.
#pragma once

#include <cstdint>

namespace intaglio::raster {

/// Steps first .. first+last of a ramp, for levels of 0 to 255. `first + last` is up to 255.
class CoverageRamp {
 public:
  constexpr CoverageRamp() noexcept = default;
  constexpr CoverageRamp(unsigned first, unsigned last) noexcept
      : scale_(last * (((1U << 24U) - 1) / 255U)), offset_((first << 24U) + (1U << 23U)) {}
  /// The nearest step: first + round(coverage * last / 255).
  [[nodiscard, gnu::always_inline]] constexpr unsigned index(int coverage) const noexcept {
    return (static_cast<std::uint32_t>(coverage) * scale_ + offset_) >> 24U;
  }

 private:
  std::uint32_t scale_ = 0;
  std::uint32_t offset_ = 0;
};

/// The step of 0 .. last that is nearest to a level of 0 .. 255: round(coverage * last / 255), for last up to
/// 255.
[[nodiscard]] constexpr unsigned coverage_step(int coverage, unsigned last) noexcept {
  return CoverageRamp(0, last).index(coverage);
}

}  // namespace intaglio::raster
