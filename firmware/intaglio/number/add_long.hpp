// SPDX-License-Identifier: MIT
//
// Sums of numbers of three words.
//
// Rule: the sum, exactly; it must fit. Compilers for 32 bits keep a carry in its flag from the lower word of
// 64 bits to the upper one, but fetch it into a register for a third: seven instructions instead of three.
#pragma once

#include <cstdint>

namespace intaglio::number {

/// Adds a number of three words, the lowest first, to another.
[[gnu::always_inline]] inline void add_long(std::uint32_t& low, std::uint32_t& middle, int& high,
                                            std::uint32_t add_low, std::uint32_t add_middle,
                                            int add_high) noexcept {
#if defined(__arm__) && (!defined(__thumb__) || defined(__thumb2__))
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  int c = 0;
  asm("adds %[a], %[low], %[add_low]\n\t"
      "adcs %[b], %[middle], %[add_middle]\n\t"
      "adc %[c], %[high], %[add_high]"
      : [a] "=&r"(a), [b] "=&r"(b), [c] "=r"(c)
      : [low] "r"(low), [middle] "r"(middle), [high] "r"(high), [add_low] "r"(add_low),
        [add_middle] "r"(add_middle), [add_high] "r"(add_high)
      : "cc");
  low = a;
  middle = b;
  high = c;
#else
  const std::uint64_t a = std::uint64_t{low} + add_low;
  const std::uint64_t b = std::uint64_t{middle} + add_middle + (a >> 32U);
  low = static_cast<std::uint32_t>(a);
  middle = static_cast<std::uint32_t>(b);
  high += add_high + static_cast<int>(b >> 32U);
#endif
}

}  // namespace intaglio::number
