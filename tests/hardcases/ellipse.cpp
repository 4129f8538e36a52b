// SPDX-License-Identifier: MIT
//
// Ellipses and rounded rectangles that broke other libraries. Expectations are counted by exact oracles.
#include <intaglio/raster/ellipse.hpp>
#include <intaglio/raster/round_rect.hpp>
#include <tests/oracle/circle.hpp>
#include <tests/oracle/oval.hpp>
#include <tests/oracle/recording_sink.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace {

using intaglio::linear::Rect;
using intaglio::raster::CornerRadii;
using intaglio::raster::draw_circle_in;
using intaglio::raster::draw_ellipse;
using intaglio::raster::draw_round_rect;
using intaglio::raster::fill_ellipse;
using intaglio::raster::fill_round_rect;
using oracle::RecordingSink;

// True if outline and filled ellipse are as the oracle says, each pixel once, on a screen around the middle.
bool exact(int a, int b, int width, int height) {
  const Rect screen{-width / 2, -height / 2, width, height};
  RecordingSink outline(screen);
  RecordingSink filled(screen);
  if (!draw_ellipse(outline, {0, 0}, a, b).ok() || !fill_ellipse(filled, {0, 0}, a, b).ok()) return false;
  if (!outline.violation().empty() || !filled.violation().empty()) return false;
  for (int y = screen.y; y < screen.y + height; ++y)
    for (int x = screen.x; x < screen.x + width; ++x)
      if (filled.writes(x, y) != (oracle::in_oval(2 * a, 2 * b, 2 * x, 2 * y) ? 1 : 0) ||
          outline.writes(x, y) != (oracle::on_oval(2 * a, 2 * b, 2 * x, 2 * y) ? 1 : 0))
        return false;
  return true;
}

// H6. u8g2 #453, #1556: 22x27 right, 23x27 broken; 29x18 with gaps; measured: 26x26 draws nothing.
TEST(EllipseHardCases, U8g2453ProductsBeyond16Bits) {
  for (const auto& [a, b] : {std::pair{22, 27}, {23, 27}, {29, 18}, {26, 26}})
    EXPECT_TRUE(exact(a, b, 64, 64));
}

// H7. TFT_HX8357 #24, sumotoy PR 1: squares and 4*(1 - a)*b^2 leave int16.
TEST(EllipseHardCases, TftHx835724SquaresBeyond16Bits) {
  EXPECT_TRUE(exact(200, 50, 420, 120));
  EXPECT_TRUE(exact(20, 25, 60, 60));
}

// H8. mikrosdk PR 5: half axes 580x200; imageproc #519: 960x540.
TEST(EllipseHardCases, Mikrosdk5AndImageproc519ProductsBeyond32Bits) {
  EXPECT_TRUE(exact(580, 200, 1180, 420));
  EXPECT_TRUE(exact(960, 540, 1940, 1100));
}

// embedded-graphics, measured: 320x240 filled paints 71,568 pixels for 60,319; first bad size 250x187.
TEST(EllipseHardCases, EmbeddedGraphicsMoireFrom250By187) {
  for (const auto& [a, b] : {std::pair{125, 93}, {160, 120}, {240, 160}, {400, 240}})
    EXPECT_TRUE(exact(a, b, 2 * a + 4, 2 * b + 4));
}

// Adafruit-GFX, measured: r = 181 is off by 75 pixels, 240x160 reaches x = 289; LovyanGFX and TFT_eSPI: 820
// and 900 are off by up to 127.
TEST(EllipseHardCases, AdafruitAndLovyanGfxErrorTermsBeyond32Bits) {
  for (const int r : {180, 181, 812, 820, 900}) EXPECT_TRUE(exact(r, r, 2 * r + 4, 2 * r + 4)) << r;
  EXPECT_TRUE(exact(240, 160, 600, 330));
}

// TFT_eSPI, measured: half axes below 2 draw nothing.
TEST(EllipseHardCases, TftEspiFlatEllipsesKeepTheirTips) {
  for (int a = 0; a <= 60; ++a)
    for (int b = 0; b <= 2; ++b) {
      EXPECT_TRUE(exact(a, b, 130, 10)) << a << "," << b;
      EXPECT_TRUE(exact(b, a, 10, 130)) << a << "," << b;
      RecordingSink sink({-70, -70, 140, 140});
      ASSERT_TRUE(draw_ellipse(sink, {0, 0}, a, b).ok());
      EXPECT_EQ(sink.writes(a, 0) + sink.writes(-a, 0) + sink.writes(0, b) + sink.writes(0, -b), 4);
    }
}

// H20, last part. PicoGraphics #1106: a circle of diameter 10 comes out 11 wide.
TEST(EllipseHardCases, PicoGraphics1106DiameterTenIsTenWide) {
  RecordingSink sink({-2, -2, 16, 16});
  ASSERT_TRUE(draw_circle_in(sink, {0, 0}, 10).ok());
  EXPECT_EQ(sink.writes(0, 4) + sink.writes(0, 5) + sink.writes(9, 4) + sink.writes(9, 5), 4);
  EXPECT_EQ(sink.writes(4, 0) + sink.writes(5, 0) + sink.writes(4, 9) + sink.writes(5, 9), 4);
  for (int i = -2; i < 14; ++i)
    EXPECT_EQ(sink.writes(-1, i) + sink.writes(10, i) + sink.writes(i, -1) + sink.writes(i, 10), 0);
}

// H3 and H17. Adafruit-GFX #188, u8g2 #1204 and #2802, lvgl PR 9830: radii above half a side wrap, crash or
// write outside. The radius that fits is (shorter side - 1) / 2.
TEST(RoundRectHardCases, Adafruit188AndU8g22802RadiiBeyondHalfASide) {
  struct Case {
    Rect rect;
    int radius;
    int fits;
  };
  for (const auto& [rect, radius, fits] : {Case{{10, 10, 3, 10}, 2, 1},
                                           {{88, 150, 30, 9}, 5, 4},
                                           {{20, 30, 40, 7}, 4, 3},
                                           {{5, 5, 1, 1}, 9, 0},
                                           {{5, 5, 12, 12}, 1000000, 5}}) {
    RecordingSink filled({0, 0, 160, 200});
    RecordingSink outline({0, 0, 160, 200});
    ASSERT_TRUE(fill_round_rect(filled, rect, CornerRadii::all(radius)).ok());
    ASSERT_TRUE(draw_round_rect(outline, rect, CornerRadii::all(radius)).ok());
    EXPECT_EQ(filled.violation() + outline.violation(), "");
    const auto in = [r = rect, fits = fits](int x, int y) {
      if (x < r.x || y < r.y || x >= r.x + r.width || y >= r.y + r.height) return false;
      const int dx = std::max({r.x + fits - x, x - (r.x + r.width - 1 - fits), 0});
      const int dy = std::max({r.y + fits - y, y - (r.y + r.height - 1 - fits), 0});
      return dx <= oracle::outline_reach(fits, dy);
    };
    bool same = true;
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 160; ++x) {
        const bool edge = in(x, y) && !(in(x - 1, y) && in(x + 1, y) && in(x, y - 1) && in(x, y + 1));
        same = same && filled.writes(x, y) == (in(x, y) ? 1 : 0) && outline.writes(x, y) == (edge ? 1 : 0);
      }
    EXPECT_TRUE(same) << radius << "\n" << filled.ascii();
  }
}

}  // namespace
