// SPDX-License-Identifier: MIT
//
// The reset line of a display controller.
#pragma once

#include <hal/clock.hpp>
#include <hal/pin.hpp>

namespace hal::panels {

/// Pulls the line low for 1 ms and waits until every controller here takes commands: an ILI9341 needs 10 us
/// and 5 ms, a ST7789 the same, the OLED controllers a few us. Errors: those of the pin.
inline Status pulse_reset(OutputPin& reset, Clock& clock) noexcept {
  constexpr Nanoseconds millisecond = 1'000'000;
  if (const Status s = reset.set(false); !s.ok()) return s;
  clock.wait_until(clock.now() + millisecond);
  if (const Status s = reset.set(true); !s.ok()) return s;
  clock.wait_until(clock.now() + 5 * millisecond);
  return {};
}

}  // namespace hal::panels
