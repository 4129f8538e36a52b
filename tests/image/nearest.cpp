// SPDX-License-Identifier: MIT
#include <intaglio/image/nearest.hpp>
#include <intaglio/image/nearest_rungs.hpp>
#include <tests/oracle/lab.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/samples.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace {

using namespace intaglio::image;
using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;

Rgb random_colour(oracle::Random& random) {
  const auto channel = [&] { return static_cast<std::uint8_t>(random.between(0, 255)); };
  return {channel(), channel(), channel()};
}

std::vector<std::uint8_t> random_palette(oracle::Random& random, int entries) {
  std::vector<std::uint8_t> palette(static_cast<std::size_t>(entries) * 3);
  for (auto& byte : palette) byte = static_cast<std::uint8_t>(random.bits());
  return palette;
}

TEST(NearestLab, PlacesAreOffByAtMostAQuarterOfTheBoundForAllColours) {
  double worst = 0;
  for (int i = 0; i < 1 << 24; i += oracle::samples(211, 1)) {
    const Rgb colour{static_cast<std::uint8_t>(i >> 16), static_cast<std::uint8_t>(i >> 8),
                     static_cast<std::uint8_t>(i)};
    const ColourPlace place = NearestLab::place(colour);
    const oracle::Lab exact = oracle::lab(colour.r, colour.g, colour.b);
    worst =
        std::max(worst, oracle::squared_distance({place.x / 64.0, place.y / 64.0, place.z / 64.0}, exact));
  }
  EXPECT_LE(std::sqrt(worst), NearestLab::bound.thousandths / 4000.0);
  EXPECT_GE(std::sqrt(worst), NearestLab::bound.thousandths / 8000.0);
}

