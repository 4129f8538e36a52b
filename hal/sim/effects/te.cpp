// SPDX-License-Identifier: MIT
#include <hal/sim/effects/noise.hpp>
#include <hal/sim/effects/te.hpp>

namespace hal::sim {

TeLine::TeLine(const TeTiming& timing, Clock& clock, std::uint32_t nominal_millihertz)
    : timing_(timing), ticks_(&clock, nominal_millihertz) {}

Nanoseconds TeLine::delay(std::uint64_t refresh) const {
  note_call(Effect::te);
  return timing_.phase + noise_up_to(timing_.jitter, refresh ^ 0x7E00'0000'0000U);
}

}  // namespace hal::sim
