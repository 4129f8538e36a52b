// SPDX-License-Identifier: MIT
#include <intaglio/image/scale_rungs.hpp>
#include <tests/oracle/bilinear.hpp>
#include <tests/oracle/box.hpp>
#include <tests/oracle/integer.hpp>
#include <tests/oracle/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace intaglio::image;
using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Rect;

constexpr int side = 24;

std::vector<std::uint8_t> values_of(oracle::Random& random, int w, int h) {
  std::vector<std::uint8_t> values(static_cast<std::size_t>(w * h));
  for (auto& value : values) value = random.between(0, 1) == 0 ? 0 : 255;
  return values;
}

template <class R>
class ScaleRungs : public testing::Test {};
using AllScaleRungs = testing::Types<ScaleNearest, ScaleBilinear4, ScaleBilinear8, ScaleBox>;
TYPED_TEST_SUITE(ScaleRungs, AllScaleRungs);

TYPED_TEST(ScaleRungs, AreWithinTheBoundOfTheExactInterpolationWhereverShown) {
  oracle::Random random(901);
  double worst = 0;
  constexpr bool only_grows = std::is_same_v<TypeParam, ScaleBox>;
  for (int i = 0; i < 2000; ++i) {
    const int w = random.between(1, 9);
    const int h = random.between(1, 9);
    const bool far = i % 8 == 0;
    const Rect to{random.between(far ? -9000 : -20, 10), random.between(far ? -9000 : -20, 10),
                  random.between(only_grows ? w : 1, far ? 1 << 15 : 60),
                  random.between(only_grows ? h : 1, far ? 1 << 15 : 60)};
    const auto source = values_of(random, w, h);
    std::vector<std::uint8_t> target(side * side, 77);
    const auto surface = Surface<Indexed8>::over(target, {side, side}).value();
    const Rect clip{random.between(-3, 9), random.between(-3, 9), random.between(0, 30),
                    random.between(0, 30)};
    ASSERT_TRUE(TypeParam{}(surface, to, Picture<Indexed8>::over(source, {w, h}).value(), clip).ok());
    const auto value = [&](int column, int row) {
      return static_cast<double>(source[static_cast<std::size_t>(row * w + column)]);
    };
    int touched = 0;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const auto in = [&](const Rect& r) {
          return x >= r.x && y >= r.y && x < r.x + r.width && y < r.y + r.height;
        };
        if (!in(to) || !in(clip)) {
          touched += surface.get(x, y) == 77 ? 0 : 1;
          continue;
        }
        const double exact = oracle::bilinear(x - to.x, y - to.y, w, h, to.width, to.height, value);
        worst = std::max(worst, std::abs(surface.get(x, y) - exact));
      }
    ASSERT_EQ(touched, 0) << random.seed_text();
  }
  const double bound = TypeParam::bound.thousandths / 1000.0;
  EXPECT_LE(worst, bound) << random.seed_text();
  EXPECT_GE(worst, bound / 2);
}

TYPED_TEST(ScaleRungs, AreWithinTheBoundOfTheMeanWhenTheyShrink) {
  oracle::Random random(903);
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    const int w = random.between(side, 170);
    const int h = random.between(side, 170);
    const auto source = values_of(random, w, h);
    std::vector<std::uint8_t> target(side * side);
    const auto surface = Surface<Indexed8>::over(target, {side, side}).value();
    const Rect to{0, 0, random.between(1, side), random.between(1, side)};
    ASSERT_TRUE(TypeParam{}(surface, to, Picture<Indexed8>::over(source, {w, h}).value()).ok());
    const auto value = [&](int column, int row) {
      return source[static_cast<std::size_t>(row * w + column)];
    };
    for (int y = 0; y < to.height; ++y)
      for (int x = 0; x < to.width; ++x) {
        const auto sum = oracle::box_sum(x, y, w, h, to.width, to.height, value);
        worst = std::max(worst, std::abs(surface.get(x, y) - static_cast<double>(sum) / (w * h)));
      }
  }
  const double bound = TypeParam::shrinking_bound.thousandths / 1000.0;
  EXPECT_LE(worst, bound) << random.seed_text();
  EXPECT_GE(worst, bound / 2);
}

TYPED_TEST(ScaleRungs, ToItsOwnSizeChangesNothingAndBandsAreThePicture) {
  oracle::Random random(902);
  std::vector<std::uint8_t> source(side * side);
  for (auto& value : source) value = static_cast<std::uint8_t>(random.bits());
  const auto picture = Picture<Indexed8>::over(source, {side, side}).value();
  std::vector<std::uint8_t> target(side * side);
  ASSERT_TRUE(
      TypeParam{}(Surface<Indexed8>::over(target, {side, side}).value(), {0, 0, side, side}, picture).ok());
  EXPECT_EQ(target, source);
  const Rect to{-7, -3, 41, 37};
  ASSERT_TRUE(TypeParam{}(Surface<Indexed8>::over(target, {side, side}).value(), to, picture).ok());
  std::vector<std::uint8_t> bands;
  for (int y = 0; y < side; y += 5) {
    const int rows = std::min(5, side - y);
    std::vector<std::uint8_t> band(static_cast<std::size_t>(side * rows));
    ASSERT_TRUE(
        TypeParam{}(Surface<Indexed8>::over_band(band, {0, y, side, rows}).value(), to, picture).ok());
    bands.insert(bands.end(), band.begin(), band.end());
  }
  EXPECT_EQ(bands, target);
}

