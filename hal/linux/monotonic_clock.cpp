// SPDX-License-Identifier: MIT
#include <hal/linux/monotonic_clock.hpp>

#include <cerrno>
#include <ctime>

namespace hal::linux_io {

namespace {
constexpr Nanoseconds second = 1'000'000'000;
}

Nanoseconds MonotonicClock::do_now() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<Nanoseconds>(now.tv_sec) * second + static_cast<Nanoseconds>(now.tv_nsec);
}

void MonotonicClock::do_wait_until(Nanoseconds time) noexcept {
  timespec until{};
  until.tv_sec = static_cast<time_t>(time / second);
  until.tv_nsec = static_cast<long>(time % second);
  // A signal ends the sleep early.
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

}  // namespace hal::linux_io