TEST(NearestLab, ChoosesAnEntryThatIsHardlyFurtherThanTheBestOfAnyPalette) {
  oracle::Random random(801);
  double worst = 0;
  for (int i = 0; i < oracle::samples(300, 30'000); ++i) {
    const int entries = random.between(1, 64);
    const auto palette = random_palette(random, entries);
    std::array<ColourPlace, 64> places;
    ASSERT_TRUE(make_places<NearestLab>(places, palette).ok());
    const Rgb colour = random_colour(random);
    const oracle::Lab exact = oracle::lab(colour.r, colour.g, colour.b);
    const auto away = [&](std::size_t entry) {
      return std::sqrt(oracle::squared_distance(
          oracle::lab(palette[3 * entry], palette[3 * entry + 1], palette[3 * entry + 2]), exact));
    };
    double best = away(0);
    for (std::size_t entry = 1; entry < static_cast<std::size_t>(entries); ++entry)
      best = std::min(best, away(entry));
    const std::span<const ColourPlace> used(places.data(), static_cast<std::size_t>(entries));
    worst = std::max(worst, away(NearestLab{}(used, colour)) - best);
  }
  EXPECT_LE(worst, NearestLab::bound.thousandths / 1000.0) << random.seed_text();
}

// By how much an entry is further from a colour than another one, in L*a*b* of real numbers.
double loss(Rgb colour, Rgb chosen, Rgb other) {
  const auto distance = [&](Rgb entry) {
    return std::sqrt(oracle::squared_distance(oracle::lab(entry.r, entry.g, entry.b),
                                              oracle::lab(colour.r, colour.g, colour.b)));
  };
  return distance(chosen) - distance(other);
}

template <class R>
double loss_of(Rgb colour, Rgb first, Rgb second) {
  const std::array<ColourPlace, 2> places{R::place(first), R::place(second)};
  return R{}(places, colour) == 0 ? loss(colour, first, second) : loss(colour, second, first);
}

TEST(NearestEntries, LoseAsMuchInBadPalettesAsTheirBoundsSay) {
  // No two colours are further apart than green and blue.
  EXPECT_NEAR(loss({0, 0, 255}, {0, 255, 0}, {0, 0, 255}), NearestRgb::bound.thousandths / 1000.0, 1e-3);
  const auto is_near = [](double loss, intaglio::number::Bound bound, double least) {
    EXPECT_LE(loss, bound.thousandths / 1000.0);
    EXPECT_GE(loss, least);
  };
  is_near(loss_of<NearestRgb>({0, 49, 255}, {0, 255, 97}, {255, 0, 255}), NearestRgb::bound, 166);
  is_near(loss_of<NearestWeighted>({0, 141, 17}, {0, 19, 255}, {220, 255, 181}), NearestWeighted::bound, 146);
  is_near(loss_of<NearestLuv>({0, 0, 166}, {2, 199, 0}, {255, 0, 104}), NearestLuv::bound, 96);
}

TEST(NearestLuv, PlacesAreWithinTwoUnitsOfRealNumbersForAllColours) {
  double worst = 0;
  for (int i = 0; i < 1 << 24; i += oracle::samples(211, 5)) {
    const Rgb colour{static_cast<std::uint8_t>(i >> 16), static_cast<std::uint8_t>(i >> 8),
                     static_cast<std::uint8_t>(i)};
    const ColourPlace place = NearestLuv::place(colour);
    const oracle::Lab exact = oracle::luv(colour.r, colour.g, colour.b);
    worst =
        std::max(worst, oracle::squared_distance({place.x / 64.0, place.y / 64.0, place.z / 64.0}, exact));
  }
  EXPECT_LE(std::sqrt(worst), 2);
}

TEST(NearestRgb, IsTheEntryOfThePalettesBytes) {
  oracle::Random random(802);
  for (int i = 0; i < 500; ++i) {
    const int entries = random.between(1, 256);
    const auto palette = random_palette(random, entries);
    std::array<ColourPlace, 256> places;
    ASSERT_TRUE(make_places<NearestRgb>(places, palette).ok());
    const Rgb colour = random_colour(random);
    const std::span<const ColourPlace> used(places.data(), static_cast<std::size_t>(entries));
    EXPECT_EQ(NearestRgb{}(used, colour), nearest_entry(palette, colour)) << random.seed_text();
  }
}

template <class R>
class NearestRungs : public testing::Test {};
using AllNearestRungs = testing::Types<NearestRgb, NearestWeighted, NearestLuv, NearestLab>;
TYPED_TEST_SUITE(NearestRungs, AllNearestRungs);

TYPED_TEST(NearestRungs, FindsWhatIsInThePaletteAndTheFirstOfEquals) {
  constexpr std::array<std::uint8_t, 18> palette{0, 0, 0,   255, 0,   0,   0,   255, 0,
                                                 0, 0, 255, 255, 255, 255, 255, 0,   0};
  std::array<ColourPlace, 6> places;
  ASSERT_TRUE(make_places<TypeParam>(places, palette).ok());
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(TypeParam{}(places, {palette[3 * i], palette[3 * i + 1], palette[3 * i + 2]}), i);
  EXPECT_EQ(TypeParam{}({}, {1, 2, 3}), 0);
}

TYPED_TEST(NearestRungs, GreysHaveNoTint) {
  for (int i = 0; i < 256; ++i) {
    const auto code = static_cast<std::uint8_t>(i);
    const ColourPlace place = TypeParam::place({code, code, code});
    if constexpr (std::same_as<TypeParam, NearestLab>) {
      EXPECT_EQ(place.y, 0) << i;
      EXPECT_EQ(place.z, 0) << i;
    }
    EXPECT_TRUE(i == 0 || place.x > TypeParam::place({static_cast<std::uint8_t>(i - 1),
                                                      static_cast<std::uint8_t>(i - 1),
                                                      static_cast<std::uint8_t>(i - 1)})
                                        .x)
        << i;
  }
}

TYPED_TEST(NearestRungs, BadPalettesAreRefused) {
  const std::vector<std::uint8_t> bytes(771);
  std::array<ColourPlace, 2> places;
  for (const std::size_t size : {std::size_t{0}, std::size_t{4}, std::size_t{771}})
    EXPECT_EQ(make_places<TypeParam>(places, std::span(bytes).first(size)),
              (Status{Error::malformed, Argument::palette}));
  EXPECT_EQ(make_places<TypeParam>(places, std::span(bytes).first(9)),
            (Status{Error::too_small, Argument::table, 3}));
}

}  // namespace
