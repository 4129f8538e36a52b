// SPDX-License-Identifier: MIT
#include <intaglio/number/mul_div.hpp>
#include <tests/oracle/integer.hpp>
#include <tests/oracle/random.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace {

using intaglio::number::mul_div_floor;
using intaglio::number::mul_div_nearest;

constexpr std::int64_t min = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t max = std::numeric_limits<std::int64_t>::max();

/// True if both answer as the oracle does. Divisors of zero have their own test.
bool agrees(std::int64_t a, std::int64_t b, std::int64_t c) {
  if (c == 0) return true;
  const oracle::Wide product = static_cast<oracle::Wide>(a) * b;
  return mul_div_floor(a, b, c) == oracle::clamp_to<std::int64_t>(oracle::floor_quotient(product, c)) &&
         mul_div_nearest(a, b, c) == oracle::clamp_to<std::int64_t>(oracle::nearest_quotient(product, c));
}

TEST(MulDiv, AllTriplesOfSmallAndExtremeNumbersAreExact) {
  std::vector<std::int64_t> values;
  for (std::int64_t i = -3; i <= 3; ++i)
    for (const std::int64_t base :
         {std::int64_t{0}, std::int64_t{1} << 31, -(std::int64_t{1} << 31), std::int64_t{1} << 32,
          std::int64_t{1} << 62, std::int64_t{3'037'000'500}})
      values.push_back(base + i);
  for (std::int64_t i = 0; i < 4; ++i) {
    values.push_back(min + i);
    values.push_back(max - i);
    values.push_back(min / 2 + i);
  }
  for (const std::int64_t a : values)
    for (const std::int64_t b : values)
      for (const std::int64_t c : values) ASSERT_TRUE(agrees(a, b, c)) << a << " * " << b << " / " << c;
}

TEST(MulDiv, RandomTriplesOfAllSizesAreExact) {
  oracle::Random random(20260102);
  for (int i = 0; i < 300'000; ++i) {
    const std::int64_t a = random.any_int64();
    const std::int64_t b = random.any_int64();
    const std::int64_t c = random.any_int64();
    ASSERT_TRUE(agrees(a, b, c)) << a << " * " << b << " / " << c << ", " << random.seed_text();
  }
}

TEST(MulDiv, QuotientsNextToTheEndsOfTheRangeAreExact) {
  // max * (c +- a little) / c is max +- a little: saturation must begin at the right place.
  for (const std::int64_t c : {std::int64_t{2}, std::int64_t{3}, std::int64_t{1'000'003}, max / 2, max - 2})
    for (std::int64_t i = -2; i <= 2; ++i)
      for (std::int64_t j = 0; j < 4; ++j) {
        ASSERT_TRUE(agrees(max - j, c + i, c)) << i << ' ' << j << ' ' << c;
        ASSERT_TRUE(agrees(min + j, c + i, c)) << i << ' ' << j << ' ' << c;
      }
}

TEST(MulDiv, ByZeroSaturatesToTheProductsSide) {
  EXPECT_EQ(mul_div_floor(3, 4, 0), max);
  EXPECT_EQ(mul_div_floor(-3, 4, 0), min);
  EXPECT_EQ(mul_div_floor(0, 4, 0), 0);
  EXPECT_EQ(mul_div_nearest(-3, -4, 0), max);
}

}  // namespace
