// SPDX-License-Identifier: MIT
//
// Which steps of an even walk fall between two bounds: how maps of pictures find the pixels of a row that
// show anything, without trying them.
//
// Rule: the place after n steps is start + n * step; it is inside if it is 0 or above and below the limit.
// Bit budget: |start|, limit < 2^57; |step| <= 2^24; counts up to 2^21. Error: none.
#pragma once

#include <intaglio/number/long_division.hpp>

#include <cstdint>

namespace intaglio::image::detail {

/// The numbers first .. last-1; none if last <= first.
struct StepRange {
  int first;
  int last;
};

/// The smallest n in 0 .. count with n * step >= height; count if there is none. 1 <= step <= 2^24.
[[nodiscard]] inline int steps_to(std::int64_t height, std::int32_t step, int count) noexcept {
  if (height <= 0) return 0;
  if (height > std::int64_t{step} * count) return count;
  const auto divisor = static_cast<std::uint32_t>(step);
  return static_cast<int>(
      number::long_divide(static_cast<std::uint64_t>(height) + divisor - 1U, divisor).quotient);
}

/// The n in 0 .. count-1 with 0 <= start + n * step < limit. Cost: at most two divisions.
[[nodiscard]] inline StepRange steps_inside(std::int64_t start, std::int32_t step, std::int64_t limit,
                                            int count) noexcept {
  if (step == 0) return {0, start >= 0 && start < limit ? count : 0};
  // A falling place is a rising one seen from the other end.
  if (step < 0) {
    start = limit - 1 - start;
    step = -step;
  }
  return {steps_to(-start, step, count), steps_to(limit - start, step, count)};
}

}  // namespace intaglio::image::detail
