// SPDX-License-Identifier: MIT
#include <intaglio/number/division.hpp>
#include <tests/oracle/integer.hpp>
#include <tests/oracle/random.hpp>

#include <gtest/gtest.h>

#include <array>

namespace {

using intaglio::number::ceil_div;
using intaglio::number::floor_div;
using intaglio::number::floor_divide;
using intaglio::number::round_div;

template <class T>
class Division : public testing::Test {};
using Types = testing::Types<int, long, std::int64_t>;
TYPED_TEST_SUITE(Division, Types);

/// True if all divisions of a by b answer as the oracle does. Divisors of zero have their own test.
template <class T>
bool agrees(T a, T b) {
  if (b == 0) return true;
  const auto [quotient, remainder] = floor_divide(a, b);
  const oracle::Wide floor = oracle::floor_quotient(a, b);
  if (floor_div(a, b) != oracle::clamp_to<T>(floor)) return false;
  if (ceil_div(a, b) != oracle::clamp_to<T>(oracle::ceil_quotient(a, b))) return false;
  if (round_div(a, b) != oracle::clamp_to<T>(oracle::nearest_quotient(a, b))) return false;
  if (quotient != floor) return floor > std::numeric_limits<T>::max() && remainder == 0;
  return remainder == static_cast<oracle::Wide>(a) - floor * b;
}

TYPED_TEST(Division, AllSmallPairsRoundAsNamed) {
  for (TypeParam a = -70; a <= 70; ++a)
    for (TypeParam b = -70; b <= 70; ++b) ASSERT_TRUE(agrees(a, b)) << a << " / " << b;
}

TYPED_TEST(Division, PairsFromTheEndsOfTheRangeRoundAsNamed) {
  using Limits = std::numeric_limits<TypeParam>;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      const std::array<TypeParam, 6> as{static_cast<TypeParam>(Limits::min() + i),
                                        static_cast<TypeParam>(Limits::max() - i),
                                        static_cast<TypeParam>(Limits::max() / 2 + i - 3),
                                        static_cast<TypeParam>(Limits::min() / 2 + i - 3),
                                        static_cast<TypeParam>(i),
                                        static_cast<TypeParam>(-i)};
      const std::array<TypeParam, 6> bs{static_cast<TypeParam>(Limits::min() + j),
                                        static_cast<TypeParam>(Limits::max() - j),
                                        static_cast<TypeParam>(Limits::max() / 2 + j - 3),
                                        static_cast<TypeParam>(Limits::min() / 2 + j - 3),
                                        static_cast<TypeParam>(j),
                                        static_cast<TypeParam>(-j)};
      for (const TypeParam a : as)
        for (const TypeParam b : bs) ASSERT_TRUE(agrees(a, b)) << a << " / " << b;
    }
}

TYPED_TEST(Division, RandomPairsRoundAsNamed) {
  oracle::Random random(20260101);
  for (int i = 0; i < 200'000; ++i) {
    const auto a = static_cast<TypeParam>(random.any_int64());
    const auto b = static_cast<TypeParam>(random.any_int64());
    ASSERT_TRUE(agrees(a, b)) << a << " / " << b << ", " << random.seed_text();
  }
}

TYPED_TEST(Division, ByZeroSaturatesToTheDividendsSide) {
  using Limits = std::numeric_limits<TypeParam>;
  const TypeParam zero = 0;
  EXPECT_EQ(floor_div(TypeParam{5}, zero), Limits::max());
  EXPECT_EQ(floor_div(TypeParam{-5}, zero), Limits::min());
  EXPECT_EQ(floor_div(zero, zero), 0);
  EXPECT_EQ(ceil_div(TypeParam{-5}, zero), Limits::min());
  EXPECT_EQ(ceil_div(TypeParam{5}, zero), Limits::max());
  EXPECT_EQ(round_div(TypeParam{5}, zero), Limits::max());
  EXPECT_EQ(round_div(TypeParam{-5}, zero), Limits::min());
}

TYPED_TEST(Division, TheOnlyQuotientThatDoesNotFitSaturates) {
  using Limits = std::numeric_limits<TypeParam>;
  EXPECT_EQ(floor_div(Limits::min(), TypeParam{-1}), Limits::max());
  EXPECT_EQ(ceil_div(Limits::min(), TypeParam{-1}), Limits::max());
  EXPECT_EQ(round_div(Limits::min(), TypeParam{-1}), Limits::max());
}

TEST(DivisionOfMixedTypes, UsesTheWiderType) {
  static_assert(std::is_same_v<decltype(floor_div(1, std::int64_t{2})), std::int64_t>);
  EXPECT_EQ(floor_div(std::int64_t{-10'000'000'001}, 10), -1'000'000'001);
}

}  // namespace
