// SPDX-License-Identifier: MIT
#include <intaglio/image/surface.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/raster/thick_line.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/oracle/stroke.hpp>
#include <tests/raster/fault.hpp>
#include <tests/raster/text.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::linear::SubPoint;
using intaglio::raster::Cap;
using intaglio::raster::draw_thick_line;
using oracle::RecordingSink;

constexpr std::array caps{Cap::butt, Cap::square, Cap::round};

struct Thick {
  SubPoint a, b;
  int width;
  Cap cap;
};

std::string text(const Thick& t) {
  return tests::text(t.a) + "-" + tests::text(t.b) + " width " + std::to_string(t.width) + " cap " +
         std::to_string(static_cast<int>(t.cap));
}

// What is wrong in this window; empty if each pixel of the parallelogram and its caps is drawn once, and no
// other.
std::string fault(const Thick& t, RecordingSink& sink) {
  sink.clear();
  const oracle::StrokeArea area({t.a, t.b}, {.width = t.width, .cap = t.cap});
  return tests::fault(
      draw_thick_line(sink, t.a, t.b, t.width, t.cap), sink, [&] { return text(t); },
      [&](int x, int y) { return area.holds(x, y); });
}

TEST(ThickLine, ShortLinesAreTheRectanglesOfTheirWidth) {
  std::string first_fault;
  for (const Rect clip : {Rect{-9, -9, 19, 19}, Rect{-1, 0, 3, 4}}) {
    RecordingSink sink(clip);
    for (int dy = -12; dy <= 12; dy += oracle::samples(2, 1))
      for (int dx = -12; dx <= 12; ++dx)
        for (const int width : {0, 1, 128, 256, 384, 512, 800, 1280})
          for (const Cap cap : caps)
            for (const int unit : {128, 256})
              if (first_fault.empty())
                first_fault = fault({{0, 64}, {dx * unit, 64 + dy * unit}, width, cap}, sink);
  }
  EXPECT_EQ(first_fault, "");
}