TYPED_TEST(ScaleRungs, BadArgumentsAreNamed) {
  constexpr int min = std::numeric_limits<int>::min();
  constexpr int max = std::numeric_limits<int>::max();
  std::vector<std::uint8_t> source(16, 5);
  std::vector<std::uint8_t> target(64, 9);
  const auto picture = Picture<Indexed8>::over(source, {4, 4}).value();
  const auto surface = Surface<Indexed8>::over(target, {8, 8}).value();
  for (const int far : {min, max}) {
    EXPECT_EQ(TypeParam{}(surface, {far, 0, 4, 4}, picture),
              (Status{Error::out_of_domain, Argument::position}));
    EXPECT_EQ(TypeParam{}(surface, {0, 0, 4, 4}, picture, {0, far, 4, 4}),
              (Status{Error::out_of_domain, Argument::rectangle}));
  }
  EXPECT_EQ(TypeParam{}(surface, {0, 0, max, 4}, picture), (Status{Error::out_of_domain, Argument::size}));
  EXPECT_EQ(TypeParam{}(surface, {0, 0, 4, 4}, Picture<Indexed8>(surface)),
            (Status{Error::mismatched, Argument::source}));
  EXPECT_TRUE(TypeParam{}(surface, {0, 0, 0, 4}, picture).ok());
  EXPECT_EQ(target, std::vector<std::uint8_t>(64, 9));
}

/// Pixels of a stretched picture that aren't the exact mean, rounded with halves up.
int wrong_means(const std::vector<std::uint8_t>& source, int w, int h, const Rect& to) {
  std::vector<std::uint8_t> target(side * side, 77);
  const auto surface = Surface<Indexed8>::over(target, {side, side}).value();
  EXPECT_TRUE(ScaleBox{}(surface, to, Picture<Indexed8>::over(source, {w, h}).value()).ok());
  int wrong = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      oracle::Wide expected = 77;
      if (x >= to.x && y >= to.y && x < to.x + to.width && y < to.y + to.height) {
        const auto sum = oracle::box_sum(
            x - to.x, y - to.y, w, h, to.width, to.height,
            [&](int column, int row) { return source[static_cast<std::size_t>(row * w + column)]; });
        expected = oracle::nearest_quotient(sum, oracle::Wide{w} * h);
      }
      wrong += surface.get(x, y) == expected ? 0 : 1;
    }
  return wrong;
}

TEST(ScaleBoxRung, IsTheExactMeanRoundedOnceWhetherItShrinksOrEnlarges) {
  oracle::Random random(904);
  for (int i = 0; i < 4000; ++i) {
    const bool wide = i % 4 == 0;
    const int w = random.between(1, wide ? 90 : 12);
    const int h = random.between(1, wide ? 90 : 12);
    const bool far = i % 8 == 1;
    const Rect to{random.between(far ? -9000 : -20, 10), random.between(far ? -9000 : -20, 10),
                  random.between(1, far ? 1 << 15 : 60), random.between(1, far ? 1 << 15 : 60)};
    std::vector<std::uint8_t> source = values_of(random, w, h);
    if (i % 2 == 0)
      for (auto& value : source) value = static_cast<std::uint8_t>(random.bits());
    ASSERT_EQ(wrong_means(source, w, h, to), 0) << w << 'x' << h << ' ' << to.width << 'x' << to.height;
  }
}

TEST(ScaleBoxRung, SumsOfTheLargestPicturesFit) {
  oracle::Random random(905);
  for (const auto& [w, h] : {std::pair{1 << 15, 512}, {4096, 4096}, {512, 1 << 15}}) {
    const auto pixels = static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
    for (const int odd : {0, 1}) {
      std::vector<std::uint8_t> source(pixels, 255);
      if (odd != 0)
        for (std::size_t i = 0; i < pixels; i += 3) source[i] = static_cast<std::uint8_t>(random.bits());
      EXPECT_EQ(wrong_means(source, w, h, {0, 0, 1, 1}), 0);
      EXPECT_EQ(wrong_means(source, w, h, {-3, -2, 7, 11}), 0);
    }
  }
  std::vector<std::uint8_t> source((1U << 24U) + 4096);
  std::vector<std::uint8_t> target(64, 9);
  const auto surface = Surface<Indexed8>::over(target, {8, 8}).value();
  EXPECT_EQ(ScaleBox{}(surface, {0, 0, 8, 8}, Picture<Indexed8>::over(source, {4096, 4097}).value()),
            (Status{Error::too_large, Argument::source, box_pixels_limit}));
  EXPECT_EQ(target, std::vector<std::uint8_t>(64, 9));
}

TEST(ScaleBoxRung, MeansRoundRightForEveryCount) {
  oracle::Random random(906);
  int wrong = 0;
  for (int i = 0; i < 300'000; ++i) {
    const int bits = random.between(0, 24);
    const int count = i < 5000 ? i + 1 : random.between(1 << bits >> 1, 1 << bits);
    if (count == 0) continue;
    const intaglio::image::detail::MeanOf mean(static_cast<std::uint32_t>(count));
    // Where the mean changes, and beside.
    const auto step = oracle::Wide{random.between(0, 255)} * 2 + 1;
    for (oracle::Wide sum = step * count / 2 - 1; sum <= step * count / 2 + 1; ++sum) {
      const oracle::Wide within = std::clamp<oracle::Wide>(sum, 0, oracle::Wide{255} * count);
      wrong += mean(static_cast<std::uint32_t>(within)) == oracle::nearest_quotient(within, count) ? 0 : 1;
    }
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

}  // namespace
