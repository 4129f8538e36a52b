// SPDX-License-Identifier: MIT
#include <intaglio/raster/line.hpp>
#include <tests/oracle/line.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/raster/fault.hpp>
#include <tests/raster/text.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Rect;
using intaglio::linear::SubPoint;
using intaglio::raster::draw_line;
using oracle::RecordingSink;

std::string text(SubPoint a, SubPoint b, const Rect& clip) {
  return tests::text(a) + "-" + tests::text(b) + " in " + tests::text(clip);
}

// What is wrong in this window; empty if each pixel of the line is drawn once, and no other, both ways round.
std::string fault(SubPoint a, SubPoint b, RecordingSink& sink) {
  const auto drawn = [&](SubPoint from, SubPoint to) {
    sink.clear();
    return tests::fault(
        draw_line(sink, from, to), sink, [&] { return text(from, to, sink.clip()); },
        [&](int x, int y) { return oracle::on_sub_line(a.x, a.y, b.x, b.y, x, y); });
  };
  const std::string forwards = drawn(a, b);
  return forwards.empty() ? drawn(b, a) : forwards;
}

TEST(SubLine, EveryLineBetweenEighthsOfAPixelIsExactInEveryWindow) {
  std::string first_fault;
  for (const Rect clip : {Rect{-4, -4, 9, 9}, Rect{-1, 0, 2, 2}, Rect{0, 0, 1, 1}, Rect{-1, 1, 3, 1}}) {
    RecordingSink sink(clip);
    for (int from = 0; from < 8 * 8; ++from)
      for (int dy = -20; dy <= 20; ++dy)
        for (int dx = -20; dx <= 20 && first_fault.empty(); dx += 1 + (dy & 1)) {
          const SubPoint a{from % 8 * 32, from / 8 * 32};
          first_fault = fault(a, {a.x + dx * 32, a.y + dy * 32}, sink);
        }
  }
  EXPECT_EQ(first_fault, "");
}

TEST(SubLine, EveryTinyLineRoundATieIsExact) {
  // Shorter than a pixel, with ends one unit either side of where rounding changes.
  std::string first_fault;
  RecordingSink sink({-2, -2, 5, 5});
  const int ticks[] = {-129, -128, -127, -1, 0, 1, 127, 128, 129, 255, 256};
  for (const int x0 : ticks)
    for (const int y0 : ticks)
      for (const int x1 : ticks)
        for (const int y1 : ticks)
          if (first_fault.empty()) first_fault = fault({x0, y0}, {x1, y1}, sink);
  EXPECT_EQ(first_fault, "");
}

TEST(SubLine, RandomLinesToTheEdgeOfTheDomainAreExactUnderAnyClip) {
  int visible = 0;
  for (const int limit : {2000, 100000, 1 << 24, 1 << 28}) {
    oracle::Random random(static_cast<std::uint32_t>(limit));
    const auto within = [&](int bound) { return random.between(-bound, bound); };
    for (int i = 0; i < oracle::samples(2500, 50000); ++i) {
      SubPoint a{within(limit), within(limit)};
      SubPoint b{within(limit), within(limit)};
      if (i % 8 == 1) b.y = std::clamp(a.y + within(300), -limit, limit);
      if (i % 8 == 2) b.x = std::clamp(a.x + within(300), -limit, limit);
      if (i % 8 == 3) b.x = std::clamp(a.x + (b.y - a.y) + within(1), -limit, limit);
      const long t = i % 3 == 0 ? 0 : within(1 << 10) + (1 << 10);
      const int x = static_cast<int>(a.x + (long{b.x} - a.x) * t / (1 << 11)) / 256;
      const int y = static_cast<int>(a.y + (long{b.y} - a.y) * t / (1 << 11)) / 256;
      const int width = random.between(1, 20);
      const int height = random.between(1, 20);
      RecordingSink sink({std::clamp(x - random.between(0, 15), -(1 << 20), (1 << 20) - width),
                          std::clamp(y - random.between(0, 15), -(1 << 20), (1 << 20) - height), width,
                          height});
      ASSERT_EQ(fault(a, b, sink), "") << random.seed_text() << " line " << i;
      visible += sink.touched() > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(visible, oracle::samples(4000, 80000))
      << "the windows hardly see the lines: the test proves nothing";
}

TEST(SubLine, OnWholePixelsItIsTheLineBetweenPixels) {
  std::string first_fault;
  const Rect clip{-9, -9, 16, 19};
  for (int dy = -24; dy <= 24; ++dy)
    for (int dx = -24; dx <= 24 && first_fault.empty(); ++dx) {
      RecordingSink whole(clip);
      RecordingSink fine(clip);
      ASSERT_TRUE(draw_line(whole, {-3, 2}, {dx, dy}).ok());
      ASSERT_TRUE(draw_line(fine, SubPoint{-768, 512}, SubPoint{dx * 256, dy * 256}).ok());
      if (whole.all_writes() != fine.all_writes()) first_fault = whole.ascii() + "\n" + fine.ascii();
    }
  EXPECT_EQ(first_fault, "");
}

TEST(SubLine, WorkIsBoundedByTheVisiblePixels) {
  RecordingSink sink({0, 0, 32, 32});
  for (int i = 0; i < 100000; ++i) {
    sink.clear();
    ASSERT_TRUE(draw_line(sink, SubPoint{-(1 << 28), -(1 << 28) + 255 * i}, SubPoint{1 << 28, 1 << 28}).ok());
    ASSERT_LE(sink.spans(), 32);
  }
}

TEST(SubLine, EndsOutsideTheDomainAreRefusedAndNothingIsDrawn) {
  RecordingSink sink({-10, -10, 20, 20});
  for (const int bad : {(1 << 28) + 1, -(1 << 28) - 1, INT_MAX, INT_MIN}) {
    const Status refused{Error::out_of_domain, Argument::point};
    EXPECT_EQ(draw_line(sink, SubPoint{bad, 0}, SubPoint{0, 0}), refused);
    EXPECT_EQ(draw_line(sink, SubPoint{0, bad}, SubPoint{0, 0}), refused);
    EXPECT_EQ(draw_line(sink, SubPoint{0, 0}, SubPoint{bad, 0}), refused);
    EXPECT_EQ(draw_line(sink, SubPoint{0, 0}, SubPoint{0, bad}), refused);
  }
  EXPECT_EQ(sink.spans(), 0);
}

TEST(SubLine, AnEmptyClipDrawsNothing) {
  RecordingSink sink({0, 0, 0, 0});
  EXPECT_TRUE(draw_line(sink, SubPoint{-500, -500}, SubPoint{500, 520}).ok());
  EXPECT_EQ(sink.spans(), 0);
}

}  // namespace
