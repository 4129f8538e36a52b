// SPDX-License-Identifier: MIT
#include <intaglio/number/sine_rungs.hpp>
#include <tests/oracle/sine.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <type_traits>

namespace {

using intaglio::number::Angle;
using intaglio::number::cosine;
using intaglio::number::Family;
using intaglio::number::quarter_turn;
using intaglio::number::sine;
using intaglio::number::SineFamily;
using intaglio::number::Unit;

template <class F>
struct AsTestTypes;
template <class... Rungs>
struct AsTestTypes<Family<Rungs...>> {
  using Type = testing::Types<Rungs...>;
};

/// The largest error of a rung over all angles, in 2^-62.
template <class Rung>
std::int64_t worst_error(int& worst_steps) {
  std::int64_t worst = 0;
  for (int steps = 0; steps < Angle::turn; ++steps) {
    const std::int64_t value =
        std::int64_t{Rung{}(Angle::from_steps(steps)).raw()} * (std::int64_t{1} << 47U);
    const std::int64_t error = std::abs(value - oracle::sine_q62(steps));
    if (error > worst) {
      worst = error;
      worst_steps = steps;
    }
  }
  return worst;
}

template <class Rung>
class SineRung : public testing::Test {};
TYPED_TEST_SUITE(SineRung, AsTestTypes<SineFamily>::Type);

TYPED_TEST(SineRung, StaysWithinItsBoundForEveryAngleAndUsesNearlyAllOfIt) {
  static_assert(TypeParam::bound.unit == Unit::lsb_q15);
  int worst_steps = 0;
  const std::int64_t worst = worst_error<TypeParam>(worst_steps);
  const std::int64_t bound = (std::int64_t{1} << 47U) / 1000 * TypeParam::bound.thousandths;
  EXPECT_LE(worst + oracle::sine_q62_error, bound) << "worst at " << worst_steps << " steps";
  EXPECT_GE(worst, bound - bound / 50) << "the stated bound is loose";
}

TYPED_TEST(SineRung, IsOddAndItsCosineIsEvenAndAQuarterTurnOn) {
  int wrong = 0;
  for (int steps = 0; steps < Angle::turn; ++steps) {
    const Angle a = Angle::from_steps(steps);
    wrong += sine<TypeParam>(-a).raw() != -sine<TypeParam>(a).raw();
    wrong += cosine<TypeParam>(-a) != cosine<TypeParam>(a);
    wrong += cosine<TypeParam>(a) != sine<TypeParam>(a + quarter_turn);
    wrong += sine<TypeParam>(a) != sine<TypeParam>(quarter_turn + quarter_turn - a);
  }
  EXPECT_EQ(wrong, 0);
}

TYPED_TEST(SineRung, IsExactAtQuartersAndNeverLeavesMinusOneToOne) {
  for (int quarter = 0; quarter < 4; ++quarter)
    EXPECT_EQ(sine<TypeParam>(quarter_turn * quarter).raw(), quarter % 2 == 0 ? 0
                                                             : quarter == 1   ? 32768
                                                                              : -32768);
  int wrong = 0;
  for (int steps = 0; steps < Angle::turn; ++steps)
    wrong += std::abs(sine<TypeParam>(Angle::from_steps(steps)).raw()) > 32768;
  EXPECT_EQ(wrong, 0);
}

TYPED_TEST(SineRung, RisesThroughoutTheFirstQuarter) {
  // The roundings of polynomials take one lsb back where the sine hardly rises.
  constexpr int fall = std::is_same_v<TypeParam, intaglio::number::SinePolynomial5> ||
                               std::is_same_v<TypeParam, intaglio::number::SinePolynomial7>
                           ? 1
                           : 0;
  int falls = 0;
  for (int steps = 0; steps < 16384; ++steps)
    falls += sine<TypeParam>(Angle::from_steps(steps + 1)).raw() + fall <
             sine<TypeParam>(Angle::from_steps(steps)).raw();
  EXPECT_EQ(falls, 0);
}

TEST(SineTable, EverySampleIsTheNearest) {
  for (int i = 0; i <= 256; ++i) {
    const std::int64_t sample = intaglio::number::detail::quarter_sine[static_cast<std::size_t>(i)];
    const std::int64_t error = std::abs(sample * (std::int64_t{1} << 47U) - oracle::sine_q62(i * 64));
    ASSERT_LE(error + oracle::sine_q62_error, std::int64_t{1} << 46U) << i;
  }
}

TEST(SineOracle, AgreesWithTheMathLibrary) {
  const long double turn = 8.0L * std::atan(1.0L);
  for (int steps = 0; steps < Angle::turn; steps += 7) {
    const long double expected = std::ldexp(std::sin(turn * static_cast<long double>(steps) / 65536.0L), 62);
    ASSERT_NEAR(static_cast<double>(static_cast<long double>(oracle::sine_q62(steps)) - expected), 0.0, 64.0)
        << steps;
  }
}

}  // namespace
