// SPDX-License-Identifier: MIT
#include <intaglio/number/blend.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/samples.hpp>

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

namespace {

namespace number = intaglio::number;

/// How many rungs of a family are further than their bound from t / whole.
template <class T, class... R>
int misses(number::Family<R...> /*rungs*/, std::int64_t whole, T from, T to, T alpha) {
  const std::int64_t t = from * (whole - alpha) + to * std::int64_t{alpha};
  const auto missed = [&](std::int64_t value, number::Bound bound) {
    return std::abs(value * whole - t) * 1000 > bound.thousandths * whole;
  };
  return (... + missed(R{}(from, to, alpha), R::bound));
}

TEST(Blend, EveryRungOf8BitsStaysWithinItsBoundForAllArguments) {
  int missed = 0;
  const int step = oracle::samples(15, 1);
  for (int from = 0; from < 256; from += step)
    for (int to = 0; to < 256; ++to)
      for (int alpha = 0; alpha < 256; ++alpha)
        missed += misses(number::Blend8Family{}, 255, static_cast<std::uint8_t>(from),
                         static_cast<std::uint8_t>(to), static_cast<std::uint8_t>(alpha));
  EXPECT_EQ(missed, 0);
}

TEST(Blend, EveryRungOf16BitsStaysWithinItsBound) {
  oracle::Random random(20261125);
  // Ends of the range as often as what is between.
  const auto value = [&] {
    const auto any = static_cast<std::uint16_t>(random.bits());
    return static_cast<std::uint16_t>(random.between(0, 1) == 0 ? any : (any % 8U - 4U) & 0xFFFFU);
  };
  int missed = 0;
  for (int i = oracle::samples(100'000, 10'000'000); i > 0; --i) {
    const std::uint16_t from = value();
    const std::uint16_t to = value();
    missed += misses(number::Blend16Family{}, 65535, from, to, value());
  }
  EXPECT_EQ(missed, 0) << random.seed_text();
}

TEST(Blend, AllButTheShiftGiveBackAValueBlendedWithItselfOrByNothingOrAll) {
  int wrong = 0;
  const auto check = [&](const auto& blend, auto value, auto other) {
    const auto none = static_cast<decltype(value)>(0);
    const auto all = std::numeric_limits<decltype(value)>::max();
    wrong += blend(value, other, none) != value;
    wrong += blend(other, value, all) != value;
    wrong += blend(value, value, other) != value;
  };
  for (int value = 0; value < 256; ++value)
    for (int other = 0; other < 256; ++other) {
      const auto a = static_cast<std::uint8_t>(value);
      const auto b = static_cast<std::uint8_t>(other);
      check(number::Blend8WeightOneProduct{}, a, b);
      check(number::Blend8Weight{}, a, b);
      check(number::Blend8TwoShiftsDown{}, a, b);
      check(number::Blend8TwoShifts{}, a, b);
      const auto long_a = static_cast<std::uint16_t>(value * 257);
      const auto long_b = static_cast<std::uint16_t>(65535 - other);
      check(number::Blend16Weight{}, long_a, long_b);
      check(number::Blend16TwoShiftsDown{}, long_a, long_b);
      check(number::Blend16TwoShifts{}, long_a, long_b);
    }
  EXPECT_EQ(wrong, 0);
}

}  // namespace
