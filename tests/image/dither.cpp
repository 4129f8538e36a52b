// SPDX-License-Identifier: MIT
#include <intaglio/image/dither.hpp>
#include <tests/oracle/dither.hpp>
#include <tests/oracle/random.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace {

using namespace intaglio::image;
using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using oracle::DitherPicture;

std::vector<std::uint8_t> bytes_of(const DitherPicture& values) {
  return {values.pixels.begin(), values.pixels.end()};
}

/// What a rung makes of the values, on a target of one byte a pixel as large.
template <class R>
DitherPicture dithered(const DitherPicture& values, int levels, const Rect& clip = everywhere) {
  const std::vector<std::uint8_t> source = bytes_of(values);
  std::vector<std::uint8_t> target(source.size(), 255);
  std::vector<std::int16_t> memory(static_cast<std::size_t>(R::memory(values.width)), 77);
  const Status status = blit_dithered<R>(
      Surface<Indexed8>::over(target, {values.width, values.height()}).value(), {0, 0},
      Picture<Indexed8>::over(source, {values.width, values.height()}).value(), levels, memory, clip);
  EXPECT_TRUE(status.ok());
  return {values.width, {target.begin(), target.end()}};
}

template <class R>
DitherPicture expected(const DitherPicture& values, int levels) {
  if constexpr (std::same_as<R, DitherNone>) return oracle::ordered(values, levels, 1);
  if constexpr (std::same_as<R, DitherOrdered2>) return oracle::ordered(values, levels, 2);
  if constexpr (std::same_as<R, DitherOrdered4>) return oracle::ordered(values, levels, 4);
  if constexpr (std::same_as<R, DitherOrdered8>) return oracle::ordered(values, levels, 8);
  if constexpr (std::same_as<R, DitherThreeTap>) return oracle::diffused(values, levels, {6, 0, 6, 4}, false);
  if constexpr (std::same_as<R, DitherFourTap>) return oracle::diffused(values, levels, {7, 3, 5, 1}, false);
  return oracle::diffused(values, levels, {7, 3, 5, 1}, true);
}

DitherPicture noise(oracle::Random& random, int width, int height) {
  DitherPicture values{width, std::vector<int>(static_cast<std::size_t>(width * height))};
  const int low = random.between(0, 255);
  const int high = random.between(low, 255);
  for (int& value : values.pixels) value = random.between(low, high);
  return values;
}

template <class R>
class Dither : public testing::Test {};
using AllDithers = testing::Types<DitherNone, DitherOrdered2, DitherOrdered4, DitherOrdered8, DitherThreeTap,
                                  DitherFourTap, DitherSerpentine>;
TYPED_TEST_SUITE(Dither, AllDithers);

TYPED_TEST(Dither, IsWhatTheRuleSays) {
  oracle::Random random(701);
  for (int i = 0; i < 300 && !testing::Test::HasFailure(); ++i) {
    const DitherPicture values = noise(random, random.between(1, 40), random.between(1, 12));
    for (const int levels : {2, 3, 4, 16, 255, 256})
      EXPECT_EQ(dithered<TypeParam>(values, levels).pixels, expected<TypeParam>(values, levels).pixels)
          << levels << ' ' << random.seed_text();
  }
}

TYPED_TEST(Dither, WithAllLevelsChangesNothing) {
  oracle::Random random(702);
  const DitherPicture values = noise(random, 31, 9);
  EXPECT_EQ(dithered<TypeParam>(values, 256).pixels, values.pixels);
}

TYPED_TEST(Dither, KeepsTheMeanOfAnyPictureWithinTheBound) {
  constexpr double bound = TypeParam::bound.thousandths / 1000.0;
  oracle::Random random(703);
  double worst = 0;
  for (int i = 0; i < 200; ++i) {
    const int levels = random.between(2, 16);
    const DitherPicture values = noise(random, 40, 40);
    worst = std::max(worst, oracle::worst_mean(values, dithered<TypeParam>(values, levels), levels - 1));
  }
  EXPECT_LE(worst, bound) << random.seed_text();
}

