// SPDX-License-Identifier: MIT
#include <intaglio/image/surface.hpp>
#include <intaglio/raster/dash.hpp>
#include <intaglio/raster/solid.hpp>
#include <tests/oracle/line.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/raster/fault.hpp>
#include <tests/raster/text.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::raster::draw_dashed_line;
using oracle::RecordingSink;

struct Dashes {
  Point a, b;
  int on, off;
};

std::string text(const Dashes& d, const Rect& clip) {
  return tests::text(d.a) + "-" + tests::text(d.b) + " " + std::to_string(d.on) + "/" +
         std::to_string(d.off) + " in " + tests::text(clip);
}

// What is wrong in this window; empty if each pixel of a dash is drawn once and no other.
std::string fault(const Dashes& d, RecordingSink& sink) {
  sink.clear();
  return tests::fault(
      draw_dashed_line(sink, d.a, d.b, d.on, d.off), sink, [&] { return text(d, sink.clip()); },
      [&](int x, int y) { return oracle::on_dash(d.a.x, d.a.y, d.b.x, d.b.y, d.on, d.off, x, y); });
}

TEST(Dash, EveryShortLineAndPatternInEveryWindowIsExact) {
  std::string first_fault;
  for (const Rect clip : {Rect{-6, -6, 13, 13}, Rect{-2, -1, 4, 3}, Rect{1, -3, 2, 7}, Rect{2, 2, 1, 1}}) {
    RecordingSink sink(clip);
    for (int dy = -6; dy <= 6; ++dy)
      for (int dx = -6; dx <= 6; ++dx)
        for (int on = 1; on <= 4; ++on)
          for (int off = 0; off <= 3 && first_fault.empty(); ++off)
            for (const Point a : {Point{0, 0}, Point{-3, 2}})
              if (first_fault.empty()) first_fault = fault({a, {a.x + dx, a.y + dy}, on, off}, sink);
  }
  EXPECT_EQ(first_fault, "");
}

TEST(Dash, RandomLinesToTheEdgeOfTheDomainKeepTheirPhaseUnderAnyClip) {
  int visible = 0;
  for (const int limit : {40, 3000, 1 << 20}) {
    oracle::Random random(static_cast<std::uint32_t>(limit));
    const auto within = [&](int bound) { return random.between(-bound, bound); };
    for (int i = 0; i < 2000; ++i) {
      Dashes d{{within(limit), within(limit)}, {within(limit), within(limit)}, 1, 0};
      if (i % 6 == 1) d.b.y = d.a.y;
      if (i % 6 == 2) d.b.x = d.a.x;
      const int longest = i % 5 == 0 ? 1 << 20 : 12;
      d.on = random.between(1, longest);
      d.off = random.between(0, longest);
      const long t = within(1 << 10) + (1 << 10);
      const int x = static_cast<int>(d.a.x + (long{d.b.x} - d.a.x) * t / (1 << 11));
      const int y = static_cast<int>(d.a.y + (long{d.b.y} - d.a.y) * t / (1 << 11));
      const int width = random.between(1, 20);
      const int height = random.between(1, 20);
      RecordingSink sink({std::clamp(x - random.between(0, 15), -(1 << 20), (1 << 20) - width),
                          std::clamp(y - random.between(0, 15), -(1 << 20), (1 << 20) - height), width,
                          height});
      ASSERT_EQ(fault(d, sink), "") << random.seed_text() << " line " << i;
      visible += sink.touched() > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(visible, 1000) << "the windows hardly see the lines: the test proves nothing";
}

TEST(Dash, OneOneAlongARowIsDotted) {  // H19: solid in LVGL
  RecordingSink sink({0, 0, 10, 1});
  ASSERT_TRUE(draw_dashed_line(sink, {0, 0}, {9, 0}, 1, 1).ok());
  EXPECT_EQ(sink.ascii(), "#.#.#.#.#.\n");
}

TEST(Dash, PhaseStartsAtTheFirstPoint) {
  RecordingSink sink({0, 0, 10, 1});
  ASSERT_TRUE(draw_dashed_line(sink, {0, 0}, {8, 0}, 4, 2).ok());
  EXPECT_EQ(sink.ascii(), "####..###.\n");
  sink.clear();
  ASSERT_TRUE(draw_dashed_line(sink, {8, 0}, {0, 0}, 4, 2).ok());
  EXPECT_EQ(sink.ascii(), "###..####.\n");
}

TEST(Dash, WorkIsBoundedByTheVisiblePixels) {  // H24: a hang over 99,999,999 pixels
  RecordingSink sink({0, 0, 32, 32});
  for (int i = 0; i < 100000; ++i) {
    sink.clear();
    ASSERT_TRUE(draw_dashed_line(sink, {-(1 << 20), -(1 << 20) + i}, {1 << 20, 1 << 20}, 1, i % 3).ok());
    ASSERT_LE(sink.spans(), 32);
  }
  EXPECT_EQ(draw_dashed_line(sink, {0, 0}, {99999999, 0}, 1, 1),
            (Status{Error::out_of_domain, Argument::point}));
}

TEST(Dash, TwiceExclusiveOrRestoresWhatWasThere) {
  std::array<std::uint8_t, 64 * 64> bytes{};
  const auto surface = intaglio::image::Surface<intaglio::image::Indexed8>::over(bytes, {64, 64});
  ASSERT_TRUE(surface.ok());
  const intaglio::raster::Xor<intaglio::image::Indexed8> ink(surface.value(), 7);
  for (int turn = 0; turn < 2; ++turn)
    for (const Point b : {Point{60, 9}, Point{-30, 70}, Point{63, 5}, Point{5, -9}})
      ASSERT_TRUE(draw_dashed_line(ink, {5, 5}, b, 3, 4).ok());
  EXPECT_EQ(std::count(bytes.begin(), bytes.end(), 0), 64 * 64);
}

TEST(Dash, BadArgumentsAreRefusedAndNothingIsDrawn) {
  RecordingSink sink({-10, -10, 20, 20});
  for (const int bad : {(1 << 20) + 1, -(1 << 20) - 1, INT_MAX, INT_MIN}) {
    const Status point{Error::out_of_domain, Argument::point};
    const Status steps{Error::out_of_range, Argument::steps};
    EXPECT_EQ(draw_dashed_line(sink, {bad, 0}, {0, 0}, 1, 1), point);
    EXPECT_EQ(draw_dashed_line(sink, {0, 0}, {0, bad}, 1, 1), point);
    EXPECT_EQ(draw_dashed_line(sink, {0, 0}, {5, 0}, bad, 1), steps);
    EXPECT_EQ(draw_dashed_line(sink, {0, 0}, {5, 0}, 1, bad), steps);
    EXPECT_EQ(draw_dashed_line(sink, {0, 0}, {5, 0}, 0, 1), steps);
  }
  EXPECT_EQ(sink.spans(), 0);
}

TEST(Dash, AnEmptyClipDrawsNothing) {
  RecordingSink sink({0, 0, 0, 0});
  EXPECT_TRUE(draw_dashed_line(sink, {-5, -5}, {5, 5}, 2, 1).ok());
  EXPECT_TRUE(draw_dashed_line(sink, {-5, 0}, {5, 0}, 2, 1).ok());
  EXPECT_EQ(sink.spans(), 0);
}

}  // namespace