TEST(ThickLine, RandomLinesToTheEdgeOfTheDomainAreExactUnderAnyClip) {
  int visible = 0;
  for (const int limit : {3000, 100000, 1 << 24, (1 << 28) - (1 << 21)}) {
    oracle::Random random(static_cast<std::uint32_t>(limit));
    const auto within = [&](int bound) { return random.between(-bound, bound); };
    for (int i = 0; i < oracle::samples(1500, 30000); ++i) {
      const Thick t{{within(limit), within(limit)},
                    {within(limit), within(limit)},
                    random.between(0, i % 2 == 0 ? 2500 : 1 << 20),
                    caps[static_cast<std::size_t>(i) % 3]};
      const long along = random.between(0, 1 << 10);
      const int x = static_cast<int>(t.a.x + (long{t.b.x} - t.a.x) * along / (1 << 10)) / 256;
      const int y = static_cast<int>(t.a.y + (long{t.b.y} - t.a.y) * along / (1 << 10)) / 256;
      RecordingSink sink({std::clamp(x - random.between(0, 15), -(1 << 20), (1 << 20) - 20),
                          std::clamp(y - random.between(0, 15), -(1 << 20), (1 << 20) - 20), 20, 20});
      const std::string first = fault(t, sink);
      ASSERT_EQ(first, "") << random.seed_text() << " line " << i;
      const auto writes = sink.all_writes();
      sink.clear();
      ASSERT_TRUE(draw_thick_line(sink, t.b, t.a, t.width, t.cap).ok());
      ASSERT_EQ(sink.all_writes(), writes) << text(t) << " the other way";
      visible += sink.touched() > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(visible, 3000) << "the windows hardly see the lines: the test proves nothing";
}

TEST(ThickLine, AlongADiagonalItIsAsWideAsAlongARow) {
  // 10 wide: 10 pixels down a column, or 10*sqrt(2) = 14.1 along a row across the diagonal, centred on a
  // pixel: 15, where a line thick along one axis only has 10.
  RecordingSink level({50, -20, 1, 40});
  ASSERT_TRUE(draw_thick_line(level, {0, 0}, {100, 0}, 10).ok());
  EXPECT_EQ(level.touched(), 10);
  RecordingSink diagonal({20, 50, 60, 1});
  ASSERT_TRUE(draw_thick_line(diagonal, {0, 0}, {100, 100}, 10).ok());
  EXPECT_EQ(diagonal.touched(), 15);
}

TEST(ThickLine, PixelsMeanTheirCentres) {
  RecordingSink whole({-20, -20, 40, 40});
  RecordingSink fine({-20, -20, 40, 40});
  ASSERT_TRUE(draw_thick_line(whole, {-3, 5}, {12, -7}, 5, Cap::square).ok());
  ASSERT_TRUE(draw_thick_line(fine, SubPoint{-768, 1280}, SubPoint{3072, -1792}, 1280, Cap::square).ok());
  EXPECT_EQ(whole.all_writes(), fine.all_writes());
}

TEST(ThickLine, WithoutLengthASquareCapIsAnUprightSquareAndAButtOneNothing) {
  RecordingSink sink({0, 0, 8, 8});
  ASSERT_TRUE(draw_thick_line(sink, {4, 4}, {4, 4}, 4).ok());
  EXPECT_EQ(sink.touched(), 0);
  ASSERT_TRUE(draw_thick_line(sink, {4, 4}, {4, 4}, 4, Cap::square).ok());
  EXPECT_EQ(sink.touched(), 16);
  EXPECT_EQ(sink.writes(2, 2), 1);
  EXPECT_EQ(sink.writes(5, 5), 1);
}

TEST(ThickLine, ARoundCapIsTheDiscWithoutTheRightmostPixelsOnItsCircle) {
  // 4 wide: the circle passes through the centres of four pixels, of which the left one belongs.
  RecordingSink sink({0, 0, 9, 9});
  ASSERT_TRUE(draw_thick_line(sink, {4, 4}, {4, 4}, 4, Cap::round).ok());
  EXPECT_EQ(
      sink.ascii(),
      ".........\n.........\n.........\n...###...\n..####...\n...###...\n.........\n.........\n.........\n");
}

TEST(ThickLine, HalfAWidthThatEndsInOneHalfIsRoundedAwayFromZero) {
  // Along (3, 4), 10 * n / 256 wide: half of it is (3, 4) * n / 256, all whole; 5 * n: with halves of 1/256.
  RecordingSink sink({-40, -40, 80, 80});
  for (const int n : {1, 3, 511, 513, 1025})
    for (const Cap cap : caps)
      for (const int turn : {1, -1}) EXPECT_EQ(fault({{turn * 768, 1024}, {0, 0}, 5 * n, cap}, sink), "");
}

TEST(ThickLine, TheWidestLineIsDrawn) {
  // Corners half a width out of the domain are refused; along its middle row the widest line just fits.
  RecordingSink sink({-4, -4, 8, 8});
  ASSERT_TRUE(draw_thick_line(sink, {-(1 << 20), 0}, {1 << 20, 0}, 1 << 20).ok());
  EXPECT_EQ(sink.touched(), 64);
  EXPECT_EQ(sink.most(), 1);
  EXPECT_EQ(draw_thick_line(sink, {-(1 << 20), 0}, {1 << 20, 0}, 2, Cap::square),
            (Status{Error::out_of_domain, Argument::point}));
}

TEST(ThickLine, TwiceExclusiveOrRestoresWhatWasThere) {
  std::array<std::uint8_t, 64 * 64> bytes{};
  const auto surface = intaglio::image::Surface<intaglio::image::Indexed8>::over(bytes, {64, 64});
  ASSERT_TRUE(surface.ok());
  const intaglio::raster::Xor<intaglio::image::Indexed8> ink(surface.value(), 7);
  for (int turn = 0; turn < 2; ++turn)
    for (const Point b : {Point{60, 9}, Point{-30, 70}, Point{5, -9}})
      ASSERT_TRUE(draw_thick_line(ink, {5, 5}, b, 9, Cap::square).ok());
  EXPECT_EQ(std::count(bytes.begin(), bytes.end(), 0), 64 * 64);
}

TEST(ThickLine, BadArgumentsAreRefusedAndNothingIsDrawn) {
  RecordingSink sink({-10, -10, 20, 20});
  const Status point{Error::out_of_domain, Argument::point};
  const Status width{Error::out_of_domain, Argument::width};
  for (const int bad : {(1 << 28) + 1, -(1 << 28) - 1, INT_MAX, INT_MIN}) {
    EXPECT_EQ(draw_thick_line(sink, SubPoint{bad, 0}, SubPoint{0, 0}, 256), point);
    EXPECT_EQ(draw_thick_line(sink, SubPoint{0, 0}, SubPoint{0, bad}, 256), point);
    EXPECT_EQ(draw_thick_line(sink, SubPoint{0, 0}, SubPoint{512, 0}, bad), width);
    EXPECT_EQ(draw_thick_line(sink, SubPoint{bad, 0}, SubPoint{0, 0}, 256, Cap::round), point);
    EXPECT_EQ(draw_thick_line(sink, SubPoint{0, 0}, SubPoint{512, 0}, bad, Cap::round), width);
    EXPECT_EQ(draw_thick_line(sink, {bad, 0}, {0, 0}, 1), point);
    EXPECT_EQ(draw_thick_line(sink, {0, 0}, {5, 0}, bad), width);
  }
  EXPECT_EQ(draw_thick_line(sink, {0, 0}, {5, 0}, -1), width);
  EXPECT_EQ(draw_thick_line(sink, {0, 0}, {5, 0}, 1, static_cast<Cap>(3)),
            (Status{Error::out_of_range, Argument::rule}));
  EXPECT_EQ(sink.spans(), 0);
}

}  // namespace
