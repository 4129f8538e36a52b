// SPDX-License-Identifier: MIT
//
// Polylines and triangles whose strokes broke other libraries. Expectations: each pixel against an exact
// oracle.
#include <intaglio/raster/polyline.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/oracle/stroke.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using intaglio::linear::Rect;
using intaglio::raster::Cap;
using intaglio::raster::draw_polyline;
using intaglio::raster::Join;
using intaglio::raster::Stroke;
using intaglio::raster::StrokeEdge;
using oracle::Contour;
using oracle::RecordingSink;

// What is wrong with the stroke along these pixels, with all joins and caps; empty if each pixel that belongs
// is drawn once, and no other.
std::string fault(Contour points, int width, bool closed) {
  const auto by_x =
      std::minmax_element(points.begin(), points.end(), [](auto a, auto b) { return a.x < b.x; });
  const auto by_y =
      std::minmax_element(points.begin(), points.end(), [](auto a, auto b) { return a.y < b.y; });
  // A miter reaches twice the width.
  const int out = 2 * width + 2;
  const Rect window{by_x.first->x - out, by_y.first->y - out, by_x.second->x - by_x.first->x + 2 * out,
                    by_y.second->y - by_y.first->y + 2 * out};
  for (auto& p : points) p = {p.x * 256, p.y * 256};
  std::vector<StrokeEdge> workspace(10 * points.size());
  for (const Join join : {Join::miter, Join::bevel, Join::round})
    for (const Cap cap : {Cap::butt, Cap::square, Cap::round}) {
      const Stroke stroke{.width = width * 256, .join = join, .cap = cap, .closed = closed};
      const oracle::StrokeArea area(points, stroke);
      RecordingSink sink(window);
      if (!draw_polyline(sink, points, stroke, workspace).ok()) return "refused";
      std::string wrong = sink.fault([&](int x, int y) { return area.holds(x, y); });
      if (!wrong.empty()) return wrong;
      if (sink.touched() == 0) return "nothing drawn";
    }
  return "";
}

// embedded-graphics #489: the joint of two segments is drawn twice.
TEST(StrokeHardCases, EmbeddedGraphics489NoOverdrawAtTheJoint) {
  EXPECT_EQ(fault({{10, 5}, {5, 10}, {10, 10}}, 5, false), "");
}

// embedded-graphics #526: pixels of the joint are missing.
TEST(StrokeHardCases, EmbeddedGraphics526NoVoidPixels) {
  EXPECT_EQ(fault({{5, 30}, {11, 19}, {16, 10}}, 3, false), "");
}

// embedded-graphics #471: ten points, 5 wide, ending at (137, 15), with a spur at a joint. The thread's other
// points aren't at hand; these are a zigzag of the same kind, with sharp and blunt turns.
TEST(StrokeHardCases, EmbeddedGraphics471ZigzagWithoutSpurs) {
  const Contour zigzag{{5, 60},  {20, 12}, {31, 70}, {40, 66}, {58, 20},
                       {66, 78}, {85, 30}, {99, 64}, {120, 8}, {137, 15}};
  EXPECT_EQ(fault(zigzag, 5, false), "");
  EXPECT_EQ(fault(zigzag, 5, true), "");
  // No pixel is farther from the segments than the miter limit allows: the picture ends within 10 pixels.
  RecordingSink sink({-300, -300, 800, 700});
  Contour points = zigzag;
  for (auto& p : points) p = {p.x * 256, p.y * 256};
  std::vector<StrokeEdge> workspace(100);
  ASSERT_TRUE(draw_polyline(sink, points, {.width = 5 * 256}, workspace).ok());
  int outside = 0;
  for (int y = -300; y < 400; ++y)
    for (int x = -300; x < 500; ++x)
      if (x < -5 || x > 147 || y < -2 || y > 88) outside += sink.writes(x, y);
  EXPECT_EQ(outside, 0);
}

// Tests of embedded-graphics' triangle/styled.rs: strokes of triangles with missing lines and leaking fills.
TEST(StrokeHardCases, EmbeddedGraphicsTriangleWithMissingLines) {
  EXPECT_EQ(fault({{10, 11}, {20, 11}, {8, 4}}, 5, true), "");
}

TEST(StrokeHardCases, EmbeddedGraphicsTriangleWithAFillLeak) {
  EXPECT_EQ(fault({{0, 20}, {20, 0}, {14, 24}}, 5, true), "");
}

// The same, nearly on one line, with a lump.
TEST(StrokeHardCases, EmbeddedGraphicsNearlyCollinearTriangleWithoutALump) {
  for (int width = 1; width <= 20; ++width)
    EXPECT_EQ(fault({{90, 80}, {100, 70}, {102, 73}}, width, true), "") << width;
}

// embedded-graphics #719 and #817: strokes whose products leave 32 bits.
TEST(StrokeHardCases, EmbeddedGraphics719And817LargeTriangles) {
  EXPECT_EQ(fault({{10, 10}, {10, 229}, {309, 229}}, 7, true), "");
  EXPECT_EQ(fault({{0, 0}, {-210, -120}, {0, 120}}, 9, true), "");
}

}  // namespace
