// SPDX-License-Identifier: MIT
//
// How long a device is waited for.
//
// Rule: a clock that leaps (the program was stopped, the machine slept) is no reason to give a device up: the
// time is over only when it was tried a few times more behind its end.
#pragma once

#include <hal/clock.hpp>
#include <hal/status.hpp>

namespace hal::hid {

class Patience {
 public:
  Patience(Clock& clock, Nanoseconds time, int chances = 8)
      : clock_(&clock), until_(clock.now() + time), chances_(chances) {}

  /// True if the time is over. To be asked once a try.
  [[nodiscard]] bool over() { return clock_->now() >= until_ && ++late_ > chances_; }
  /// What is left of the time, at least `least`: a try takes as long.
  [[nodiscard]] Nanoseconds left(Nanoseconds least) const {
    const Nanoseconds now = clock_->now();
    return now < until_ && until_ - now > least ? until_ - now : least;
  }

 private:
  Clock* clock_;
  Nanoseconds until_;
  int chances_;
  int late_ = 0;
};

/// Looks for a device that was unplugged until `attempt()`, which opens it and sets it up, succeeds, or finds
/// that it is another one (unsupported). Errors: that of the last attempt; disconnected if nothing answered.
template <class Attempt>
Status look_for_device(Clock& clock, Nanoseconds time, Attempt&& attempt) {
  constexpr Nanoseconds between_looks = 50'000'000;
  for (Patience patience(clock, time, 0);;) {
    const Status s = attempt();
    if (s.ok() || s.error() == Error::unsupported) return s;
    if (patience.over()) return s.error() == Error::timeout ? Status{Error::disconnected, Part::panel} : s;
    clock.wait_until(clock.now() + between_looks);
  }
}

}  // namespace hal::hid
