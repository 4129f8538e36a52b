// SPDX-License-Identifier: MIT
#include <intaglio/image/mix_rungs.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/oracle/srgb.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace {

using namespace intaglio::image;

/// The exact mixture, as a code with its fraction.
long double exact_mixture(int from, int to, int part, int whole) {
  const auto light = [](int code) { return oracle::srgb_decode(static_cast<long double>(code) / 255); };
  return 255 * oracle::srgb_encode((light(from) * (whole - part) + light(to) * part) / whole);
}

template <class R>
class MixRungs : public testing::Test {};
using AllMixRungs = testing::Types<MixCodes, MixSquares, MixTable16, MixTable32>;
TYPED_TEST_SUITE(MixRungs, AllMixRungs);

constexpr std::uint8_t code(int value) { return static_cast<std::uint8_t>(value); }

TYPED_TEST(MixRungs, StayWithinTheirBoundWhichIsTight) {
  constexpr TypeParam rung{};
  long double worst = 0;
  const auto look = [&](int from, int to, int part, int whole) {
    const auto got = static_cast<long double>(rung(code(from), code(to), part, whole));
    worst = std::max(worst, std::abs(got - exact_mixture(from, to, part, whole)));
  };
  for (int part = 0; part <= 1000; ++part) {
    look(0, 255, part, 1000);
    look(255, 10, part, 1000);
    look(0, 12, part, 1000);
  }
  oracle::Random random(41);
  for (int i = oracle::samples(20'000, 2'000'000); i > 0; --i) {
    const int whole = random.between(1, mix_limit);
    look(random.between(0, 255), random.between(0, 255), random.between(0, whole), whole);
  }
  const long double bound = static_cast<long double>(TypeParam::bound.thousandths) / 1000;
  EXPECT_LE(worst, bound) << random.seed_text();
  EXPECT_GE(worst, bound * 0.9L);
}

TYPED_TEST(MixRungs, EndExactlyAndAreMonotone) {
  constexpr TypeParam rung{};
  for (int from = 0; from < 256; from += 5)
    for (int to = from; to < 256; to += 7) {
      int before = from;
      bool good = rung(code(from), code(to), 0, 77) == from && rung(code(from), code(to), 77, 77) == to;
      for (int part = 0; part <= 77; ++part) {
        const int here = rung(code(from), code(to), part, 77);
        good = good && here >= before;
        before = here;
      }
      EXPECT_TRUE(good) << from << ' ' << to;
    }
}

TEST(MixRungs, TheFinestOneIsTheNearestCodeWhereverThatIsClear) {
  // Clear: not within 1e-4 code of half-way, which is ten times what the lights are off by.
  int wrong = 0;
  for (int from = 0; from < 256; from += 3)
    for (int to = 0; to < 256; to += 4)
      for (int part = 0; part <= 15; ++part) {
        const long double exact = exact_mixture(from, to, part, 15);
        if (std::abs(exact - std::floor(exact) - 0.5L) < 1e-4L) continue;
        wrong += MixTable32{}(code(from), code(to), part, 15) != std::lround(exact) ? 1 : 0;
      }
  EXPECT_EQ(wrong, 0);
}

TEST(MixRungs, PartsOutsideTheWayAreItsEnds) {
  constexpr int min = std::numeric_limits<int>::min();
  constexpr int max = std::numeric_limits<int>::max();
  constexpr Rgb from{1, 2, 3};
  constexpr Rgb to{101, 102, 103};
  for (const int whole : {min, -1, 0, 1, 7, max}) {
    EXPECT_EQ(mix_by<MixCodes>(from, to, min, whole), from) << whole;
    EXPECT_EQ(mix_by<MixTable32>(from, to, max, whole), to) << whole;
    EXPECT_EQ(mix_by<MixTable16>(from, to, 1, whole), mix(from, to, 1, whole)) << whole;
  }
}

}  // namespace
