// SPDX-License-Identifier: MIT
//
// What becomes of levels of coverage on surfaces.
#include <intaglio/raster/blend_coverage.hpp>
#include <intaglio/raster/dithered_coverage.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace intaglio;
using linear::Rect;
using linear::SubPoint;
using oracle::RecordingSink;
using raster::BlendCoverage;
using raster::DitheredCoverage;
using raster::DitherPattern;

template <class F>
class BlendCoverageOf : public testing::Test {};
using Formats =
    testing::Types<image::Indexed1, image::Indexed2, image::Indexed4, image::Indexed4Lsb, image::Indexed8>;
TYPED_TEST_SUITE(BlendCoverageOf, Formats);

TYPED_TEST(BlendCoverageOf, ReplacesEachIndexByTheTablesAndNothingElse) {
  using F = TypeParam;
  constexpr int entries = F::max_index + 1;
  oracle::Random random(41);
  for (int i = 0; i < 200; ++i) {
    const int steps = random.between(2, 40);
    const int index = random.between(0, entries - 1);
    // Any table will do: the sink doesn't know what it means.
    std::vector<std::uint8_t> bytes(image::BlendTable::bytes(entries, steps));
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.between(0, entries - 1));
    const auto table = image::BlendTable::over(bytes, entries, index, steps).value();
    std::vector<std::uint8_t> memory(19 * 5);
    for (auto& byte : memory) byte = static_cast<std::uint8_t>(random.bits());
    const auto surface = image::Surface<F>::over(memory, {17, 5}, 19).value();
    std::vector<unsigned> expected;
    for (int y = 0; y < 5; ++y)
      for (int x = 0; x < 17; ++x) expected.push_back(surface.get(x, y));
    const auto sink = BlendCoverage<F>::over(surface, table, {1, 1, 15, 3}).value();
    EXPECT_EQ(sink.clip(), (Rect{1, 1, 15, 3}));
    const int begin = random.between(1, 14);
    const int end = random.between(begin + 1, 16);
    const int level = random.between(1, 255);
    sink.span(2, begin, end, level);
    const int step = (2 * level * (steps - 1) + 255) / 510;
    for (int x = begin; x < end; ++x) {
      unsigned& pixel = expected[static_cast<std::size_t>(2 * 17 + x)];
      if (step == steps - 1)
        pixel = static_cast<unsigned>(index);
      else if (step > 0)
        pixel = bytes[static_cast<std::size_t>((step - 1) * entries) + pixel];
    }
    std::vector<unsigned> found;
    for (int y = 0; y < 5; ++y)
      for (int x = 0; x < 17; ++x) found.push_back(surface.get(x, y));
    ASSERT_EQ(found, expected) << random.seed_text() << " case " << i;
  }
}

TEST(BlendCoverage, ATableOfAnotherPaletteIsRefused) {
  std::vector<std::uint8_t> bytes(100);
  const image::Surface<image::Indexed4> surface;
  const auto small = image::BlendTable::over(bytes, 15, 1, 4).value();
  EXPECT_EQ(BlendCoverage<image::Indexed4>::over(surface, small).status(),
            (Status{Error::too_small, Argument::table, 16}));
  const auto large = image::BlendTable::over(bytes, 20, 16, 4).value();
  EXPECT_EQ(BlendCoverage<image::Indexed4>::over(surface, large).status(),
            (Status{Error::out_of_range, Argument::index}));
  EXPECT_EQ(BlendCoverage<image::Indexed4>::over(surface, {}).status(),
            (Status{Error::too_small, Argument::table, 16}));
  EXPECT_TRUE(BlendCoverage<image::Indexed4>().clip().empty());
}

/// The pixels that a pattern draws of one level.
std::vector<int> tile(int level, DitherPattern pattern, const Rect& area) {
  RecordingSink sink(area);
  DitheredCoverage<RecordingSink&> dithered(sink, pattern);
  for (int y = area.y; y < area.bottom(); ++y) dithered.span(y, area.x, area.right(), level);
  EXPECT_EQ(sink.violation(), "");
  EXPECT_LE(sink.most(), 1);
  return sink.all_writes();
}

