// SPDX-License-Identifier: MIT
#include <intaglio/image/surface.hpp>
#include <intaglio/raster/coverage.hpp>
#include <tests/oracle/coverage.hpp>
#include <tests/oracle/level_sink.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/raster/contours.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <gmpxx.h>
#include <string>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Rect;
using intaglio::linear::SubPoint;
using intaglio::raster::coverage_cells;
using intaglio::raster::coverage_workspace;
using intaglio::raster::CoverageCell;
using intaglio::raster::fill_coverage;
using intaglio::raster::FillRule;
using intaglio::raster::RampCoverage;
using oracle::Contour;
using oracle::Contours;
using oracle::LevelSink;
using oracle::Random;
using tests::random_contour;
using tests::text;

constexpr int limit = 1 << 28;

/// The levels in this window; the workspace is exactly as large as the library says it must be.
LevelSink covered(const Contours& contours, FillRule rule, const Rect& clip) {
  const auto [vertices, lengths] = tests::flat(contours);
  const auto needed = coverage_workspace(vertices, lengths, clip);
  EXPECT_TRUE(needed.ok());
  std::vector<CoverageCell> workspace(needed.value());
  LevelSink sink(clip);
  EXPECT_TRUE(fill_coverage(sink, rule, vertices, lengths, workspace).ok()) << text(contours);
  return sink;
}

/// What is wrong with the levels of the polygon in this window, by either rule; empty if nothing is.
std::string fault(const Contours& contours, const Rect& clip) {
  long edges = 0;
  for (const auto& contour : contours) edges += static_cast<long>(contour.size());
  const mpq_class bound = mpq_class(1, 2) + mpq_class(1, 1 << 22) + mpq_class(edges, 1 << 20);
  for (const bool even_odd : {true, false}) {
    const LevelSink sink = covered(contours, even_odd ? FillRule::even_odd : FillRule::non_zero, clip);
    if (sink.bad()) return text(contours) + ": contract broken";
    for (int y = clip.y; y < clip.bottom(); ++y)
      for (int x = clip.x; x < clip.right(); ++x) {
        const mpq_class exact = 255 * oracle::coverage(contours, even_odd, x, y);
        if (abs(exact - sink.level(x, y)) > bound)
          return text(contours) + (even_odd ? " even-odd" : " non-zero") + ": pixel " + std::to_string(x) +
                 "," + std::to_string(y) + " level " + std::to_string(sink.level(x, y)) + " exact " +
                 std::to_string(exact.get_d());
      }
  }
  return "";
}

/// A polygon that doesn't cross itself: a chain above the x axis one way, a chain below it the other way. Or
/// the same along the y axis.
Contour random_simple(Random& random, int bound, bool upright) {
  Contour contour;
  for (const int direction : {1, -1}) {
    std::vector<int> along;
    for (int n = random.between(2, 6); n > 0; --n) along.push_back(random.between(-bound, bound));
    std::sort(along.begin(), along.end());
    along.erase(std::unique(along.begin(), along.end()), along.end());
    if (direction < 0) std::reverse(along.begin(), along.end());
    for (const int x : along) {
      const int y = -direction * random.between(1, bound);
      contour.push_back(upright ? SubPoint{y, x} : SubPoint{x, y});
    }
  }
  return contour;
}

/// A small window around a place on an edge.
Rect window_on(Random& random, const Contour& contour) {
  return tests::window_on_edge(contour[0], contour[1], random.between(0, 1024), 5, 4);
}

TEST(Coverage, TrianglesHaveTheirExactAreaInEveryPixel) {
  Random random(70);
  std::string first_fault;
  for (int i = 0; i < oracle::samples(100, 2000) && first_fault.empty(); ++i) {
    static constexpr std::array<int, 4> steps{1, 128, 256, 37};  // 128: along the sides of pixels
    first_fault = fault({random_contour(random, 3, 64 << i % 6, steps[static_cast<std::size_t>(i) % 4])},
                        {-8, -8, 17, 17});
  }
  EXPECT_EQ(first_fault, "") << random.seed_text();
}

TEST(Coverage, ConcavePolygonsAndHolesHaveTheirExactArea) {
  Random random(71);
  std::string first_fault;
  for (int i = 0; i < oracle::samples(50, 1500) && first_fault.empty(); ++i) {
    Contours contours{random_simple(random, 200 << i % 4, i % 2 == 0)};
    // Around it all, the other way: what is left is a frame with a concave hole.
    if (i % 3 == 0) contours.push_back({{-1700, -1650}, {-1710, 1800}, {1900, 1750}, {1800, -1700}});
    first_fault = fault(contours, {-8, -8, 17, 17});
  }
  EXPECT_EQ(first_fault, "") << random.seed_text();
}

