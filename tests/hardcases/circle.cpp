// SPDX-License-Identifier: MIT
//
// Circles and discs that broke other libraries. Expectations are counted by exact oracles or by hand.
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/solid.hpp>
#include <tests/oracle/circle.hpp>
#include <tests/oracle/recording_sink.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Rect;
using intaglio::raster::draw_circle;
using intaglio::raster::fill_disc;
using oracle::RecordingSink;

// Pixels of a disc on a screen; -1 if one is not as the oracle says.
int exact_disc(int cx, int cy, int radius, const Rect& screen) {
  RecordingSink sink(screen);
  if (!fill_disc(sink, {cx, cy}, radius).ok() || !sink.violation().empty()) return -1;
  for (int y = screen.y; y < screen.bottom(); ++y) {
    const int reach = oracle::outline_reach(radius, y - cy);
    for (int x = screen.x; x < screen.right(); ++x)
      if (sink.writes(x, y) != (std::abs(x - cx) <= reach ? 1 : 0)) return -1;
  }
  return sink.touched();
}

// Textbook golden values: no corner at r = 1, and no pixel twice.
TEST(CircleHardCases, TextbookCountsOfTheSmallestOutlines) {
  const int counts[] = {1, 4, 12, 16};
  for (int r = 0; r < 4; ++r) {
    RecordingSink sink({-5, -5, 11, 11});
    ASSERT_TRUE(draw_circle(sink, {0, 0}, r).ok());
    EXPECT_EQ(sink.touched(), counts[r]) << r;
    EXPECT_EQ(sink.most(), 1) << r;
  }
}

// u8g2, measured: under exclusive-or the circles r = 1 and r = 2 vanish, r = 3 keeps half. Adafruit-GFX
// paints 4 or 8 pixels of every circle twice.
TEST(CircleHardCases, U8g2CirclesSurviveExclusiveOr) {
  std::vector<std::uint8_t> pixels(101U * 101U);
  const auto surface = intaglio::image::Surface<intaglio::image::Indexed8>::over(pixels, {101, 101}).value();
  for (int r = 0; r <= 60; ++r) {
    // The larger ones are clipped: the other path must hit no pixel twice either.
    ASSERT_TRUE(draw_circle(intaglio::raster::Xor(surface, 1), {50, 50}, r).ok());
    for (int y = 0; y <= 100; ++y)
      for (int x = 0; x <= 100; ++x)
        ASSERT_EQ(surface.get(x, y), oracle::on_circle(r, x - 50, y - 50) ? 1U : 0U)
            << r << " at " << x << "," << y;
    ASSERT_TRUE(draw_circle(intaglio::raster::Xor(surface, 1), {50, 50}, r).ok());
    for (const auto pixel : pixels) ASSERT_EQ(pixel, 0) << r;
  }
}

// LovyanGFX, measured: fillCircle r = 3 and 4 draws 10 and 14 pixels twice; outlines stick out of fills.
TEST(CircleHardCases, LovyanGfxDiscsContainTheirOutlineAndDrawNoPixelTwice) {
  for (int r = 0; r <= 30; ++r) {
    const Rect box{-32, -32, 65, 65};
    RecordingSink outline(box);
    RecordingSink disc(box);
    ASSERT_TRUE(draw_circle(outline, {0, 0}, r).ok());
    ASSERT_TRUE(fill_disc(disc, {0, 0}, r).ok());
    EXPECT_EQ(disc.most(), 1) << r;
    for (int y = -32; y <= 32; ++y)
      for (int x = -32; x <= 32; ++x) ASSERT_LE(outline.writes(x, y), disc.writes(x, y)) << r;
  }
}

// halo-firmware PR #30, nanosvg #290: a radius of 2e9 hangs the device.
TEST(CircleHardCases, HaloFirmware30RadiusOfTwoBillionIsRefused) {
  RecordingSink sink({0, 0, 64, 64});
  EXPECT_EQ(draw_circle(sink, {0, 0}, 2000000000), (Status{Error::out_of_domain, Argument::radius}));
  EXPECT_EQ(fill_disc(sink, {0, 0}, 2000000000), (Status{Error::out_of_domain, Argument::radius}));
  EXPECT_EQ(sink.spans(), 0);
}

// embedded-graphics, nanosvg #290: squares of radii above 46340 leave int32, diameters of 33000 panic.
TEST(CircleHardCases, RadiiBeyond46340AreExact) {
  for (const int r : {16500, 32767, 32768, 46340, 46341, 65535, 65536, 1000000}) {
    RecordingSink sink({0, 0, 80, 60});
    ASSERT_TRUE(draw_circle(sink, {40, r + 30}, r).ok());
    ASSERT_EQ(sink.most(), 1) << r;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 80; ++x)
        ASSERT_EQ(sink.writes(x, y), oracle::on_circle(r, x - 40, y - r - 30) ? 1 : 0) << r;
    EXPECT_GE(exact_disc(-r + 40, 30, r, {0, 0, 80, 60}), 80 * 60 / 4) << r;
  }
}

// MatrixBrandy #101: rows that leave the screen on both sides are skipped. ESP_8_BIT_composite #8: discs at
// the edge wrap.
TEST(CircleHardCases, MatrixBrandy101RowsThatLeaveTheScreenOnBothSides) {
  EXPECT_EQ(exact_disc(500, 500, 800, {0, 0, 640, 480}), 640 * 480);
  EXPECT_GT(exact_disc(500, 500, 800, {0, 0, 1280, 1024}), 1000 * 1024);
  for (int x = -12; x <= 268; x += 7)
    for (const int y : {-9, 0, 5, 239, 249})
      EXPECT_GE(exact_disc(x, y, 10, {0, 0, 256, 240}), 0) << x << "," << y;
}

}  // namespace
