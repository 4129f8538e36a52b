// SPDX-License-Identifier: MIT
//
// Oracle: what a panel does to time and light, from the definitions; times as quotients of 128 bits, light in
// extended precision.
#pragma once

#include <tests/oracle/integer.hpp>
#include <tests/oracle/srgb.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace oracle {

/// The whole nanosecond by which pixel `pixel` (from 0) of a window has arrived.
inline Wide bus_arrival(Wide gap, Wide hertz, Wide clocks_per_byte, Wide command_bytes, Wide bits,
                        Wide pixel) {
  const Wide bytes = command_bytes + ceil_quotient((pixel + 1) * bits, 8);
  return gap + floor_quotient(1'000'000'000 * clocks_per_byte * bytes, hertz);
}

/// A beam that fetches `lines` of `total` lines in refreshes of `frame` nanoseconds from time 0 on.
struct Beam {
  Wide frame;
  int lines;
  int total;
  [[nodiscard]] Wide fetch(Wide refresh, int line) const {
    return refresh * frame + floor_quotient(frame * line, total);
  }
};

/// How many pixels of a line of `width`, of a picture sent row by row from `begin` on, had arrived when the
/// beam fetched it. `arrival(pixel)`: as `bus_arrival`.
template <class Arrival>
int arrived(const Beam& beam, Wide refresh, int line, int width, Wide begin, Arrival&& arrival) {
  int count = 0;
  while (count < width && begin + arrival(Wide{line} * width + count) < beam.fetch(refresh, line)) ++count;
  return count;
}

/// The length of a refresh that begins at `time` on a panel that is `ppm` fast, to and fro within `period`
/// (0: always): not rounded yet, in 1/(10^9 * period or 1).
inline long double drifting_frame(long double nominal, int ppm, Wide period, Wide time) {
  long double wave = 1;
  if (period > 0) {
    const long double turn = static_cast<long double>(time % period) / static_cast<long double>(period);
    wave = turn < 0.25L ? 4 * turn : turn < 0.75L ? 2 - 4 * turn : 4 * turn - 4;
  }
  return nominal * (1 - wave * static_cast<long double>(ppm) / 1e6L);
}

/// What is left of the way after `frame`, if 10 % to 90 % of it take `response`.
inline long double left_after(long double frame, long double response) {
  return response == 0 ? 0 : std::exp(-frame * std::log(9.0L) / response);
}

/// Light (0..1) after refreshes that sent these codes, from dark on.
inline long double light_after(const std::vector<int>& codes, long double left_rising,
                               long double left_falling) {
  long double light = 0;
  for (const int code : codes) {
    const long double target = srgb_decode(static_cast<long double>(code) / 255);
    light = target + (light - target) * (light < target ? left_rising : left_falling);
  }
  return light;
}

/// A code as a number that isn't rounded yet.
inline long double code_of(long double light) { return 255 * srgb_encode(light); }

}  // namespace oracle
