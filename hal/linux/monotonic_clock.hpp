// SPDX-License-Identifier: MIT
//
// Time as the kernel counts it since it was started: the clock of edge events and of VBLANK events, too.
#pragma once

#include <hal/clock.hpp>

namespace hal::linux_io {

class MonotonicClock final : public Clock {
 public:
  MonotonicClock() noexcept = default;

 private:
  Nanoseconds do_now() noexcept override;
  void do_wait_until(Nanoseconds time) noexcept override;
};

}  // namespace hal::linux_io
