// SPDX-License-Identifier: MIT
//
// Sectors by definition, in extended floating point: 64 bits, where 2^-35 would do to tell all pixels apart.
#pragma once

#include <cmath>

namespace oracle {

/// True if the direction of (x, y), clockwise from three o'clock, is at or after `angle` (in 1/65536 turn, 0
/// .. 65536). The centre counts as three o'clock.
inline bool at_or_after(int x, int y, int angle) {
  if (x == 0 && y == 0) x = 1;
  if (angle == 0) return true;
  if (angle >= 65536) return false;
  // The other half of the turn first; then the sign of the cross product, which is exact on the diagonals.
  const bool lower = y > 0 || (y == 0 && x > 0);
  if (lower != (angle < 32768)) return !lower;
  if (angle % 8192 == 0) {
    const int cosines[] = {1, 1, 0, -1, -1, -1, 0, 1};
    const int i = angle / 8192;
    return static_cast<long long>(y) * cosines[i] - static_cast<long long>(x) * cosines[(i + 6) % 8] >= 0;
  }
  const long double turn = 6.283185307179586476925286766559005768L * static_cast<long double>(angle) / 65536;
  return static_cast<long double>(y) * std::cos(turn) - static_cast<long double>(x) * std::sin(turn) > 0;
}

/// True if a sweep has the direction of (x, y).
inline bool in_sweep(int x, int y, int start, long long sweep) {
  if (sweep >= 65536 || sweep <= -65536) return true;
  int first = static_cast<int>(((sweep < 0 ? start + sweep : start) % 65536 + 65536) % 65536);
  const int last = first + static_cast<int>(sweep < 0 ? -sweep : sweep);
  const auto between = [&](int from, int to) { return at_or_after(x, y, from) && !at_or_after(x, y, to); };
  if (last <= 65536) return between(first, last);
  return between(first, 65536) || between(0, last - 65536);
}

}  // namespace oracle
