// SPDX-License-Identifier: MIT
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/thick_line_rungs.hpp>
#include <tests/oracle/line.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/raster/fault.hpp>
#include <tests/raster/text.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::linear::SubPoint;
using intaglio::raster::draw_line;
using intaglio::raster::draw_minor_thick_line;
using intaglio::raster::MinorWidth;
using intaglio::raster::TrueWidth;
using oracle::RecordingSink;

constexpr int limit = 1 << 20;

// True if (x, y) is one of the pixels around one of the line's in its column (row, if steep).
bool on_thick_line(SubPoint a, SubPoint b, int thickness, int x, int y) {
  const bool steep = std::abs(long{b.y} - a.y) > std::abs(long{b.x} - a.x);
  // The line's own pixel is from thickness - 1 - thickness/2 before this one to thickness/2 after it.
  for (int i = thickness / 2 + 1 - thickness; i <= thickness / 2; ++i)
    if (oracle::on_sub_line(a.x, a.y, b.x, b.y, steep ? x + i : x, steep ? y : y + i)) return true;
  return false;
}

std::string fault(SubPoint a, SubPoint b, int thickness, RecordingSink& sink) {
  sink.clear();
  return tests::fault(
      draw_minor_thick_line(sink, a, b, thickness), sink,
      [&] { return tests::text(a) + "-" + tests::text(b) + " thick " + std::to_string(thickness); },
      [&](int x, int y) { return on_thick_line(a, b, thickness, x, y); });
}

TEST(MinorThickLine, EveryShortLineIsExactUnderAnyClip) {
  std::string first;
  for (const Rect clip : {Rect{-13, -13, 27, 27}, Rect{-1, 0, 3, 4}}) {
    RecordingSink sink(clip);
    for (int dy = -9; dy <= 9; ++dy)
      for (int dx = -9; dx <= 9; ++dx)
        for (const int thickness : {0, 1, 2, 5, 6})
          if (first.empty())
            first = fault({0, thickness == 5 ? 100 : 0}, {dx * 256, dy * 256}, thickness, sink);
  }
  EXPECT_EQ(first, "");
}

TEST(MinorThickLine, RandomLinesToTheEdgeOfTheDomainAreExactFromBothEnds) {
  oracle::Random random(29);
  int visible = 0;
  const int count = oracle::samples(1500, 50000);
  for (int i = 0; i < count; ++i) {
    const int reach = limit * 256 >> random.between(0, 18);
    const SubPoint a{random.between(-reach, reach), random.between(-reach, reach)};
    const SubPoint b{random.between(-reach, reach), random.between(-reach, reach)};
    const int thickness = random.between(0, 1 << random.between(0, 6));
    const long along = random.between(0, 1000);
    const int x = static_cast<int>((a.x + (long{b.x} - a.x) * along / 1000) / 256);
    const int y = static_cast<int>((a.y + (long{b.y} - a.y) * along / 1000) / 256);
    const int size = random.between(1, 20);
    RecordingSink sink({std::clamp(x - random.between(-10, size), -limit, limit - size),
                        std::clamp(y - random.between(-10, size), -limit, limit - size), size, size});
    ASSERT_EQ(fault(a, b, thickness, sink), "") << random.seed_text();
    visible += sink.touched() > 0 ? 1 : 0;
    ASSERT_EQ(fault(b, a, thickness, sink), "") << random.seed_text();
  }
  EXPECT_GT(visible, count / 3);
}

TEST(MinorThickLine, EnormousThicknessFillsAWindowFarFromTheLine) {
  RecordingSink sink({-5, -5, 10, 10});
  for (const Point b : {Point{400000, 500}, Point{400000, 399000}, Point{7, 400000}}) {
    sink.clear();
    ASSERT_TRUE(draw_minor_thick_line(sink, {-400000, -400000}, b, limit).ok());
    EXPECT_EQ(sink.touched(), 100);
    EXPECT_EQ(sink.most(), 1);
  }
}

