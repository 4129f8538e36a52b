// SPDX-License-Identifier: MIT
#include <hal/sim/effects/drift.hpp>

namespace hal::sim {

namespace {

/// n / d to the nearest, ties away from zero. d > 0.
std::int64_t nearest(std::int64_t n, std::int64_t d) { return (n < 0 ? n - d / 2 : n + d / 2) / d; }

}  // namespace

Nanoseconds drifting_frame_time(const RefreshDrift& drift, Nanoseconds nominal, Nanoseconds time) {
  note_call(Effect::drift);
  std::int64_t parts = -std::int64_t{1000} * drift.ppm;
  if (drift.period > 0) {
    const auto period = static_cast<std::int64_t>(drift.period);
    const auto at = static_cast<std::int64_t>(time % drift.period);
    // Quarters of the period that the wave is away from zero, times the period.
    const std::int64_t wave = 4 * at <= period       ? 4 * at
                              : 4 * at <= 3 * period ? 2 * period - 4 * at
                                                     : 4 * at - 4 * period;
    parts = nearest(parts * wave, period);
  }
  // In whole seconds and a rest, which is exact.
  constexpr std::int64_t second = 1'000'000'000;
  const auto length = static_cast<std::int64_t>(nominal);
  return static_cast<Nanoseconds>(length + length / second * parts +
                                  nearest(length % second * parts, second));
}

}  // namespace hal::sim
