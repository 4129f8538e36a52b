// SPDX-License-Identifier: MIT
#include <intaglio/number/fixed.hpp>
#include <intaglio/number/root.hpp>
#include <tests/oracle/integer.hpp>
#include <tests/oracle/random.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace {

using intaglio::number::Fixed;
using oracle::Wide;

constexpr std::int32_t min = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t max = std::numeric_limits<std::int32_t>::max();

std::int32_t clamped(Wide value) { return oracle::clamp_to<std::int32_t>(value); }

/// Both ends of the range, the neighbourhood of zero, halves, and random numbers of all sizes.
std::vector<std::int32_t> samples(std::uint32_t seed) {
  std::vector<std::int32_t> values;
  for (int i = 0; i < 5; ++i)
    for (const std::int32_t value : {min + i, max - i, i - 2, (1 << 30) + i - 2, -(1 << 30) + i - 2,
                                     (1 << 15) + i - 2, (1 << 16) + i - 2})
      values.push_back(value);
  oracle::Random random(seed);
  for (int i = 0; i < 100; ++i) values.push_back(random.any_int32());
  return values;
}

template <class F>
class FixedOf : public testing::Test {};
using Formats = testing::Types<Fixed<0>, Fixed<1>, Fixed<8>, Fixed<15>, Fixed<16>, Fixed<30>, Fixed<31>>;
TYPED_TEST_SUITE(FixedOf, Formats);

TYPED_TEST(FixedOf, SumsDifferencesAndNegationsAreExactOrSaturated) {
  for (const std::int32_t a : samples(1))
    for (const std::int32_t b : samples(2)) {
      const auto x = TypeParam::from_raw(a);
      const auto y = TypeParam::from_raw(b);
      ASSERT_EQ((x + y).raw(), clamped(Wide{a} + b)) << a << ' ' << b;
      ASSERT_EQ((x - y).raw(), clamped(Wide{a} - b)) << a << ' ' << b;
      ASSERT_EQ((-x).raw(), clamped(-Wide{a})) << a;
      ASSERT_EQ(x < y, a < b);
    }
}

template <int A, int B>
void expect_products_and_quotients_round_as_named() {
  const Wide scale = Wide{1} << B;
  for (const std::int32_t a : samples(3))
    for (const std::int32_t b : samples(4)) {
      const auto x = Fixed<A>::from_raw(a);
      const auto y = Fixed<B>::from_raw(b);
      ASSERT_EQ(multiply_floor(x, y).raw(), clamped(oracle::floor_quotient(Wide{a} * b, scale)))
          << a << ' ' << b;
      ASSERT_EQ(multiply_nearest(x, y).raw(), clamped(oracle::nearest_quotient(Wide{a} * b, scale)))
          << a << ' ' << b;
      if (b == 0) continue;
      ASSERT_EQ(divide_floor(x, y).raw(), clamped(oracle::floor_quotient(a * scale, b))) << a << ' ' << b;
      ASSERT_EQ(divide_nearest(x, y).raw(), clamped(oracle::nearest_quotient(a * scale, b))) << a << ' ' << b;
    }
}

TYPED_TEST(FixedOf, ProductsAndQuotientsOfAnyTwoFormatsRoundAsNamed) {
  constexpr int bits = TypeParam::fraction_bits;
  expect_products_and_quotients_round_as_named<bits, bits>();
  expect_products_and_quotients_round_as_named<bits, 0>();
  expect_products_and_quotients_round_as_named<bits, 15>();
  expect_products_and_quotients_round_as_named<bits, 31>();
}

TYPED_TEST(FixedOf, DivisionByZeroSaturatesToTheDividendsSide) {
  const auto zero = TypeParam{};
  EXPECT_EQ(divide_floor(TypeParam::from_raw(7), zero), TypeParam::max());
  EXPECT_EQ(divide_nearest(TypeParam::from_raw(-7), zero), TypeParam::min());
  EXPECT_EQ(divide_nearest(zero, zero), zero);
}

