// SPDX-License-Identifier: MIT
//
// Oracle: sine of a binary angle in units of 2^-62, by its series in 128-bit integers.
#pragma once

#include <cstdint>

namespace oracle {

/// |sine_q62(a) - 2^62 sin(a)| is below this: 2 * 14 roundings of at most one unit, the rounding of pi, and a
/// remainder (pi/2)^29 / 29! < 2^-83.
inline constexpr std::int64_t sine_q62_error = 64;

/// 2^62 * sin(2 pi steps / 65536), steps 0 .. 65535.
inline std::int64_t sine_q62(int steps) {
  if (steps >= 32768) return -sine_q62(steps - 32768);
  if (steps > 16384) return sine_q62(32768 - steps);
  constexpr unsigned __int128 pi_q62 = 0xC90FDAA22168C235U;
  const auto x = static_cast<__int128>((pi_q62 * static_cast<unsigned>(steps)) >> 15U);
  const __int128 square = x * x >> 62;
  __int128 term = x;
  __int128 sum = x;
  for (int k = 2; k <= 28; k += 2) {
    term = -((term * square >> 62) / (k * (k + 1)));
    sum += term;
  }
  return static_cast<std::int64_t>(sum);
}

}  // namespace oracle