TEST(Coverage, ContoursThatCrossGiveTheFoldedIntegralOfTheWinding) {
  Random random(72);
  std::string first_fault;
  for (int i = 0; i < oracle::samples(50, 1500) && first_fault.empty(); ++i) {
    Contours contours;
    for (int n = 0; n <= i % 3; ++n)
      contours.push_back(random_contour(random, random.between(3, 9), 300 << i % 4, i % 4 == 0 ? 128 : 1));
    first_fault = fault(contours, {-8, -8, 17, 17});
  }
  EXPECT_EQ(first_fault, "") << random.seed_text();
}

TEST(Coverage, IsExactToTheDomainsEdge) {
  Random random(73);
  std::string first_fault;
  for (int i = 0; i < oracle::samples(700, 20000) && first_fault.empty(); ++i) {
    const Contours contours{i % 2 == 0 ? random_contour(random, 3, limit >> i % 19, 1)
                                       : random_simple(random, limit >> i % 19, i % 4 == 1)};
    first_fault = fault(contours, window_on(random, contours[0]));
  }
  for (const int x : {-limit, limit})
    for (const int y : {-limit, limit})
      if (first_fault.empty())
        first_fault =
            fault({{{x, y}, {-x, y}, {-x, -y}, {x, y < 0 ? -y - 1 : -y + 1}}},
                  {std::clamp(x / 256 - 3, -(1 << 20), 1 << 20), std::max(y / 256 - 2, -(1 << 20)), 6, 5});
  EXPECT_EQ(first_fault, "") << random.seed_text();
}

TEST(Coverage, SliversAFractionOfAPixelWideAreExact) {
  Random random(74);
  std::string first_fault;
  for (int i = 0; i < oracle::samples(300, 10000) && first_fault.empty(); ++i) {
    const SubPoint a{random.between(-limit / 2, limit / 2), random.between(-limit / 2, limit / 2)};
    const SubPoint b{random.between(-limit / 2, limit / 2), random.between(-limit / 2, limit / 2)};
    const Contours contours{
        {a, b, {b.x + random.between(0, 200), b.y + random.between(0, 200)}, {a.x, a.y + 3}}};
    first_fault = fault(contours, window_on(random, contours[0]));
  }
  EXPECT_EQ(first_fault, "") << random.seed_text();
}

TEST(Coverage, PixelsOfASquareAreItsProductsOfSides) {
  // From 1/4 into column 2 to 1/2 into column 5; rows 3 and 4 whole.
  const LevelSink sink = covered({{{2 * 256 - 64, 3 * 256 - 128},
                                   {5 * 256, 3 * 256 - 128},
                                   {5 * 256, 5 * 256 - 128},
                                   {2 * 256 - 64, 5 * 256 - 128}}},
                                 FillRule::even_odd, {0, 0, 9, 9});
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x) {
      const int expected = y < 3 || y > 4 ? 0 : x == 2 ? 191 : x == 3 || x == 4 ? 255 : x == 5 ? 128 : 0;
      EXPECT_EQ(sink.level(x, y), expected) << x << "," << y;
    }
}

