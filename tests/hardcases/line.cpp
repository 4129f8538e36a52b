// SPDX-License-Identifier: MIT
//
// Lines that broke other libraries, beside those in tests/raster/line.cpp. Expectations are asked of the
// oracle pixel by pixel.
#include <intaglio/raster/arc.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/ring.hpp>
#include <intaglio/raster/round_rect.hpp>
#include <intaglio/raster/thick_line.hpp>
#include <tests/oracle/circle.hpp>
#include <tests/oracle/line.hpp>
#include <tests/oracle/recording_sink.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::linear::SubPoint;
using intaglio::raster::draw_line;
using oracle::RecordingSink;

// Pixels of a line on a screen; -1 if one is not as the oracle says.
int exact_pixels(Point a, Point b, const Rect& screen) {
  RecordingSink sink(screen);
  const auto belongs = [&](int x, int y) { return oracle::on_line(a.x, a.y, b.x, b.y, x, y); };
  return draw_line(sink, a, b).ok() && sink.fault(belongs).empty() ? sink.touched() : -1;
}

// H18. LVGL #7247: p1.y = 283.2 and p2.y = 283.0 are different numbers and equal as integers: divided by
// zero.
TEST(LineHardCases, Lvgl7247EndsThatDifferByAFractionOfAPixel) {
  for (const auto& [a, b] : {std::pair{SubPoint{2560, 72499}, SubPoint{40000, 72448}},
                             {SubPoint{72499, 2560}, SubPoint{72448, 40000}},
                             {SubPoint{2560, 72499}, SubPoint{2561, 72448}}}) {
    RecordingSink sink({0, 0, 300, 300});
    ASSERT_TRUE(draw_line(sink, a, b).ok());
    for (int y = 0; y < 300; ++y)
      for (int x = 0; x < 300; ++x)
        ASSERT_EQ(sink.writes(x, y), oracle::on_sub_line(a.x, a.y, b.x, b.y, x, y) ? 1 : 0);
    EXPECT_GT(sink.touched(), 0);
  }
}

// Adafruit-GFX, measured: with an int16 counter the line to 32767 never ends.
TEST(LineHardCases, AdafruitLineToTheLargestShortInteger) {
  EXPECT_EQ(exact_pixels({0, 5}, {32767, 6}, {0, 0, 320, 240}), 320);
  EXPECT_EQ(exact_pixels({0, 5}, {32767, 6}, {16300, 0, 200, 20}), 200);
  EXPECT_EQ(exact_pixels({0, 5}, {32767, 6}, {32700, 0, 200, 20}), 68);
}

// Adafruit-GFX, measured: dx wraps, and y runs to 551. PicoGraphics swaps ends through an int16.
TEST(LineHardCases, AdafruitDifferencesBeyond32767) {
  for (const Rect screen : {Rect{0, 0, 320, 240}, {-160, 20, 320, 240}, {19900, 0, 200, 240}})
    EXPECT_GE(exact_pixels({-20000, 0}, {20000, 100}, screen), screen.x > 0 ? 101 : 320);
  EXPECT_EQ(exact_pixels({40000, 7}, {-40000, 7}, {0, 0, 320, 240}), 320);
}

// u8g2, measured: coordinates without a sign draw from (20, 30) to the right edge; in 8 bits (0,0)-(200,1)
// reaches row 6.
TEST(LineHardCases, U8g2NegativeColumnsAndNearlyLevelLines) {
  EXPECT_EQ(exact_pixels({-10, 0}, {20, 30}, {0, 0, 128, 64}), 21);
  EXPECT_EQ(exact_pixels({0, 0}, {200, 1}, {0, 0, 256, 64}), 201);
  EXPECT_EQ(exact_pixels({0, 0}, {200, 1}, {0, 2, 256, 62}), 0);
}

