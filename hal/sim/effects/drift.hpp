// SPDX-License-Identifier: MIT
//
// Refresh drift: the panel's oscillator runs off the nominal rate.
//
// Rule: a refresh that begins at time t lasts nominal + round(nominal * d(t) / 10^9), d in parts of 10^9:
// -1000 * ppm (a faster panel has shorter refreshes) times 1, or times a triangle wave that is 0 at t = 0,
// rises to 1 at a quarter of the period and falls to -1 at three quarters; d itself is rounded, too.
// Budget: |ppm| <= 10^5, so |d| <= 10^8; nominal is at most 1000 s, of which d times the whole seconds is at
// most 10^11 and d times the rest below 10^17. A period is at most 60 s, so d times the wave is below
// 6.1 * 10^18 < 2^63.
#pragma once

#include <hal/sim/effects/effects.hpp>

namespace hal::sim {

/// How long a refresh that begins at `time` lasts.
[[nodiscard]] Nanoseconds drifting_frame_time(const RefreshDrift& drift, Nanoseconds nominal,
                                              Nanoseconds time);

}  // namespace hal::sim
