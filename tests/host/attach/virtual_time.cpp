// SPDX-License-Identifier: MIT
//
// The clock of Linux, stood in for by that of the kernel that isn't there: found before the library's.
#include <hal/linux/monotonic_clock.hpp>
#include <tests/hal/linux/fake_gpio.hpp>

namespace hal::linux_io {

Nanoseconds MonotonicClock::do_now() noexcept { return static_cast<Clock&>(fake_gpio::kernel().clock).now(); }

void MonotonicClock::do_wait_until(Nanoseconds time) noexcept {
  static_cast<Clock&>(fake_gpio::kernel().clock).wait_until(time);
}

}  // namespace hal::linux_io
