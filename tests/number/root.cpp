// SPDX-License-Identifier: MIT
#include <intaglio/number/root.hpp>
#include <tests/oracle/random.hpp>

#include <gtest/gtest.h>

namespace {

using intaglio::number::isqrt;
using intaglio::number::isqrt_nearest;
using Wide = unsigned __int128;

/// r*r <= n < (r+1)*(r+1).
bool is_floor_root(Wide n, Wide r) { return r * r <= n && n < (r + 1) * (r + 1); }
/// (r - 1/2)^2 < n < (r + 1/2)^2, times four.
bool is_nearest_root(Wide n, Wide r) {
  return (r == 0 || (2 * r - 1) * (2 * r - 1) < 4 * n) && 4 * n < (2 * r + 1) * (2 * r + 1);
}

TEST(Root, EverySquareOf32BitsAndItsNeighboursAreExact) {
  int wrong = 0;
  for (std::uint64_t r = 0; r < 65536; ++r)
    for (const std::uint64_t n : {r * r, r * r + r, r * r + r + 1, r * r + 2 * r}) {
      const auto small = static_cast<std::uint32_t>(n);
      wrong += !is_floor_root(n, isqrt(small));
      wrong += !is_nearest_root(n, isqrt_nearest(small));
      wrong += isqrt(n) != isqrt(small);
    }
  EXPECT_EQ(wrong, 0);
}

TEST(Root, SquaresOf64BitsAndTheirNeighboursAreExact) {
  oracle::Random random(20260103);
  for (int i = 0; i < 100'000; ++i) {
    const std::uint64_t r = i < 1000 ? 0xFFFFFFFFU - static_cast<std::uint64_t>(i)
                                     : (random.bits() >> 32U) >> (random.bits() % 32U);
    for (const std::uint64_t n : {r * r, r * r - (r > 0 ? 1 : 0), r * r + r, r * r + r + 1, r * r + 2 * r}) {
      ASSERT_TRUE(is_floor_root(n, isqrt(n))) << n << ", " << random.seed_text();
      // The one root whose nearest integer, 2^32, isn't representable saturates.
      const bool saturates = n > 0xFFFFFFFFULL * 0xFFFFFFFFULL + 0xFFFFFFFFULL;
      ASSERT_TRUE(saturates ? isqrt_nearest(n) == 0xFFFFFFFFU : is_nearest_root(n, isqrt_nearest(n)))
          << n << ", " << random.seed_text();
    }
  }
}

TEST(Root, LargestArgumentsAreExact) {
  EXPECT_EQ(isqrt(0xFFFFFFFFU), 65535U);
  EXPECT_EQ(isqrt(0xFFFFFFFFFFFFFFFFULL), 0xFFFFFFFFU);
  EXPECT_EQ(isqrt(std::uint8_t{255}), 15U);
}

}  // namespace
