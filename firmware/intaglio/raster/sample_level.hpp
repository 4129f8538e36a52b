// SPDX-License-Identifier: MIT
//
// From samples to levels of coverage, and from levels to spans.
//
// Rule: the level of `covered` out of `total` samples (weights) is the nearest of 0 to 255, ties up. Instead
// of a division, a multiplication by 255 * 2^16 / total, rounded up: that is too much by less than
// covered / 2^16, less than what products that aren't ties miss the next tie by. Error: none for totals up to
// 256 and for 400, each of which a test tries. Bit budget: covered * factor <= 255 * 2^16 + 400.
#pragma once

#include <intaglio/raster/coverage.hpp>

#include <algorithm>
#include <cstdint>

namespace intaglio::raster::detail {

/// Levels out of a fixed number of samples.
class SampleLevels {
 public:
  /// Precondition: total is 2 .. 256, or 400.
  constexpr explicit SampleLevels(int total) noexcept
      : total_(std::max(total, 1)),
        factor_(
            (static_cast<std::uint32_t>(full_coverage) * 65536U + static_cast<std::uint32_t>(total_) - 1U) /
            static_cast<std::uint32_t>(total_)) {}

  /// The level of so many; taken as 0 .. total.
  [[nodiscard]] constexpr int operator()(int covered) const noexcept {
    const auto weight = static_cast<std::uint32_t>(std::clamp(covered, 0, total_));
    return static_cast<int>((weight * factor_ + 32768U) >> 16U);
  }
  [[nodiscard]] constexpr int total() const noexcept { return total_; }

 private:
  int total_;
  std::uint32_t factor_;
};

/// Puts pixels of one level that follow each other in a row together.
template <CoverageSink S>
class CoverageRun {
 public:
  explicit CoverageRun(S& sink) noexcept : sink_(&sink) {}
  /// The next pixels of row y, from where the last ended or further right.
  void add(int y, int x_begin, int x_end, int coverage) {
    if (coverage == span_.coverage && y == span_.y && x_begin == span_.x_end) {
      span_.x_end = x_end;
      return;
    }
    flush();
    span_ = {y, x_begin, x_end, coverage};
  }
  /// Hands the last of them over.
  void flush() {
    if (span_.coverage != 0) sink_->span(span_.y, span_.x_begin, span_.x_end, span_.coverage);
    span_ = {};
  }

 private:
  S* sink_;
  CoverageSpan span_{};
};

}  // namespace intaglio::raster::detail
