// SPDX-License-Identifier: MIT
#include <intaglio/image/scale_rungs.hpp>
#include <tests/oracle/bilinear.hpp>
#include <tests/oracle/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
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
using AllScaleRungs = testing::Types<ScaleNearest, ScaleBilinear4, ScaleBilinear8>;
TYPED_TEST_SUITE(ScaleRungs, AllScaleRungs);

TYPED_TEST(ScaleRungs, AreWithinTheBoundOfTheExactInterpolationWhereverShown) {
  oracle::Random random(901);
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const int w = random.between(1, 9);
    const int h = random.between(1, 9);
    const bool far = i % 8 == 0;
    const Rect to{random.between(far ? -9000 : -20, 10), random.between(far ? -9000 : -20, 10),
                  random.between(1, far ? 1 << 15 : 60), random.between(1, far ? 1 << 15 : 60)};
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

}  // namespace
