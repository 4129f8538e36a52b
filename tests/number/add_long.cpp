// SPDX-License-Identifier: MIT
#include <intaglio/number/add_long.hpp>

#include <gtest/gtest.h>

#include <cstdint>

namespace {

using intaglio::number::add_long;

__extension__ using Wide = __int128;

Wide joined(std::uint32_t low, std::uint32_t middle, int high) {
  return (Wide{high} * (Wide{1} << 64U)) + (Wide{middle} << 32U) + Wide{low};
}

TEST(AddLong, CarriesFromWordToWord) {
  const std::uint32_t words[] = {0, 1, 0x7FFF'FFFF, 0x8000'0000, 0xFFFF'FFFE, 0xFFFF'FFFF};
  const int tops[] = {-0x4000'0000, -1, 0, 1, 0x3FFF'FFFE};
  int wrong = 0;
  for (const std::uint32_t a : words)
    for (const std::uint32_t b : words)
      for (const int c : tops)
        for (const std::uint32_t d : words)
          for (const std::uint32_t e : words)
            for (const int f : tops) {
              std::uint32_t low = a;
              std::uint32_t middle = b;
              int high = c;
              add_long(low, middle, high, d, e, f);
              wrong += joined(low, middle, high) != joined(a, b, c) + joined(d, e, f) ? 1 : 0;
            }
  EXPECT_EQ(wrong, 0);
}

}  // namespace