TYPED_TEST(FixedOf, IntegersComeOutRoundedAsNamed) {
  const Wide scale = Wide{1} << TypeParam::fraction_bits;
  for (const std::int32_t raw : samples(5)) {
    const auto x = TypeParam::from_raw(raw);
    ASSERT_EQ(x.floor(), oracle::floor_quotient(raw, scale)) << raw;
    ASSERT_EQ(x.ceil(), oracle::ceil_quotient(raw, scale)) << raw;
    ASSERT_EQ(x.nearest(), oracle::nearest_quotient(raw, scale)) << raw;
    ASSERT_EQ(TypeParam::from_int(raw).raw(), clamped(raw * scale)) << raw;
  }
}

TYPED_TEST(FixedOf, RatiosRoundAsNamedForAll64BitNumbers) {
  const Wide scale = Wide{1} << TypeParam::fraction_bits;
  oracle::Random random(20260106);
  for (int i = 0; i < 20'000; ++i) {
    const std::int64_t n = random.any_int64();
    const std::int64_t d = random.any_int64();
    if (d == 0) continue;
    ASSERT_EQ(TypeParam::from_ratio_floor(n, d).raw(), clamped(oracle::floor_quotient(n * scale, d)))
        << n << '/' << d << ", " << random.seed_text();
    ASSERT_EQ(TypeParam::from_ratio_nearest(n, d).raw(), clamped(oracle::nearest_quotient(n * scale, d)))
        << n << '/' << d << ", " << random.seed_text();
  }
}

template <int G, class F>
void expect_conversions_round_as_named() {
  for (const std::int32_t raw : samples(6)) {
    const Wide up = Wide{raw} * (Wide{1} << G);
    const Wide scale = Wide{1} << F::fraction_bits;
    ASSERT_EQ(F::from_raw(raw).template to_floor<G>().raw(), clamped(oracle::floor_quotient(up, scale)))
        << raw;
    ASSERT_EQ(F::from_raw(raw).template to_nearest<G>().raw(), clamped(oracle::nearest_quotient(up, scale)))
        << raw;
  }
}

TYPED_TEST(FixedOf, ConversionsRoundAsNamed) {
  expect_conversions_round_as_named<0, TypeParam>();
  expect_conversions_round_as_named<8, TypeParam>();
  expect_conversions_round_as_named<16, TypeParam>();
  expect_conversions_round_as_named<31, TypeParam>();
}

TYPED_TEST(FixedOf, RootsRoundAsNamed) {
  constexpr int bits = TypeParam::fraction_bits;
  for (const std::int32_t raw : samples(7)) {
    const auto x = TypeParam::from_raw(raw);
    if (raw < 0) {
      ASSERT_EQ(sqrt_floor(x).raw(), 0);
      ASSERT_EQ(sqrt_nearest(x).raw(), 0);
      continue;
    }
    const Wide n = Wide{raw} << bits;
    const Wide floor = sqrt_floor(x).raw();
    const Wide nearest = sqrt_nearest(x).raw();
    ASSERT_TRUE(floor * floor <= n && n < (floor + 1) * (floor + 1)) << raw;
    ASSERT_TRUE((2 * nearest - 1) * (2 * nearest - 1) < 4 * n || nearest == 0) << raw;
    ASSERT_TRUE(4 * n < (2 * nearest + 1) * (2 * nearest + 1) || nearest == max) << raw;
  }
}

TEST(Scale, GivesTheNearestWholeNumber) {
  for (const std::int32_t value : samples(8))
    for (const std::int32_t factor : samples(9)) {
      const auto f = Fixed<15>::from_raw(factor);
      ASSERT_EQ(scale_floor(value, f), clamped(oracle::floor_quotient(Wide{value} * factor, 32768)));
      ASSERT_EQ(scale_nearest(value, f), clamped(oracle::nearest_quotient(Wide{value} * factor, 32768)));
    }
}

}  // namespace