TEST(Coverage, AnyWindowSeesTheUnclippedLevels) {
  Random random(75);
  int wrong = 0;
  for (int i = 0; i < 60; ++i) {
    const Contours contours{random_contour(random, 6, 2500, 1), random_contour(random, 3, 90000, 1)};
    const Rect all{-10, -10, 21, 21};
    const LevelSink whole = covered(contours, FillRule::non_zero, all);
    for (int k = 0; k < 40; ++k) {
      const int x = random.between(-10, 8);
      const int y = random.between(-10, 8);
      const Rect clip{x, y, random.between(1, 11 - x), random.between(1, 11 - y)};
      const LevelSink part = covered(contours, FillRule::non_zero, clip);
      wrong += part.bad() ? 1 : 0;
      for (int py = clip.y; py < clip.bottom(); ++py)
        for (int px = clip.x; px < clip.right(); ++px)
          wrong += part.level(px, py) != whole.level(px, py) ? 1 : 0;
    }
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(Coverage, PartsThatShareAnEdgeAddUpToTheWholeWithinTheirRounding) {
  Random random(76);
  int most = 0;
  for (int i = 0; i < 400; ++i) {
    const int bound = 2048 << i % 17;
    // A square cut in two from its left to its right side, at the domain's scale or the window's.
    const SubPoint a{-bound, random.between(-bound, bound)};
    const SubPoint b{bound, random.between(-bound, bound)};
    const Contour square_top{a, {-bound, -bound}, {bound, -bound}, b};
    const Contour square_bottom{b, {bound, bound}, {-bound, bound}, a};
    const Rect clip{-7, -7, 15, 15};
    const LevelSink top = covered({square_top}, FillRule::even_odd, clip);
    const LevelSink bottom = covered({square_bottom}, FillRule::non_zero, clip);
    const LevelSink both = covered({square_top, square_bottom}, FillRule::non_zero, clip);
    for (int y = -7; y < 8; ++y)
      for (int x = -7; x < 8; ++x) {
        most = std::max(most, std::abs(top.level(x, y) + bottom.level(x, y) - 255));
        most = std::max(most, both.level(x, y) == 255 ? 0 : 99);  // one on the other: nothing leaks
      }
  }
  EXPECT_LE(most, 1) << random.seed_text();
}

TEST(Coverage, WhatAnEdgeCoversDoesntDependOnOthersInItsColumns) {
  Random random(78);
  int wrong = 0;
  for (int i = 0; i < 400; ++i) {
    Contours contours{random_contour(random, random.between(3, 7), 300 << i % 10, 1)};
    const Rect clip{-9, -9, 19, 19};
    const LevelSink alone = covered(contours, FillRule::non_zero, clip);
    // There and back: nothing, to the last bit.
    Contour& folded = contours.emplace_back(random_contour(random, 3, 300 << random.between(0, 9), 1));
    folded[2] = folded[0];
    const LevelSink crossed = covered(contours, FillRule::non_zero, clip);
    for (int y = -9; y < 10; ++y)
      for (int x = -9; x < 10; ++x) wrong += alone.level(x, y) != crossed.level(x, y) ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(Coverage, DirectionOfTheContourDoesntMatter) {
  Random random(77);
  int wrong = 0;
  for (int i = 0; i < 200; ++i) {
    Contours contours{random_simple(random, 2000, i % 2 == 0)};
    const Rect clip{-9, -9, 19, 19};
    const LevelSink there = covered(contours, FillRule::non_zero, clip);
    std::reverse(contours[0].begin(), contours[0].end());
    const LevelSink back = covered(contours, FillRule::even_odd, clip);
    for (int y = -9; y < 10; ++y)
      for (int x = -9; x < 10; ++x) wrong += there.level(x, y) != back.level(x, y) ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(Coverage, NeedsCellsForVisibleColumnsAndEdgesOnlyAndSaysSo) {
  const std::vector<SubPoint> square{{0, 0}, {2560, 0}, {2565, 2560}, {5, 2560}};
  LevelSink sink({-5, -5, 100, 100});
  // Eleven columns and one more; two edges that aren't level and one more.
  constexpr std::uint32_t needed = 12 + 3 * (sizeof(void*) == 8 ? 9 : 8);
  static_assert(coverage_cells(2, 11) == needed);
  std::vector<CoverageCell> few(needed - 1);
  EXPECT_EQ(fill_coverage(sink, FillRule::even_odd, square, few),
            (Status{Error::too_small, Argument::workspace, needed}));
  EXPECT_EQ(sink.spans(), 0);
  std::vector<CoverageCell> enough(needed);
  EXPECT_TRUE(fill_coverage(sink, FillRule::even_odd, square, enough).ok());
  EXPECT_GT(sink.spans(), 0);
  const std::vector<int> four{4};
  EXPECT_EQ(coverage_workspace(square, four, {8, 0, 100, 5}).value(), coverage_cells(2, 3));
  EXPECT_EQ(coverage_workspace(square, four, {0, 0, 5, 5}).value(), coverage_cells(1, 5));  // right of it
  EXPECT_EQ(coverage_workspace(square, four, {0, 11, 100, 5}).value(), 0U);
  EXPECT_EQ(coverage_workspace(square, four, {11, 0, 100, 5}).value(), 0U);
  EXPECT_EQ(coverage_workspace(square, four, {0, 0, 0, 5}).value(), 0U);
}

TEST(Coverage, BadArgumentsAreNamedAndNothingIsHandedOver) {
  LevelSink sink({0, 0, 20, 20});
  std::vector<CoverageCell> workspace(coverage_cells(4, 20));
  std::vector<SubPoint> square{{0, 0}, {2560, 0}, {2560, 2560}, {0, 2560}};
  const auto draw = [&](std::vector<int> lengths, FillRule rule = FillRule::even_odd) {
    return fill_coverage(sink, rule, square, lengths, workspace);
  };
  EXPECT_EQ(draw({5}), (Status{Error::mismatched, Argument::contours}));
  EXPECT_EQ(draw({3}), (Status{Error::mismatched, Argument::contours}));
  EXPECT_EQ(draw({5, -1}), (Status{Error::mismatched, Argument::contours}));
  EXPECT_EQ(draw({4}, static_cast<FillRule>(2)), (Status{Error::out_of_range, Argument::rule}));
  for (const int bad : {limit + 1, -limit - 1, INT_MAX, INT_MIN}) {
    square[2].y = bad;
    EXPECT_EQ(draw({4}), (Status{Error::out_of_domain, Argument::vertices}));
  }
  square[2].y = 2560;
  EXPECT_EQ(coverage_workspace(square, std::vector<int>{4}, {INT_MAX, 0, 5, 5}).status(),
            (Status{Error::out_of_domain, Argument::rectangle}));
  const std::vector<SubPoint> many((1U << 20U) + 1);
  EXPECT_EQ(fill_coverage(sink, FillRule::even_odd, many, workspace),
            (Status{Error::too_large, Argument::vertices, 1U << 20U}));
  EXPECT_TRUE(draw({2, 2}).ok());  // contours of two vertices are empty
  EXPECT_TRUE(fill_coverage(sink, FillRule::even_odd, {}, workspace).ok());
  EXPECT_EQ(sink.spans(), 0);
}

TEST(RampCoverage, PicksTheNearestStepAndNeverWritesBesideTheClip) {
  std::vector<std::uint8_t> bytes(16 * 8);
  const auto surface = intaglio::image::Surface<intaglio::image::Indexed4>::over(bytes, {16, 8}).value();
  using Ramp = RampCoverage<intaglio::image::Indexed4>;
  for (int first = 0; first < 16; ++first)
    for (int steps = 1; steps <= 16 - first; ++steps) {
      const auto ramp = Ramp::over(surface, static_cast<unsigned>(first), steps).value();
      int wrong = 0;
      for (int level = 0; level < 256; ++level)
        wrong += static_cast<int>(ramp.index(level)) != first + (2 * level * (steps - 1) + 255) / 510 ? 1 : 0;
      EXPECT_EQ(wrong, 0) << first << " " << steps;
    }
  const std::vector<SubPoint> large{{-9000, -9000}, {9000, -9000}, {9000, 9000}, {-9000, 9000}};
  std::vector<CoverageCell> workspace(coverage_cells(4, 16));
  const auto ramp = Ramp::over(surface, 3, 8, {2, 1, 5, 4}).value();
  ASSERT_TRUE(fill_coverage(ramp, FillRule::even_odd, large, workspace).ok());
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 16; ++x)
      EXPECT_EQ(surface.get(x, y), x >= 2 && x < 7 && y >= 1 && y < 5 ? 10U : 0U) << x << "," << y;
  EXPECT_EQ(Ramp::over(surface, 16, 1).status(), (Status{Error::out_of_range, Argument::index}));
  EXPECT_EQ(Ramp::over(surface, 0, 0).status(), (Status{Error::empty, Argument::steps}));
  EXPECT_EQ(Ramp::over(surface, 3, 14).status(), (Status{Error::too_large, Argument::steps, 13}));
}

TEST(RampCoverage, StoresTheSameWhetherItTakesRowsOrSpans) {
  using intaglio::image::Indexed8;
  Random random(79);
  int wrong = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<std::uint8_t> bytes(24 * 20, 77);
    const auto surface = intaglio::image::Surface<Indexed8>::over(bytes, {19, 19}, 24).value();
    const Contours contours{random_contour(random, random.between(3, 7), 300 << i % 7, 1)};
    const Rect clip{i % 3, i % 5, 10 + i % 7, 9 + i % 6};
    const auto ramp = RampCoverage<Indexed8>::over(surface, 3, 1 + i, clip).value();
    std::vector<CoverageCell> workspace(coverage_cells(contours[0].size(), 19));
    EXPECT_TRUE(fill_coverage(ramp, FillRule::even_odd, contours[0], workspace).ok());
    const LevelSink sink = covered(contours, FillRule::even_odd, {0, 0, 19, 19});
    for (int y = 0; y < 19; ++y)
      for (int x = 0; x < 19; ++x) {
        const bool drawn =
            x >= clip.x && x < clip.right() && y >= clip.y && y < clip.bottom() && sink.level(x, y) != 0;
        wrong += surface.get(x, y) != (drawn ? ramp.index(sink.level(x, y)) : 77U) ? 1 : 0;
      }
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(CoverageRamp, PicksTheNearestOfUpTo256Steps) {
  int wrong = 0;
  for (unsigned last = 0; last < 256; ++last)
    for (unsigned first = 0; first + last < 256; first += 1 + first / 4)
      for (int level = 0; level < 256; ++level)
        wrong += intaglio::raster::CoverageRamp(first, last).index(level) !=
                         first + (2 * static_cast<unsigned>(level) * last + 255) / 510
                     ? 1
                     : 0;
  EXPECT_EQ(wrong, 0);
}

TEST(RampCoverage, With256StepsTheIndexIsTheLevel) {
  const intaglio::image::Surface<intaglio::image::Indexed8> surface;
  const auto ramp = RampCoverage<intaglio::image::Indexed8>::over(surface, 0, 256).value();
  for (int level = 0; level < 256; ++level) EXPECT_EQ(static_cast<int>(ramp.index(level)), level);
}

}  // namespace