TEST(MinorThickLine, OfOnePixelIsTheLine) {
  oracle::Random random(30);
  RecordingSink thick({-20, -20, 40, 40});
  RecordingSink line({-20, -20, 40, 40});
  for (int i = 0; i < 500; ++i) {
    const Point a{random.between(-40, 40), random.between(-40, 40)};
    const Point b{random.between(-40, 40), random.between(-40, 40)};
    thick.clear();
    line.clear();
    ASSERT_TRUE(draw_minor_thick_line(thick, a, b, 1).ok());
    ASSERT_TRUE(draw_line(line, a, b).ok());
    ASSERT_EQ(thick.all_writes(), line.all_writes());
  }
}

TEST(MinorThickLine, HasItsThicknessInEveryColumnAndShrinksAcrossByTheCosine) {
  RecordingSink sink({-150, -150, 300, 300});
  for (const Point b : {Point{100, 0}, Point{100, 37}, Point{99, -99}, Point{-40, 100}}) {
    sink.clear();
    ASSERT_TRUE(draw_minor_thick_line(sink, {0, 0}, b, 12).ok());
    const int length = std::max(std::abs(b.x), std::abs(b.y));
    EXPECT_EQ(sink.touched(), 12 * (length + 1));
    // Its area is that of a rectangle as long as the line and this wide.
    const double across = 12.0 * length / std::hypot(b.x, b.y);
    EXPECT_EQ(MinorWidth{}({0, 0}, b, 12), std::lround(256 * across));
  }
}

TEST(MinorThickLine, KeepsTheStatedBoundOfItsWidthAndNeedsIt) {
  oracle::Random random(31);
  double worst = 0;
  for (int i = 0; i < 5000; ++i) {
    const Point a{random.between(-limit, limit), random.between(-limit, limit)};
    const Point b = i == 0 ? Point{a.x < 0 ? a.x + 5000 : a.x - 5000, a.y < 0 ? a.y + 5000 : a.y - 5000}
                           : Point{random.between(-limit, limit), random.between(-limit, limit)};
    const int width = random.between(1, limit);
    const double asked = 256.0 * width;
    worst = std::max(worst, (asked - MinorWidth{}(a, b, width)) / asked);
    ASSERT_LE(MinorWidth{}(a, b, width), 256 * width);
    ASSERT_EQ(TrueWidth{}(a, b, width), 256 * width);
  }
  EXPECT_LE(worst, MinorWidth::bound.thousandths / 1000.0);
  EXPECT_GT(worst, MinorWidth::bound.thousandths / 1000.0 - 0.001);
  EXPECT_TRUE(TrueWidth::bound.exact());
}

TEST(MinorThickLine, BadArgumentsAreRefusedAndNothingIsDrawn) {
  RecordingSink sink({-10, -10, 20, 20});
  const Status point{Error::out_of_domain, Argument::point};
  const Status width{Error::out_of_domain, Argument::width};
  for (const int bad : {limit * 256 + 1, -limit * 256 - 1, INT_MAX, INT_MIN}) {
    EXPECT_EQ(draw_minor_thick_line(sink, SubPoint{bad, 0}, SubPoint{0, 0}, 3), point);
    EXPECT_EQ(draw_minor_thick_line(sink, SubPoint{0, 0}, SubPoint{0, bad}, 3), point);
    EXPECT_EQ(draw_minor_thick_line(sink, {0, bad}, {0, 0}, 3), point);
    EXPECT_EQ(draw_minor_thick_line(sink, {0, 0}, {9, 0}, bad), width);
  }
  EXPECT_EQ(draw_minor_thick_line(sink, {0, 0}, {9, 0}, -1), width);
  EXPECT_EQ(sink.spans(), 0);
  EXPECT_TRUE(draw_minor_thick_line(RecordingSink({0, 0, 0, 0}), {-9, -9}, {9, 9}, 5).ok());
}

}  // namespace
