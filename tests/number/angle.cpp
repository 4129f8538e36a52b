// SPDX-License-Identifier: MIT
#include <intaglio/number/angle.hpp>
#include <tests/oracle/integer.hpp>
#include <tests/oracle/random.hpp>

#include <gtest/gtest.h>

namespace {

using intaglio::number::Angle;
using intaglio::number::half_turn;
using intaglio::number::quarter_turn;

int wrapped(oracle::Wide steps) { return static_cast<int>(((steps % 65536) + 65536) % 65536); }

TEST(Angle, DegreesGiveTheNearestStepForEveryIntNearZeroAndTheEnds) {
  constexpr int min = std::numeric_limits<int>::min();
  constexpr int max = std::numeric_limits<int>::max();
  for (int i = 0; i < 2000; ++i)
    for (const int degrees : {i - 1000, min + i, max - i}) {
      const int nearest = wrapped(oracle::nearest_quotient(oracle::Wide{degrees} * 65536, 360));
      ASSERT_EQ(Angle::from_degrees(degrees).steps(), nearest) << degrees;
    }
}

TEST(Angle, DegreesSurviveTheWayThereAndBack) {
  for (int degrees = 0; degrees < 360; ++degrees)
    EXPECT_EQ(Angle::from_degrees(degrees).degrees_nearest(), degrees);
}

TEST(Angle, EveryStepHasItsNearestDegree) {
  for (int steps = 0; steps < Angle::turn; ++steps)
    ASSERT_EQ(Angle::from_steps(steps).degrees_nearest(), oracle::nearest_quotient(steps * 360, 65536))
        << steps;
}

TEST(Angle, RatiosGiveTheNearestStep) {
  oracle::Random random(20260104);
  for (int i = 0; i < 100'000; ++i) {
    const std::int64_t part = random.any_int64();
    const std::int64_t whole = random.any_int64();
    if (whole == 0) continue;
    // Whole turns are taken off first: what is left times 65536 fits 128 bits.
    const int nearest = wrapped(oracle::nearest_quotient(oracle::Wide{part} % whole * 65536, whole));
    ASSERT_EQ(Angle::from_ratio(part, whole).steps(), nearest)
        << part << '/' << whole << ", " << random.seed_text();
  }
  EXPECT_EQ(Angle::from_ratio(1, 0).steps(), 0);
  EXPECT_EQ(Angle::from_ratio(std::numeric_limits<std::int64_t>::min(), -1).steps(), 0);
}

TEST(Angle, ArithmeticWrapsModuloATurn) {
  oracle::Random random(20260105);
  for (int i = 0; i < 100'000; ++i) {
    const int a = random.any_int32();
    const int b = random.any_int32();
    const Angle x = Angle::from_steps(a);
    const Angle y = Angle::from_steps(b);
    ASSERT_EQ((x + y).steps(), wrapped(oracle::Wide{a} + b)) << random.seed_text();
    ASSERT_EQ((x - y).steps(), wrapped(oracle::Wide{a} - b)) << random.seed_text();
    ASSERT_EQ((-x).steps(), wrapped(-oracle::Wide{a})) << random.seed_text();
    ASSERT_EQ((x * b).steps(), wrapped(oracle::Wide{a} * b)) << random.seed_text();
  }
}

TEST(Angle, SignedStepsTakeTheShortWayRound) {
  EXPECT_EQ((-quarter_turn).signed_steps(), -16384);
  EXPECT_EQ(half_turn.signed_steps(), -32768);
  EXPECT_EQ((half_turn - Angle::from_steps(1)).signed_steps(), 32767);
}

TEST(Angle, AFullTurnInWholeDegreesEndsWhereItBegan) {
  int sum = 0;
  for (int degree = 0; degree < 360; ++degree)
    sum += (Angle::from_degrees(degree + 1) - Angle::from_degrees(degree)).steps();
  EXPECT_EQ(sum, Angle::turn);
}

}  // namespace
