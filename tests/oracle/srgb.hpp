// SPDX-License-Identifier: MIT
//
// Oracle: the sRGB transfer functions of IEC 61966-2-1 in extended precision (errors below 2^-60).
#pragma once

#include <cmath>

namespace oracle {

/// Light 0 .. 1 of an encoded value 0 .. 1.
inline long double srgb_decode(long double value) {
  return value <= 0.04045L ? value / 12.92L : std::pow((value + 0.055L) / 1.055L, 2.4L);
}

/// Encoded value 0 .. 1 of light 0 .. 1.
inline long double srgb_encode(long double light) {
  return light <= 0.04045L / 12.92L ? light * 12.92L : 1.055L * std::pow(light, 1.0L / 2.4L) - 0.055L;
}

}  // namespace oracle
