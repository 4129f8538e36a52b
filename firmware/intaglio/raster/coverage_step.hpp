// SPDX-License-Identifier: MIT
//
// From levels of coverage to steps.
#pragma once

namespace intaglio::raster {

/// The step of 0 .. last that is nearest to a level of 0 .. 255: round(coverage * last / 255), for last up to
/// 255. There are no ties, as 255 is odd.
[[nodiscard]] constexpr unsigned coverage_step(int coverage, unsigned last) noexcept {
  // Division by 255, rounded, without a division: exact for products up to 255 * 255.
  const unsigned product = static_cast<unsigned>(coverage) * last + 128U;
  return (product + (product >> 8U)) >> 8U;
}

}  // namespace intaglio::raster