TYPED_TEST(Dither, ClippedIsTheWholeCut) {
  oracle::Random random(704);
  for (int i = 0; i < 100; ++i) {
    const DitherPicture values = noise(random, 33, 21);
    const Rect clip{random.between(-5, 33), random.between(-5, 21), random.between(0, 40),
                    random.between(0, 30)};
    DitherPicture whole = dithered<TypeParam>(values, 5);
    for (int y = 0; y < 21; ++y)
      for (int x = 0; x < 33; ++x)
        if (x < clip.x || y < clip.y || x >= clip.x + clip.width || y >= clip.y + clip.height)
          whole.pixels[whole.at(x, y)] = 255;
    EXPECT_EQ(dithered<TypeParam>(values, 5, clip).pixels, whole.pixels) << random.seed_text();
  }
}

TYPED_TEST(Dither, BadArgumentsAreNamedAndNothingIsDrawn) {
  constexpr int min = std::numeric_limits<int>::min();
  constexpr int max = std::numeric_limits<int>::max();
  std::vector<std::uint8_t> bytes(64, 3);
  std::vector<std::uint8_t> values(64, 200);
  std::vector<std::int16_t> memory(static_cast<std::size_t>(TypeParam::memory(8)));
  const auto target = Surface<Indexed4>::over(bytes, {8, 8}).value();
  const auto source = Picture<Indexed8>::over(values, {8, 8}).value();
  const auto answer = [&](Point position, int levels, std::span<std::int16_t> owed,
                          const Rect& clip = everywhere) {
    return blit_dithered<TypeParam>(target, position, source, levels, owed, clip);
  };
  for (const int far : {min, max}) {
    EXPECT_EQ(answer({far, 0}, 2, memory), (Status{Error::out_of_domain, Argument::position}));
    EXPECT_EQ(answer({0, far}, 2, memory), (Status{Error::out_of_domain, Argument::position}));
    EXPECT_EQ(answer({0, 0}, 2, memory, {far, 0, 1, 1}), (Status{Error::out_of_domain, Argument::rectangle}));
    EXPECT_EQ(answer({0, 0}, far, memory), (Status{Error::out_of_range, Argument::steps, 16}));
  }
  EXPECT_EQ(answer({0, 0}, 1, memory), (Status{Error::out_of_range, Argument::steps, 16}));
  EXPECT_EQ(answer({0, 0}, 17, memory), (Status{Error::out_of_range, Argument::steps, 16}));
  if (!memory.empty()) {
    EXPECT_EQ(answer({0, 0}, 2, std::span(memory).first(9)),
              (Status{Error::too_small, Argument::workspace, 10}));
  }
  EXPECT_EQ(bytes, std::vector<std::uint8_t>(64, 3));
  EXPECT_TRUE(answer({1 << 20, -(1 << 20)}, 2, memory).ok());
  const auto itself = Surface<Indexed8>::over(values, {8, 8}).value();
  EXPECT_EQ(blit_dithered<TypeParam>(itself, {0, 0}, source, 2, memory),
            (Status{Error::mismatched, Argument::source}));
}

TEST(DitherOrdered, KeepsTheMeanOfEvenFieldsAsCloselyAsTheMatrixCan) {
  const auto worst = [](auto rung) {
    double most = 0;
    for (int value = 0; value < 256; ++value)
      for (int levels = 2; levels < 20; ++levels) {
        const DitherPicture values{8, std::vector<int>(64, value)};
        most =
            std::max(most, oracle::worst_mean(values, dithered<decltype(rung)>(values, levels), levels - 1));
      }
    return most;
  };
  EXPECT_LE(worst(DitherOrdered2{}), 1.0 / 8);
  EXPECT_LE(worst(DitherOrdered4{}), 1.0 / 32);
  EXPECT_LE(worst(DitherOrdered8{}), 1.0 / 128);
}

TEST(DitherDiffused, PicturesPlacedAnywhereLookTheSame) {
  oracle::Random random(705);
  const DitherPicture values = noise(random, 13, 11);
  const DitherPicture whole = dithered<DitherSerpentine>(values, 2);
  const std::vector<std::uint8_t> source = bytes_of(values);
  std::vector<std::uint8_t> target(20);
  std::vector<std::int16_t> memory(15);
  const auto surface = Surface<Indexed1>::over(target, {10, 10}).value();
  ASSERT_TRUE(blit_dithered<DitherSerpentine>(surface, {-3, -4},
                                              Picture<Indexed8>::over(source, {13, 11}).value(), 2, memory)
                  .ok());
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 10; ++x)
      EXPECT_EQ(static_cast<int>(surface.get(x, y)), whole.pixels[whole.at(x + 3, y + 4)]) << x << ' ' << y;
}

}  // namespace