TEST(DitheredCoverage, DrawsTheNearestNumberOfEachTileSpreadEvenly) {
  for (const DitherPattern pattern : {DitherPattern::normal, DitherPattern::reversed})
    for (int level = 1; level <= 255; ++level) {
      const auto drawn = tile(level, pattern, {-8, -8, 8, 8});
      int all = 0;
      std::array<int, 4> quarters{};
      for (int i = 0; i < 64; ++i) {
        all += drawn[static_cast<std::size_t>(i)];
        quarters[static_cast<std::size_t>(i / 32 * 2 + i % 8 / 4)] += drawn[static_cast<std::size_t>(i)];
      }
      EXPECT_EQ(all, (2 * 64 * level + 255) / 510) << level;
      const auto [least, most] = std::minmax_element(quarters.begin(), quarters.end());
      EXPECT_LE(*most - *least, 1) << level;
    }
}

TEST(DitheredCoverage, ReversedIsTheComplementOfTheRest) {
  for (int level = 1; level < 255; ++level) {
    const auto normal = tile(level, DitherPattern::normal, {0, 0, 8, 8});
    const auto reversed = tile(255 - level, DitherPattern::reversed, {0, 0, 8, 8});
    int wrong = 0;
    for (std::size_t i = 0; i < 64; ++i) wrong += normal[i] + reversed[i] != 1 ? 1 : 0;
    EXPECT_EQ(wrong, 0) << level;
  }
}

TEST(DitheredCoverage, TwoPolygonsThatShareAnEdgeLeaveNoHoleAndNoPixelTwice) {
  oracle::Random random(42);
  int wrong = 0;
  for (int i = 0; i < 300; ++i) {
    const int bound = 2048 << i % 17;
    // Every third cut is level or passes through pixel centres, where levels tie at 128.
    const int step = i % 3 == 0 ? 128 : 1;
    const SubPoint a{-bound, random.between(-bound, bound) / step * step};
    const SubPoint b{bound, i % 6 == 0 ? a.y : random.between(-bound, bound) / step * step};
    const std::array<SubPoint, 4> upper{a, {-bound, -bound}, {bound, -bound}, b};
    const std::array<SubPoint, 4> lower{b, {bound, bound}, {-bound, bound}, a};
    RecordingSink sink({-7, -7, 15, 15});
    std::vector<raster::CoverageCell> workspace(raster::coverage_cells(4, 15));
    EXPECT_TRUE(raster::fill_coverage(DitheredCoverage<RecordingSink&>(sink), raster::FillRule::non_zero,
                                      upper, workspace)
                    .ok());
    EXPECT_TRUE(raster::fill_coverage(DitheredCoverage<RecordingSink&>(sink, DitherPattern::reversed),
                                      raster::FillRule::non_zero, lower, workspace)
                    .ok());
    for (const int writes : sink.all_writes()) wrong += writes != 1 ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(DitheredCoverage, ThePatternStaysWithTheFrameInBandsAndUnderClips) {
  const Rect frame{-20, -20, 60, 50};
  const auto all = tile(100, DitherPattern::normal, frame);
  for (const Rect part : {Rect{-20, -13, 60, 5}, Rect{3, 7, 9, 11}, Rect{-1, -1, 1, 1}}) {
    const auto some = tile(100, DitherPattern::normal, part);
    std::vector<int> expected;
    for (int y = part.y; y < part.bottom(); ++y)
      for (int x = part.x; x < part.right(); ++x)
        expected.push_back(all[static_cast<std::size_t>((y - frame.y) * frame.width + x - frame.x)]);
    EXPECT_EQ(some, expected);
  }
}

TEST(DitheredCoverage, ExclusiveOrTwiceRestoresOneBitSurfaces) {
  std::vector<std::uint8_t> memory(4 * 20, 0x5A);
  const auto surface = image::Surface<image::Indexed1>::over(memory, {32, 20}).value();
  const std::array<SubPoint, 3> triangle{{{300, 200}, {7000, 1500}, {2000, 4600}}};
  std::vector<raster::CoverageCell> workspace(raster::coverage_cells(3, 32));
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(memory == std::vector<std::uint8_t>(4 * 20, 0x5A), i == 0);
    EXPECT_TRUE(raster::fill_coverage(DitheredCoverage(raster::Xor(surface, 1)), raster::FillRule::even_odd,
                                      triangle, workspace)
                    .ok());
  }
  EXPECT_EQ(memory, std::vector<std::uint8_t>(4 * 20, 0x5A));
}

}  // namespace