// embedded-graphics, measured: a line over 4e9 panics.
TEST(LineHardCases, EmbeddedGraphicsLineOfFourBillionPixelsIsRefused) {
  RecordingSink sink({0, 0, 64, 64});
  EXPECT_EQ(draw_line(sink, Point{-2000000000, 0}, Point{2000000000, 7}),
            (Status{Error::out_of_domain, Argument::point}));
  EXPECT_EQ(sink.spans(), 0);
}

// embedded-graphics, measured: 1136 of 1681 lines of width 3 differ from B to A.
TEST(LineHardCases, EmbeddedGraphicsThickLinesAreTheSameBackwards) {
  for (int dy = -20; dy <= 20; ++dy)
    for (int dx = -20; dx <= 20; ++dx) {
      RecordingSink there({-24, -24, 49, 49});
      RecordingSink back({-24, -24, 49, 49});
      ASSERT_TRUE(intaglio::raster::draw_thick_line(there, Point{0, 0}, Point{dx, dy}, 3).ok());
      ASSERT_TRUE(intaglio::raster::draw_thick_line(back, Point{dx, dy}, Point{0, 0}, 3).ok());
      ASSERT_EQ(there.all_writes(), back.all_writes()) << dx << "," << dy;
    }
}

// H16. LVGL #1399: sin * radius leaves int16 from radius 128 on. The one pixel of the shortest arc lies in
// its direction, to half a pixel along and across.
TEST(LineHardCases, Lvgl1399ScaleMarksAtRadiiBeyond128) {
  for (const int radius : {127, 128, 139, 255, 256, 1000, 40000})
    for (int angle = 0; angle < 65536; angle += 331) {
      const double turn = 6.283185307179586 * angle / 65536;
      const Point tip{static_cast<int>(std::lround(radius * std::cos(turn))),
                      static_cast<int>(std::lround(radius * std::sin(turn)))};
      RecordingSink sink({tip.x - 3, tip.y - 3, 7, 7});
      const int sweep = 65536 / radius;  // a few pixels
      ASSERT_TRUE(intaglio::raster::draw_arc(sink, {0, 0}, radius,
                                             intaglio::number::Angle::from_steps(angle - sweep / 2), sweep)
                      .ok());
      ASSERT_GT(sink.touched(), 0) << radius << " at " << angle;
      for (int y = tip.y - 3; y <= tip.y + 3; ++y)
        for (int x = tip.x - 3; x <= tip.x + 3; ++x)
          ASSERT_LE(sink.writes(x, y), oracle::on_circle(radius, x, y) ? 1 : 0);
    }
}

// H17. LVGL: a mask of 2560x2560 overflows; a radius above the side; an arc wider than its radius.
TEST(LineHardCases, LvglMasksOf2560PixelsAndRadiiBeyondTheSide) {
  using intaglio::raster::CornerRadii;
  constexpr int side = 2560;
  for (const int radius : {1279, 3000, 1 << 20}) {  // (2560 - 1) / 2 is the most that fits
    RecordingSink corner({-2, -2, 1300, 30});
    ASSERT_TRUE(intaglio::raster::fill_round_rect(corner, {0, 0, side, side}, CornerRadii::all(radius)).ok());
    for (int y = 0; y < 28; ++y) {
      const int reach = oracle::outline_reach(1279, 1279 - y);
      for (int x = 0; x < 1279; ++x)
        ASSERT_EQ(corner.writes(x, y), x >= 1279 - reach ? 1 : 0) << x << "," << y;
    }
  }
  RecordingSink ring({-20, -20, 41, 41});
  ASSERT_TRUE(intaglio::raster::fill_ring(ring, {0, 0}, 0, 15).ok());  // as wide as can be
  for (int y = -20; y <= 20; ++y)
    for (int x = -20; x <= 20; ++x)
      ASSERT_EQ(ring.writes(x, y), std::abs(x) <= oracle::outline_reach(15, y) && (x != 0 || y != 0) ? 1 : 0);
}

}  // namespace
