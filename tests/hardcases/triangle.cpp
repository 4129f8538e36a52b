// SPDX-License-Identifier: MIT
//
// Triangles that broke other libraries. Expectations are counted by exact oracles or by hand.
#include <intaglio/raster/triangle.hpp>
#include <tests/oracle/counting_sink.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/recording_sink.hpp>

#include <climits>
#include <gtest/gtest.h>

namespace {

using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::linear::SubPoint;
using intaglio::linear::to_subpixel;
using intaglio::raster::fill_triangle;
using oracle::RecordingSink;

// Draws the triangle on a screen and returns how many pixels it has there, or -1 if one is not as the oracle
// says.
int exact_pixels(Point a, Point b, Point c, const Rect& screen) {
  RecordingSink sink(screen);
  if (!fill_triangle(sink, a, b, c).ok() || !sink.violation().empty()) return -1;
  for (int y = screen.y; y < screen.bottom(); ++y)
    for (int x = screen.x; x < screen.right(); ++x)
      if (sink.writes(x, y) !=
          (oracle::in_triangle(to_subpixel(a), to_subpixel(b), to_subpixel(c), x, y) ? 1 : 0))
        return -1;
  return sink.touched();
}

// Adafruit-GFX #164: the edge products leave int16.
TEST(TriangleHardCases, AdafruitGfx164SteepTriangleWithWideProducts) {
  EXPECT_EQ(exact_pixels({314, 11}, {14, 200}, {97, 237}, {0, 0, 320, 240}), 13395);
}

// Adafruit-GFX #218, #219: dx12*(y - y1) leaves int16 in the lower half of a tall triangle.
TEST(TriangleHardCases, AdafruitGfx218LowerHalfOfATallTriangle) {
  EXPECT_GT(exact_pixels({0, 0}, {319, 240}, {10, 479}, {0, 0, 320, 480}), 70000);
}

// Adafruit-GFX #325, #326: y*width leaves int16 on a 240x320 canvas.
TEST(TriangleHardCases, AdafruitGfx325CanvasIndexBeyond32767) {
  EXPECT_EQ(exact_pixels({0, 0}, {239, 0}, {120, 310}, {0, 0, 240, 320}), 37169);
}

// LVGL #8999: another triangle was drawn, with a vertex of the bounding box.
TEST(TriangleHardCases, Lvgl8999VerticesAreNotMixedUp) {
  EXPECT_EQ(exact_pixels({50, 50}, {50, 100}, {110, 110}, {0, 0, 160, 160}), 1500);
}

// LVGL #1229, #960: a seam or a double row on the diagonal of a trapezoid made of two triangles.
TEST(TriangleHardCases, Lvgl1229TrapezoidOfTwoTrianglesHasNoSeam) {
  RecordingSink sink({0, 0, 64, 64});
  const Point a{20, 10};
  const Point b{40, 10};
  const Point c{55, 50};
  const Point d{5, 50};
  ASSERT_TRUE(fill_triangle(sink, a, b, c).ok());
  ASSERT_TRUE(fill_triangle(sink, a, c, d).ok());
  const oracle::Contours trapezoid{{to_subpixel(a), to_subpixel(b), to_subpixel(c), to_subpixel(d)}};
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      ASSERT_EQ(sink.writes(x, y), oracle::in_polygon(trapezoid, true, x, y) ? 1 : 0);
}

// DRTK #9: two triangles of a square whose diagonal runs through pixel centres; holes along it.
TEST(TriangleHardCases, Drtk9DiagonalThroughPixelCentresHasNoHoles) {
  RecordingSink sink({0, 0, 8, 8});
  // .5, .49993896, 6.5 and 6.50006104 in 1/256, to the nearest.
  const SubPoint v0{128, 128};
  const SubPoint v1{128, 1664};
  const SubPoint v2{1664, 128};
  const SubPoint v3{1664, 1664};
  ASSERT_TRUE(fill_triangle(sink, v0, v1, v2).ok());
  EXPECT_EQ(sink.touched(), 15);
  ASSERT_TRUE(fill_triangle(sink, v3, v2, v1).ok());
  EXPECT_EQ(sink.touched(), 36);
  EXPECT_EQ(sink.most(), 1);
}

// KeeperFX #4668: coordinates beyond +-32767 shifted by 16 bits write outside a 2560x1440 screen.
TEST(TriangleHardCases, KeeperFx4668CoordinatesBeyond32767AreClipped) {
  EXPECT_GT(exact_pixels({-40000, 700}, {50000, -33000}, {33000, 70000}, {0, 0, 2560, 1440}), 0);
  EXPECT_EQ(exact_pixels({32768, 0}, {65536, 10}, {40000, 1440}, {0, 0, 2560, 1440}), 0);
}

// embedded-graphics #719: overflow when a large right triangle is drawn.
TEST(TriangleHardCases, EmbeddedGraphics719LargeRightTriangle) {
  // Rows 10..228: row y has the columns 10 .. 10 + ceil(299 (y - 10)/219) - 1.
  int expected = 0;
  for (int row = 0; row < 219; ++row) expected += (299 * row + 218) / 219;
  EXPECT_EQ(exact_pixels({10, 10}, {10, 229}, {309, 229}, {0, 0, 320, 240}), expected);
}

// embedded-graphics #817: the cross product of the edges (-210,-120) and (0,240), squared, leaves int32.
TEST(TriangleHardCases, EmbeddedGraphics817CrossProductOfLongEdges) {
  EXPECT_GT(exact_pixels({215, 125}, {5, 5}, {215, 365}, {0, 0, 320, 400}), 20000);
}

// embedded-graphics #308, #364: endless loop, rows above the screen dropped with what is below them.
TEST(TriangleHardCases, EmbeddedGraphics308RowsAboveTheScreen) {
  EXPECT_GT(exact_pixels({10, 10}, {20, 30}, {30, -10}, {0, 0, 64, 64}), 0);
  EXPECT_GT(exact_pixels({10, 10}, {20, 20}, {30, -30}, {0, 0, 64, 64}), 0);
}

// embedded-graphics, measured: a right triangle with legs of 216 px overflows, 215 is the last that doesn't.
TEST(TriangleHardCases, EmbeddedGraphicsRightTriangleWithLegsOf216) {
  for (const int legs : {215, 216, 217, 1000, 46341, 1 << 20}) {
    oracle::CountingSink sink({0, 0, 1 << 20, 1 << 20});
    ASSERT_TRUE(fill_triangle(sink, Point{0, 0}, Point{legs, 0}, Point{0, legs}).ok());
    EXPECT_EQ(sink.pixels(), std::int64_t{legs} * (legs + 1) / 2) << legs;
  }
}

// PicoGraphics, measured: a fan over a 40x36 rectangle has a hole at the vertex and lacks a row and a column.
TEST(TriangleHardCases, PicoGraphicsFanOverARectangle) {
  RecordingSink sink({-2, -2, 50, 50});
  const Point corners[] = {{0, 0}, {40, 0}, {40, 36}, {0, 36}};
  for (int i = 0; i < 4; ++i)
    ASSERT_TRUE(fill_triangle(sink, Point{20, 18}, corners[i], corners[(i + 1) % 4]).ok());
  EXPECT_EQ(sink.touched(), 40 * 36);
  EXPECT_EQ(sink.most(), 1);
  EXPECT_EQ(sink.writes(20, 18), 1);
  EXPECT_EQ(sink.writes(0, 0), 1);
  EXPECT_EQ(sink.writes(39, 35), 1);
}

// PicoGraphics, measured: one pixel, because the edge function leaves int32.
TEST(TriangleHardCases, PicoGraphicsTriangleOf60000Pixels) {
  oracle::CountingSink all({0, 0, 60001, 60001});
  ASSERT_TRUE(fill_triangle(all, Point{0, 0}, Point{60000, 0}, Point{0, 60000}).ok());
  EXPECT_EQ(all.pixels(), 60000LL * 60001 / 2);
  EXPECT_EQ(exact_pixels({0, 0}, {60000, 0}, {0, 60000}, {29900, 29950, 200, 150}), 150 * 151 / 2);
}

// u8g2, measured: a triangle wholly left of the screen paints 640 pixels.
TEST(TriangleHardCases, U8g2TriangleLeftOfTheScreen) {
  EXPECT_EQ(exact_pixels({-30, 5}, {-5, 20}, {-40, 60}, {0, 0, 128, 64}), 0);
}

// ETHOS #5213, framebuf2 #1: small triangles with an upright side or a level top leak or run away.
TEST(TriangleHardCases, Ethos5213SmallTrianglesWithUprightAndLevelSides) {
  for (int n = 1; n < 10; ++n)
    for (int m = -10; m < 10; ++m) {
      const Rect screen{0, 0, 32, 32};
      EXPECT_GE(exact_pixels({15, 15}, {15, 15 + n}, {15 + m, 18}, screen), 0)
          << n << " " << m;  // upright side
      EXPECT_GE(exact_pixels({15, 15}, {15 + n, 15}, {15 + m, 20}, screen), 0)
          << n << " " << m;  // equal tops
      EXPECT_GE(exact_pixels({15, 25}, {15 + n, 25}, {15 + m, 20}, screen), 0)
          << n << " " << m;  // equal bottoms
    }
}

// washingtondc #91: twice the area of half a screen, 307,200, leaves 16 bits.
TEST(TriangleHardCases, Washingtondc91AreaOfHalfAScreen) {
  EXPECT_EQ(exact_pixels({0, 0}, {640, 0}, {0, 480}, {0, 0, 640, 480}) +
                exact_pixels({640, 480}, {0, 480}, {640, 0}, {0, 0, 640, 480}),
            640 * 480);
}

// Avocado #18, TIC-80 #776 and #1059: what is half transparent is blended twice along a shared edge; a
// triangle one pixel off.
TEST(TriangleHardCases, Avocado18SharedEdgesAreBlendedOnce) {
  EXPECT_GT(exact_pixels({150, 50}, {185, 55}, {163, 120}, {0, 0, 240, 136}), 900);
  for (int i = 0; i < 40; ++i) {
    RecordingSink sink({0, 0, 240, 136});
    const Point a{150 - i, 50};
    const Point b{163 + i, 120 - i};
    ASSERT_TRUE(fill_triangle(sink, a, Point{185, 55}, b).ok());
    ASSERT_TRUE(fill_triangle(sink, b, Point{100, 110 + i % 7}, a).ok());
    ASSERT_EQ(sink.most(), 1) << i;
  }
}

// Textbook golden value: two half-open triangles share out the 25 pixels of a square.
TEST(TriangleHardCases, TextbookHalfOpenTrianglesPartitionASquare) {
  EXPECT_EQ(exact_pixels({0, 0}, {5, 0}, {5, 5}, {0, 0, 8, 8}), 15);
  EXPECT_EQ(exact_pixels({0, 5}, {0, 0}, {5, 5}, {0, 0, 8, 8}), 10);
}

}  // namespace
