// SPDX-License-Identifier: MIT
//
// Polygons that broke other libraries. Expectations are counted by exact oracles or by hand.
#include <intaglio/raster/polygon.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/recording_sink.hpp>

#include <gtest/gtest.h>

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

}  // namespace
