// SPDX-License-Identifier: MIT
//
// Polygons that broke other libraries. Expectations are counted by exact oracles or by hand.
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/polygon.hpp>
#include <tests/oracle/coverage.hpp>
#include <tests/oracle/level_sink.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/recording_sink.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using intaglio::linear::Rect;
using intaglio::linear::SubPoint;
using intaglio::raster::fill_polygon;
using intaglio::raster::FillRule;
using intaglio::raster::PolygonEdge;
using oracle::RecordingSink;

std::vector<SubPoint> pixels(std::vector<SubPoint> points) {
  for (SubPoint& p : points) p = {p.x * 256, p.y * 256};
  return points;
}

// Pixels of a polygon on a screen; -1 if one is not as the oracle says.
int exact_pixels(const std::vector<SubPoint>& contour, FillRule rule, const Rect& screen) {
  RecordingSink sink(screen);
  std::vector<PolygonEdge> workspace(contour.size());
  if (!fill_polygon(sink, rule, contour, workspace).ok() || !sink.violation().empty()) return -1;
  for (int y = screen.y; y < screen.bottom(); ++y)
    for (int x = screen.x; x < screen.right(); ++x)
      if (sink.writes(x, y) != (oracle::in_polygon({contour}, rule == FillRule::even_odd, x, y) ? 1 : 0))
        return -1;
  return sink.touched();
}

// BangleApps #2661: a quad wholly above the screen wraps into it in 16.16.
TEST(PolygonHardCases, BangleApps2661QuadAboveTheScreenDrawsNothing) {
  // (88, -253) and (12, -2071), 2.997 to either side and .125 up and down, in 1/256.
  const std::vector<SubPoint> quad{{88 * 256 + 767, -253 * 256 - 32},
                                   {12 * 256 + 767, -2071 * 256 - 32},
                                   {12 * 256 - 767, -2071 * 256 + 32},
                                   {88 * 256 - 767, -253 * 256 + 32}};
  EXPECT_EQ(exact_pixels(quad, FillRule::even_odd, {0, 0, 176, 176}), 0);
  EXPECT_EQ(exact_pixels(quad, FillRule::non_zero, {0, 0, 176, 176}), 0);
  EXPECT_GT(exact_pixels(quad, FillRule::even_odd, {0, -2100, 176, 1900}), 10000);
}

// Espruino #1796: an arrow with a notch.
TEST(PolygonHardCases, Espruino1796NotchedArrow) {
  const auto arrow = pixels({{120, 40}, {200, 200}, {170, 200}, {120, 100}, {70, 180}, {40, 179}});
  EXPECT_GT(exact_pixels(arrow, FillRule::even_odd, {0, 0, 240, 240}), 5000);
  EXPECT_GT(exact_pixels(arrow, FillRule::non_zero, {0, 0, 240, 240}), 5000);
}

// PicoGraphics, measured: adjacent polygons overlap.
TEST(PolygonHardCases, PicoGraphicsAdjacentPolygonsDontOverlap) {
  RecordingSink sink({0, 0, 70, 70});
  std::vector<PolygonEdge> workspace(8);
  const auto left = pixels({{3, 3}, {30, 2}, {36, 64}, {5, 60}});
  const auto right = pixels({{30, 2}, {66, 9}, {60, 61}, {36, 64}});
  ASSERT_TRUE(fill_polygon(sink, FillRule::even_odd, left, workspace).ok());
  ASSERT_TRUE(fill_polygon(sink, FillRule::even_odd, right, workspace).ok());
  EXPECT_EQ(sink.most(), 1);
  const auto both = pixels({{3, 3}, {30, 2}, {66, 9}, {60, 61}, {36, 64}, {5, 60}});
  for (int y = 0; y < 70; ++y)
    for (int x = 0; x < 70; ++x) ASSERT_EQ(sink.writes(x, y), oracle::in_polygon({both}, true, x, y) ? 1 : 0);
}

// Textbook, erratum on winding: "odd winding" is the even-odd rule; the heart of a pentagram tells them
// apart.
TEST(PolygonHardCases, TextbookWindingRulesDifferInAPentagramsHeart) {
  const auto star = pixels({{50, 5}, {76, 86}, {8, 36}, {92, 36}, {24, 86}});
  const Rect screen{0, 0, 100, 100};
  const int even_odd = exact_pixels(star, FillRule::even_odd, screen);
  const int non_zero = exact_pixels(star, FillRule::non_zero, screen);
  EXPECT_GT(even_odd, 1000);
  EXPECT_GT(non_zero, even_odd + 500);
  EXPECT_TRUE(oracle::in_polygon({star}, false, 50, 50));
  EXPECT_FALSE(oracle::in_polygon({star}, true, 50, 50));
}

// Textbook, erratum on the edge table: it must hold the x of the lower end point, not the smallest x.
TEST(PolygonHardCases, TextbookEdgesLeaningLeft) {
  const auto leaning = pixels({{40, 0}, {60, 0}, {20, 30}, {0, 30}});
  EXPECT_EQ(exact_pixels(leaning, FillRule::even_odd, {0, 0, 64, 32}), 20 * 30);
}

// H25. lvgl PR #7052, lunasvg #217: in 24.8 on 32 bits paths beyond +-4096 pixels overflow.
TEST(PolygonHardCases, Lvgl7052PathsBeyond4096Pixels) {
  const Rect screen{0, 0, 320, 240};
  for (const int far : {4095, 4096, 4097, 32767, 32768, 65536, 1 << 20}) {
    const auto wedge = pixels({{-far, -far}, {far, -far + 7}, {100, 200}, {-far, far}});
    EXPECT_GT(exact_pixels(wedge, FillRule::even_odd, screen), 1000) << far;
    EXPECT_GT(exact_pixels(wedge, FillRule::non_zero, screen), 1000) << far;
  }
  RecordingSink sink(screen);
  std::vector<PolygonEdge> workspace(3);
  EXPECT_EQ(fill_polygon(sink, FillRule::even_odd,
                         std::vector<SubPoint>{{-2000000000, 76}, {5000, 5000}, {9000, 60}}, workspace),
            (intaglio::Status{intaglio::Error::out_of_domain, intaglio::Argument::vertices}));
}

// stb #1057, #151, #353: an outline of 48 edges a few sub-pixels large: coverage above 1, lines across.
TEST(PolygonHardCases, Stb1057OutlineOf48EdgesAtSubPixelScale) {
  using intaglio::raster::CoverageCell;
  for (const int radius : {3, 20, 100, 300, 900}) {
    std::vector<SubPoint> outline;
    for (int i = 0; i < 48; ++i) {
      const double turn = 6.283185307179586 * i / 48;
      const double r = i % 3 == 0 ? radius * 0.4 : radius;
      outline.push_back({1111 + static_cast<int>(std::lround(r * std::cos(turn))),
                         1041 + static_cast<int>(std::lround(r * std::sin(turn)))});
    }
    const Rect screen{0, 0, 9, 9};
    oracle::LevelSink sink(screen);
    std::vector<CoverageCell> workspace(intaglio::raster::coverage_cells(outline.size(), 9));
    ASSERT_TRUE(intaglio::raster::fill_coverage(sink, FillRule::non_zero, outline, workspace).ok());
    EXPECT_FALSE(sink.bad());
    for (int y = 0; y < 9; ++y)
      for (int x = 0; x < 9; ++x) {
        const mpq_class exact = 255 * oracle::coverage({outline}, false, x, y);
        EXPECT_LE(abs(exact - sink.level(x, y)), mpq_class(51, 100)) << radius << " " << x << "," << y;
      }
  }
}

}  // namespace
