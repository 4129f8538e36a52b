// SPDX-License-Identifier: MIT
//
// Inputs that broke other fixed-point libraries. Expectations are the exact values, written out.
#include <intaglio/number/fixed.hpp>
#include <intaglio/number/root.hpp>
#include <intaglio/number/sine.hpp>

#include <gtest/gtest.h>

#include <cstdlib>

namespace {

using intaglio::number::Angle;
using intaglio::number::cosine;
using intaglio::number::Fixed;
using intaglio::number::isqrt_nearest;
using intaglio::number::quarter_turn;
using F16 = Fixed<16>;
using F15 = Fixed<15>;

// libfixmath #27: the quotient is the most negative number of 16.16, and came out as 0.
TEST(HardArithmetic, LibfixmathIssue27QuotientThatIsTheMostNegativeNumber) {
  EXPECT_EQ(F16::from_ratio_nearest(65536, -2).raw(), -2147483647 - 1);
  EXPECT_EQ(divide_nearest(F16::min(), F16::from_int(1)), F16::min());
}

// libfixmath #12, #13, #14 (mitsuhiko's): signs and small quotients off by their last places.
TEST(HardArithmetic, LibfixmathIssues12To14SmallQuotients) {
  EXPECT_EQ(divide_nearest(F16::from_int(-1), F16::from_int(2)).raw(), -0x8000);
  EXPECT_EQ(divide_floor(F16::from_int(-1), F16::from_int(2)).raw(), -0x8000);
  EXPECT_EQ(divide_nearest(F16::from_int(1587), F16::from_int(2000)).raw(), 0xCB23);
  EXPECT_EQ(F16::from_ratio_nearest(1587, 2000).raw(), 0xCB23);
  EXPECT_EQ(divide_nearest(F16::from_int(-2), F16::from_int(-1)).raw(), 0x20000);
}

// libfixmath PR #54: rounding the ends of the range to integers.
TEST(HardArithmetic, LibfixmathPull54EndsOfTheRangeToInteger) {
  EXPECT_EQ(F16::min().nearest(), -32768);
  EXPECT_EQ(F16::max().nearest(), 32768);
}

// chmike/fpsqrt #3: roots of large 16.16 numbers. sqrt(25000) = 158.11388.., sqrt(20480) = 143.10835..
TEST(HardArithmetic, FpsqrtIssue3RootsOfLargeNumbers) {
  EXPECT_EQ(sqrt_nearest(F16::from_raw(0x61A80000)).raw(), 10362151);  // 158.11388.. * 65536 = 10362151.4
  EXPECT_EQ(sqrt_nearest(F16::from_raw(0x50000000)).raw(), 9378749);   // 143.10835.. * 65536 = 9378748.9
}

// SGDK #125: products that fit the format came out negative.
TEST(HardArithmetic, SgdkIssue125ProductsThatFit) {
  using F10 = Fixed<10>;
  for (const int n : {200, 50, 46})
    EXPECT_EQ(multiply_nearest(F10::from_int(n), F10::from_int(n)), F10::from_int(n * n)) << n;
  EXPECT_EQ(multiply_nearest(F16::from_int(200), F16::from_int(200)), F16::max());
  EXPECT_EQ(multiply_nearest(F16::from_int(-200), F16::from_int(200)), F16::min());
}

// xmos/lib_dsp #80: x / (x + 1 lsb) in 8.24 came out as 0. 2^24 * 2^25 / (2^25 + 1) = 16777215.50000001.
TEST(HardArithmetic, LibDspIssue80QuotientJustBelowOne) {
  const auto x = Fixed<24>::from_raw(0x02000000);
  const auto y = Fixed<24>::from_raw(0x02000001);
  EXPECT_EQ(divide_nearest(x, y).raw(), 0x01000000);
  EXPECT_EQ(divide_floor(x, y).raw(), 0x00FFFFFF);
}

// CMSIS_5 #267: the cosine of about -pi/2 had a spike. Next to the zero it may move by 2 pi / 65536 a step,
// that is 3.2 lsb, and no more.
TEST(HardArithmetic, CmsisIssue267CosineNextToMinusHalfPi) {
  EXPECT_EQ(cosine(-quarter_turn).raw(), 0);
  for (int steps = -64; steps <= 64; ++steps) {
    const Angle a = -quarter_turn + Angle::from_steps(steps);
    EXPECT_LE(std::abs(cosine(a + Angle::from_steps(1)).raw() - cosine(a).raw()), 4) << steps;
  }
}

// CMSIS_5 #339: the magnitude of (-745484, -160984), halved as its 2.30 result is, is 381333.9.
TEST(HardArithmetic, CmsisIssue339MagnitudeOfAVector) {
  constexpr std::int64_t re = -745484;
  constexpr std::int64_t im = -160984;
  EXPECT_EQ(isqrt_nearest(static_cast<std::uint64_t>(re * re + im * im) / 4), 381334U);
}

// CMSIS_5 #1386: sqrt_q15 fell from 32400 to 32393 between 32025 and 32026.
TEST(HardArithmetic, CmsisIssue1386RootsNeverFall) {
  for (std::int32_t raw = 0; raw < 32768; ++raw)
    ASSERT_LE(sqrt_nearest(F15::from_raw(raw)), sqrt_nearest(F15::from_raw(raw + 1))) << raw;
  EXPECT_EQ(sqrt_nearest(F15::from_raw(32025)).raw(), 32394);  // sqrt(32025 * 32768) = 32394.4
}

// CMSIS-DSP #164: the root of 0 was an error.
TEST(HardArithmetic, CmsisDspIssue164RootOfZero) { EXPECT_EQ(sqrt_nearest(Fixed<31>{}).raw(), 0); }

}  // namespace
