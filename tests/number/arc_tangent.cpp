// SPDX-License-Identifier: MIT
#include <intaglio/number/arc_tangent.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/samples.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace {

namespace number = intaglio::number;
using number::Angle;

constexpr int least = std::numeric_limits<int>::min();

/// In 1/65536 turn.
double exact_steps(double y, double x) { return std::atan2(y, x) * (32768 / std::acos(-1.0)); }

bool within(number::Bound bound, Angle angle, double exact) {
  return std::fabs(std::remainder(angle.steps() - exact, 65536.0)) * 1000 <= bound.thousandths;
}

template <class... R>
int misses(number::Family<R...> /*rungs*/, int x, int y) {
  const double exact = exact_steps(y, x);
  return (... + !within(R::bound, R{}(x, y), exact));
}

/// Of a family's rungs, how many have other angles for mirrored directions than mirrored ones.
template <class... R>
int crooked(number::Family<R...> /*rungs*/, int x, int y) {
  const auto one = [&](const auto& rung) {
    const Angle angle = rung(x, y);
    return rung(x, -y) != -angle || rung(-x, y) != number::half_turn - angle ||
           rung(y, x) != number::quarter_turn - angle;
  };
  return (... + one(R{}));
}

TEST(ArcTangent, EveryRungStaysWithinItsBoundForShortAndLongDirections) {
  int missed = 0;
  for (int y = -150; y <= 150; ++y)
    for (int x = -150; x <= 150; ++x) missed += misses(number::ArcTangentFamily{}, x, y);
  oracle::Random random(20261126);
  for (int i = oracle::samples(50'000, 5'000'000); i > 0; --i) {
    const int x = random.any_int32();
    missed += misses(number::ArcTangentFamily{}, x, random.any_int32());
  }
  for (const int x : {least, least + 1, -1, 0, 1, -(least + 1)})
    for (const int y : {least, least + 1, -1, 0, 1, -(least + 1)})
      missed += misses(number::ArcTangentFamily{}, x, y);
  EXPECT_EQ(missed, 0) << random.seed_text();
}

/// The largest error of a curve over all quotients, in thousandths of a step.
template <class R>
double worst_of_curve() {
  double worst = 0;
  for (unsigned z = 0; z <= 32768; ++z)
    worst = std::max(worst, std::fabs(R::curve(z) - exact_steps(z, 32768.0)));
  return worst * 1000;
}

TEST(ArcTangent, CurvesLeaveRoomInTheirBoundsForTheQuotientsRounding) {
  constexpr double quotient = 478;  // (1/2 + 1) * 2^-15 of 65536/(2 pi) steps.
  EXPECT_LE(worst_of_curve<number::ArcTangentLinear>() + quotient,
            number::ArcTangentLinear::bound.thousandths);
  EXPECT_LE(worst_of_curve<number::ArcTangentParabola>() + quotient,
            number::ArcTangentParabola::bound.thousandths);
  EXPECT_LE(worst_of_curve<number::ArcTangentPolynomial9>() + quotient,
            number::ArcTangentPolynomial9::bound.thousandths);
  EXPECT_LE(worst_of_curve<number::ArcTangentTable128Linear>() + quotient,
            number::ArcTangentTable128Linear::bound.thousandths);
}

TEST(ArcTangent, MirroredDirectionsHaveMirroredAngles) {
  int wrong = 0;
  for (int y = 1; y <= 60; ++y)
    for (int x = 1; x <= 60; ++x)
      wrong += x == y ? 0 : crooked(number::ArcTangentFamily{}, x * 1'000'003, y * 1'000'003);
  EXPECT_EQ(wrong, 0);
}

/// How many of a family's rungs don't answer with so many steps.
template <class... R>
int other_than(number::Family<R...> /*rungs*/, int x, int y, int steps) {
  return (... + (R{}(x, y).steps() != steps));
}

TEST(ArcTangent, AxesAndDiagonalsAreExactAndNoDirectionHasAngleZero) {
  constexpr int ahead[] = {1, 1, 0, -1, -1, -1, 0, 1};
  for (int eighth = 0; eighth < 8; ++eighth)
    for (const int length : {1, 7, 65537, -(least + 1)})
      EXPECT_EQ(other_than(number::ArcTangentFamily{}, ahead[eighth] * length,
                           ahead[(eighth + 6) % 8] * length, eighth * 8192),
                0)
          << eighth << " eighths, " << length;
  EXPECT_EQ(other_than(number::ArcTangentFamily{}, 0, 0, 0), 0);
  EXPECT_EQ(other_than(number::ArcTangentFamily{}, least, least, 5 * 8192), 0);
}

}  // namespace
