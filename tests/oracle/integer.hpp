// SPDX-License-Identifier: MIT
//
// Oracle: quotients in 128 bits, straight from their definitions. Slow and sharing nothing with the library.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace oracle {

using Wide = __int128;

/// The largest q with q*d <= n (d > 0) or q*d >= n (d < 0), that is floor(n/d). d != 0, |n| < 2^127.
inline Wide floor_quotient(Wide n, Wide d) {
  Wide q = n / d;
  while (d > 0 ? q * d > n : q * d < n) --q;
  return q;
}

/// -floor(-n/d).
inline Wide ceil_quotient(Wide n, Wide d) { return -floor_quotient(-n, d); }

/// floor(n/d + 1/2): of floor and floor + 1 the one that is nearer, and the upper one of two as near.
inline Wide nearest_quotient(Wide n, Wide d) {
  const Wide q = floor_quotient(n, d);
  const Wide below = d > 0 ? n - q * d : q * d - n;
  const Wide above = (d > 0 ? d : -d) - below;
  return above <= below ? q + 1 : q;
}

/// The value of T nearest to `value`.
template <class T>
T clamp_to(Wide value) {
  return static_cast<T>(
      std::clamp<Wide>(value, std::numeric_limits<T>::min(), std::numeric_limits<T>::max()));
}

}  // namespace oracle
