// SPDX-License-Identifier: MIT
#include <intaglio/image/ramp.hpp>
#include <tests/oracle/srgb.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::image::linear_of;
using intaglio::image::make_ramp;
using intaglio::image::mix;
using intaglio::image::mix_limit;
using intaglio::image::Palette;
using intaglio::image::Rgb;
using intaglio::image::set_ramp;
using intaglio::image::srgb_of;

constexpr std::uint8_t code(int value) { return static_cast<std::uint8_t>(value); }

TEST(Srgb, TheLightOfEveryCodeIsTheNearestTo65535thsAndRisesWithTheCode) {
  for (int c = 0; c < 256; ++c) {
    const long double exact = 65535.0L * oracle::srgb_decode(static_cast<long double>(c) / 255.0L);
    EXPECT_LE(std::abs(static_cast<long double>(linear_of(code(c))) - exact), 0.5L) << c;
    EXPECT_TRUE(c == 0 || linear_of(code(c)) > linear_of(code(c - 1))) << c;
  }
}

TEST(Srgb, EveryLightGivesTheCodeOfTheNearestLight) {
  int wrong = 0;
  for (int light = 0; light < 65536; ++light) {
    int nearest = 0;
    for (int c = 0; c < 256; ++c)
      if (std::abs(linear_of(code(c)) - light) <= std::abs(linear_of(code(nearest)) - light)) nearest = c;
    wrong += srgb_of(static_cast<std::uint16_t>(light)) != nearest;
  }
  EXPECT_EQ(wrong, 0);
}

/// The largest distance, in codes, of the ramp of `steps` steps between grey levels from the exact ramp.
long double worst_error(int from, int to, int steps, bool& monotone, bool& ends) {
  std::vector<Rgb> ramp(static_cast<std::size_t>(steps));
  EXPECT_TRUE(make_ramp(ramp, {code(from), 0, code(to)}, {code(to), 0, code(from)}).ok());
  const long double start = oracle::srgb_decode(static_cast<long double>(from) / 255.0L);
  const long double end = oracle::srgb_decode(static_cast<long double>(to) / 255.0L);
  long double worst = 0;
  for (int i = 0; i < steps; ++i) {
    const long double part =
        steps > 1 ? static_cast<long double>(i) / static_cast<long double>(steps - 1) : 0.0L;
    const long double exact = 255.0L * oracle::srgb_encode(start + (end - start) * part);
    const int got = ramp[static_cast<std::size_t>(i)].r;
    worst = std::max(worst, std::abs(static_cast<long double>(got) - exact));
    if (i > 0) {
      const int before = ramp[static_cast<std::size_t>(i - 1)].r;
      if (from <= to ? got < before : got > before) monotone = false;
    }
  }
  ends = ends && ramp.front() == Rgb{code(from), 0, code(to)} &&
         (steps == 1 || ramp.back() == Rgb{code(to), 0, code(from)});
  return worst;
}

TEST(Ramp, AllPairsOfLevelsStayWithinTheBoundAreMonotoneAndEndExactly) {
  long double worst = 0;
  bool monotone = true;
  bool ends = true;
  for (int from = 0; from < 256; ++from)
    for (int to = 0; to < 256; ++to) {
      for (const int steps : {1, 2, 3, 5, 16})
        worst = std::max(worst, worst_error(from, to, steps, monotone, ends));
      if ((from + to) % 17 == 0) worst = std::max(worst, worst_error(from, to, 256, monotone, ends));
    }
  EXPECT_LE(worst, 0.58L);
  EXPECT_GE(worst, 0.55L) << "the bound stated in ramp.hpp is loose";
  EXPECT_TRUE(monotone);
  EXPECT_TRUE(ends);
}

TEST(Ramp, HalfWayBetweenBlackAndWhiteIsHalfTheLight) {
  static_assert(mix({0, 0, 0}, {255, 255, 255}, 1, 2) == Rgb{188, 188, 188});
  EXPECT_NEAR(linear_of(188), 32768, 300);
}

TEST(Ramp, ChannelsDoNotMixWithEachOther) {
  for (int part = 0; part <= 10; ++part) {
    const Rgb all = mix({10, 200, 30}, {250, 0, 31}, part, 10);
    EXPECT_EQ(all.r, mix({10, 0, 0}, {250, 0, 0}, part, 10).r);
    EXPECT_EQ(all.g, mix({0, 200, 0}, {0, 0, 0}, part, 10).g);
    EXPECT_EQ(all.b, mix({0, 0, 30}, {0, 0, 31}, part, 10).b);
  }
}

TEST(Mix, PartsOutsideTheWayAreItsEnds) {
  constexpr int min = std::numeric_limits<int>::min();
  constexpr int max = std::numeric_limits<int>::max();
  constexpr Rgb from{1, 2, 3};
  constexpr Rgb to{101, 102, 103};
  for (const int whole : {min, -1, 0, 1, 7, max}) {
    EXPECT_EQ(mix(from, to, min, whole), from) << whole;
    EXPECT_EQ(mix(from, to, 0, whole), from) << whole;
    EXPECT_EQ(mix(from, to, max, whole), to) << whole;
  }
  EXPECT_EQ(mix({0, 0, 0}, {255, 0, 255}, mix_limit - 1, mix_limit), (Rgb{255, 0, 255}));
}

TEST(Ramp, BadStepCountsAreNamed) {
  EXPECT_EQ(make_ramp({}, {}, {}), (Status{Error::empty, Argument::steps}));
  std::vector<Rgb> steps(static_cast<std::size_t>(mix_limit));
  EXPECT_TRUE(make_ramp(steps, {}, {255, 255, 255}).ok());
  EXPECT_EQ(steps.back(), (Rgb{255, 255, 255}));
  steps.push_back({});
  EXPECT_EQ(make_ramp(steps, {}, {}), (Status{Error::too_large, Argument::steps, mix_limit}));
}

TEST(Ramp, InAPaletteChangesItsEntriesOnlyOrIsRefusedWhole) {
  Palette<16> palette;
  ASSERT_TRUE(set_ramp(palette, 3, 5, {10, 10, 10}, {20, 0, 255}).ok());
  std::vector<Rgb> ramp(5);
  ASSERT_TRUE(make_ramp(ramp, {10, 10, 10}, {20, 0, 255}).ok());
  for (int i = 0; i < 16; ++i)
    EXPECT_EQ(palette.get(i), i < 3 || i >= 8 ? Rgb{} : ramp[static_cast<std::size_t>(i - 3)]) << i;

  const Palette<16> before = palette;
  EXPECT_EQ(set_ramp(palette, -1, 2, {}, {}), (Status{Error::out_of_range, Argument::index}));
  EXPECT_EQ(set_ramp(palette, 16, 1, {}, {}), (Status{Error::out_of_range, Argument::index}));
  EXPECT_EQ(set_ramp(palette, 3, 0, {}, {}), (Status{Error::empty, Argument::steps}));
  EXPECT_EQ(set_ramp(palette, 3, 14, {}, {}), (Status{Error::too_large, Argument::steps, 13}));
  EXPECT_EQ(set_ramp(palette, 3, std::numeric_limits<int>::max(), {}, {}),
            (Status{Error::too_large, Argument::steps, 13}));
  EXPECT_EQ(palette, before);
}

}  // namespace
