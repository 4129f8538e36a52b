// SPDX-License-Identifier: MIT
//
// The rhythm of panels that don't tell when their VBLANK begins: ticks of a clock at the refresh rate.
//
// Rule: tick n is due n periods after the first question, the period rounded down to whole nanoseconds.
// Without a clock every wait is a tick, so frames follow each other as fast as the bus takes them.
#pragma once

#include <hal/vblank.hpp>

#include <cstdint>

namespace hal::panels {

class FrameTicks final : public VblankSource {
 public:
  /// `clock` may be null; 0 `millihertz` are taken for 1.
  FrameTicks(Clock* clock, std::uint32_t millihertz) noexcept
      : clock_(clock), period_(1'000'000'000'000U / (millihertz == 0 ? 1U : millihertz)) {}

 private:
  std::uint32_t do_count() noexcept override;
  Status do_wait() noexcept override;
  Nanoseconds do_last() noexcept override;
  /// Since the first question.
  Nanoseconds elapsed() noexcept;

  Clock* clock_;
  Nanoseconds period_;
  Nanoseconds start_ = 0;
  bool started_ = false;
  std::uint32_t free_ticks_ = 0;
};

}  // namespace hal::panels
