// SPDX-License-Identifier: MIT
//
// Time: nanoseconds since an arbitrary start, never backwards. 64 bits last 584 years.
#pragma once

#include <cstdint>

namespace hal {

using Nanoseconds = std::uint64_t;

class Clock {
 public:
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;

  [[nodiscard]] Nanoseconds now() noexcept { return do_now(); }
  /// Returns at or after the given time; the core may sleep.
  void wait_until(Nanoseconds time) noexcept { do_wait_until(time); }

 protected:
  constexpr Clock() noexcept = default;
  ~Clock() = default;

 private:
  virtual Nanoseconds do_now() noexcept = 0;
  virtual void do_wait_until(Nanoseconds time) noexcept = 0;
};

}  // namespace hal
