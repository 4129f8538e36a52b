// SPDX-License-Identifier: MIT
#include <intaglio/image/surface.hpp>
#include <intaglio/raster/polyline.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/raster/thick_line.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/oracle/stroke.hpp>
#include <tests/raster/fault.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::SubPoint;
using intaglio::raster::Cap;
using intaglio::raster::draw_polyline;
using intaglio::raster::draw_thick_line;
using intaglio::raster::Join;
using intaglio::raster::polyline_workspace;
using intaglio::raster::Stroke;
using intaglio::raster::StrokeEdge;
using oracle::Contour;
using oracle::RecordingSink;
using oracle::StrokeArea;

constexpr std::array caps{Cap::butt, Cap::square, Cap::round};
constexpr std::array joins{Join::miter, Join::bevel, Join::round};
constexpr int edge = 1 << 28;

std::string text(const Contour& points, const Stroke& stroke) {
  std::string out = "width " + std::to_string(stroke.width) + " join " +
                    std::to_string(static_cast<int>(stroke.join)) + " cap " +
                    std::to_string(static_cast<int>(stroke.cap)) + " limit " +
                    std::to_string(stroke.miter_limit) + (stroke.closed ? " closed:" : " open:");
  for (const SubPoint p : points) out += " " + std::to_string(p.x) + "," + std::to_string(p.y);
  return out;
}

// What is wrong with a stroke in the sink's window; empty if it has exactly its pixels, once each.
std::string fault(const Contour& points, const Stroke& stroke, RecordingSink& sink) {
  sink.clear();
  const StrokeArea area(points, stroke);
  std::vector<StrokeEdge> workspace(10 * points.size() + 4);
  return tests::fault(
      draw_polyline(sink, points, stroke, workspace), sink, [&] { return text(points, stroke); },
      [&](int x, int y) { return area.holds(x, y); });
}

TEST(Polyline, EveryTurnOnASmallGridIsExact) {
  RecordingSink sink({-8, -8, 17, 17});
  std::string first;
  int turn = 0;
  for (int by = -3; by <= 3; ++by)
    for (int bx = -3; bx <= 3; ++bx)
      for (int cy = -3; cy <= 3; ++cy)
        for (int cx = -3; cx <= 3 && first.empty(); ++cx) {
          ++turn;
          for (const Join join : joins) {
            const int unit = turn % 3 == 0 ? 200 : 256;
            const Contour points{{0, 0}, {bx * unit, by * unit}, {cx * unit, cy * unit}};
            const int widths[] = {512, 1, 700, 1280, 256};
            if (first.empty())
              first = fault(points,
                            {.width = widths[turn % 5],
                             .join = join,
                             .cap = caps[static_cast<std::size_t>(turn) / 5 % 3],
                             .closed = turn % 4 == 0},
                            sink);
          }
        }
  EXPECT_EQ(first, "");
}

// Points near a middle, often repeated, in line with others or next to it.
Contour random_points(oracle::Random& random, int reach, SubPoint middle) {
  Contour points;
  const int count = random.between(1, 7);
  while (static_cast<int>(points.size()) < count) {
    SubPoint p{middle.x + random.between(-reach, reach), middle.y + random.between(-reach, reach)};
    const int kind = random.between(0, 9);
    if (kind < 3) p = {p.x & ~255, p.y & ~255};
    if (!points.empty() && kind == 4) p = points.back();
    if (points.size() > 1 && kind >= 7) {
      // Straight on, straight back, or off that by the last place.
      const SubPoint a = points[points.size() - 2];
      const SubPoint b = points.back();
      const int off = kind == 9 ? 1 : 0;
      const int way = random.between(-1, 1);
      p = {b.x + way * (b.x - a.x) / 2 + off, b.y + way * (b.y - a.y) / 2};
    }
    constexpr int room = edge - (1 << 21);
    points.push_back({std::clamp(p.x, -room, room), std::clamp(p.y, -room, room)});
  }
  return points;
}

TEST(Polyline, RandomOnesAreExactToTheDomainsEdgeFromEitherEnd) {
  int visible = 0;
  int miters = 0;
  for (const int reach : {600, 3000, 60000, 1 << 22, 1 << 27}) {
    oracle::Random random(static_cast<std::uint32_t>(reach));
    const int count = oracle::samples(700, 20000);
    for (int i = 0; i < count; ++i) {
      const int room = edge - reach;
      const SubPoint middle{random.between(-1, 1) * (i % 2 == 0 ? 256 : room),
                            random.between(-1, 1) * (i % 2 == 0 ? 256 : room)};
      Contour points = random_points(random, reach, middle);
      const Stroke stroke{.width = random.between(0, 1 << random.between(1, 14)),
                          .join = joins[static_cast<std::size_t>(random.between(0, 2))],
                          .cap = caps[static_cast<std::size_t>(random.between(0, 2))],
                          .closed = random.between(0, 1) != 0,
                          .miter_limit = random.between(256, 4096)};
      const SubPoint centre = points[static_cast<std::size_t>(i) % points.size()];
      RecordingSink sink({centre.x / 256 - random.between(0, 24), centre.y / 256 - random.between(0, 24),
                          random.between(1, 24), random.between(1, 24)});
      ASSERT_EQ(fault(points, stroke, sink), "") << random.seed_text() << " stroke " << i;
      visible += sink.touched() > 0 ? 1 : 0;
      miters += StrokeArea(points, stroke).miters();
      const auto writes = sink.all_writes();
      sink.clear();
      std::reverse(points.begin(), points.end());
      // The least workspace that will do; with less, nothing is drawn.
      const auto needed = polyline_workspace(points, stroke, sink.clip());
      ASSERT_TRUE(needed.ok());
      ASSERT_LE(needed.value(), 10 * points.size() + 4);
      std::vector<StrokeEdge> workspace(needed.value());
      if (!workspace.empty()) {
        ASSERT_EQ(draw_polyline(sink, points, stroke, std::span(workspace).subspan(1)),
                  (Status{Error::too_small, Argument::workspace, needed.value()}));
        ASSERT_EQ(sink.spans(), 0);
      }
      ASSERT_TRUE(draw_polyline(sink, points, stroke, workspace).ok());
      ASSERT_EQ(sink.all_writes(), writes) << text(points, stroke) << " from the other end";
    }
  }
  EXPECT_GT(visible, 1000) << "the windows hardly see the strokes: the test proves nothing";
  EXPECT_GT(miters, 1000);
}

TEST(Polyline, ASegmentIsTheThickLineWithTheSameCaps) {
  oracle::Random random(5);
  RecordingSink stroke({-20, -20, 40, 40});
  RecordingSink line({-20, -20, 40, 40});
  std::vector<StrokeEdge> workspace(8);
  for (int i = 0; i < 300; ++i) {
    const SubPoint a{random.between(-4000, 4000), random.between(-4000, 4000)};
    const SubPoint b{random.between(-4000, 4000), random.between(-4000, 4000)};
    const int width = random.between(0, 3000);
    for (const Cap cap : caps) {
      stroke.clear();
      line.clear();
      ASSERT_TRUE(draw_polyline(stroke, std::array{a, a, b}, {.width = width, .cap = cap}, workspace).ok());
      ASSERT_TRUE(draw_thick_line(line, a, b, width, cap).ok());
      ASSERT_EQ(stroke.all_writes(), line.all_writes()) << text({a, b}, {.width = width, .cap = cap});
    }
  }
}

TEST(Polyline, ASquareOfLevelAndUprightSegmentsHasTheExpectedPixels) {
  // A 10 by 10 square around pixel centres, 4 wide: outside 14 by 14, a hole of 6 by 6; a bevel or an arc
  // cuts corners off.
  const Contour square{{0, 0}, {2560, 0}, {2560, 2560}, {0, 2560}};
  std::vector<StrokeEdge> workspace(40);
  const auto pixels = [&](Join join, bool closed) {
    RecordingSink sink({-10, -10, 40, 40});
    EXPECT_TRUE(draw_polyline(sink, square, {.width = 1024, .join = join, .closed = closed}, workspace).ok());
    EXPECT_EQ(sink.most(), 1);
    return sink.touched();
  };
  EXPECT_EQ(pixels(Join::miter, true), 14 * 14 - 6 * 6);
  EXPECT_EQ(pixels(Join::miter, false), 2 * 12 * 4 + 6 * 4);
  EXPECT_LT(pixels(Join::bevel, true), pixels(Join::round, true));
  EXPECT_LT(pixels(Join::round, true), pixels(Join::miter, true));
}

TEST(Polyline, AMiterBecomesABevelAtItsLimit) {
  // Half a right angle: the tip is 1 / sin(22.5 degrees) = 2.613 half widths away.
  const Contour corner{{0, 0}, {5120, 0}, {0, 5120}};
  RecordingSink sink({-10, -20, 80, 60});
  std::vector<StrokeEdge> workspace(20);
  const auto pixels = [&](Join join, int limit) {
    sink.clear();
    EXPECT_TRUE(
        draw_polyline(sink, corner, {.width = 2048, .join = join, .miter_limit = limit}, workspace).ok());
    return sink.touched();
  };
  EXPECT_EQ(pixels(Join::miter, 668), pixels(Join::bevel, 256));
  EXPECT_GT(pixels(Join::miter, 670), pixels(Join::bevel, 256));
  EXPECT_EQ(pixels(Join::miter, 670), pixels(Join::miter, 4096));
}

TEST(Polyline, WithoutLengthItHasOnlyItsCaps) {
  RecordingSink sink({-10, -10, 20, 20});
  for (const bool closed : {false, true})
    for (const Cap cap : caps)
      for (const std::size_t repeats : {1U, 2U, 5U})
        EXPECT_EQ(
            fault(Contour(repeats, SubPoint{100, 60}), {.width = 1500, .cap = cap, .closed = closed}, sink),
            "");
  std::vector<StrokeEdge> workspace(1);
  sink.clear();
  EXPECT_TRUE(draw_polyline(sink, Contour{}, {}, workspace).ok());
  EXPECT_EQ(sink.spans(), 0);
}

TEST(Polyline, TurningBackAddsOnlyARoundJoin) {
  const Contour hairpin{{0, 0}, {2560, 0}, {1024, 0}};
  std::vector<StrokeEdge> workspace(20);
  const auto pixels = [&](Join join) {
    RecordingSink sink({-10, -10, 40, 20});
    EXPECT_TRUE(draw_polyline(sink, hairpin, {.width = 1024, .join = join}, workspace).ok());
    return sink.touched();
  };
  EXPECT_EQ(pixels(Join::miter), 40);
  EXPECT_EQ(pixels(Join::bevel), 40);
  // Right of the way's end, half of the disc of 4: 1, 2 and, halfway to nothing, no third column.
  EXPECT_EQ(pixels(Join::round), 46);
}

TEST(Polyline, EnormousWidthsAreExact) {
  // Along (3, 4) half a width of 5 n is (3 n, 4 n) / 2 without a root.
  RecordingSink sink({-12, -12, 24, 24});
  for (const Join join : joins)
    for (const Cap cap : caps)
      for (const int n : {1 << 20, (1 << 23) - 1, 1 << 25}) {
        const Stroke stroke{.width = 5 * n, .join = join, .cap = cap};
        // Its lower right side passes through the window's middle.
        const int x = -2 * n;
        const int y = 3 * n / 2;
        EXPECT_EQ(fault({{x - 300, y - 400}, {x, y}, {x + 3 * 999, y + 4 * 999}}, stroke, sink), "");
        EXPECT_EQ(fault({{x, y}, {x + 300, y + 400}, {x + 1300, y + 400}}, stroke, sink), "");
      }
  std::vector<StrokeEdge> workspace(16);
  sink.clear();
  const Contour axis{{-edge, 0}, {edge, 0}};
  EXPECT_TRUE(draw_polyline(sink, axis, {.width = edge, .cap = Cap::round}, workspace).ok());
  EXPECT_EQ(sink.touched(), 24 * 24);
}

TEST(Polyline, WhatIsOutsideTheClipNeedsNoWorkspace) {
  Contour zigzag;
  for (int i = 0; i < 100; ++i) zigzag.push_back({i * 5000 + 1000, i % 2 * 9000});
  const Stroke stroke{.width = 900, .join = Join::round, .cap = Cap::round};
  EXPECT_EQ(polyline_workspace(zigzag, stroke, {0, -100, 4000, 90}).value(), 0U);
  EXPECT_EQ(polyline_workspace(zigzag, stroke, {-200, 0, 190, 90}).value(), 0U);
  EXPECT_EQ(polyline_workspace(zigzag, stroke, {4000, 0, 190, 90}).value(), 0U);
  EXPECT_EQ(polyline_workspace(zigzag, stroke, {0, 50, 4000, 90}).value(), 0U);
  EXPECT_LE(polyline_workspace(zigzag, stroke, {1000, 0, 10, 90}).value(), 20U);
  EXPECT_EQ(polyline_workspace(zigzag, stroke, {0, 0, 1 << 23, 1}).status().argument(), Argument::rectangle);
}

TEST(Polyline, TwiceExclusiveOrRestoresWhatWasThere) {
  std::array<std::uint8_t, 64 * 64> bytes{};
  const auto surface = intaglio::image::Surface<intaglio::image::Indexed8>::over(bytes, {64, 64});
  ASSERT_TRUE(surface.ok());
  const intaglio::raster::Xor<intaglio::image::Indexed8> ink(surface.value(), 7);
  const Contour star{{8000, 300}, {12000, 15000}, {500, 5500}, {15800, 5600}, {3500, 14800}};
  std::vector<StrokeEdge> workspace(60);
  for (int turn = 0; turn < 2; ++turn)
    for (const Join join : joins)
      ASSERT_TRUE(
          draw_polyline(ink, star, {.width = 2500, .join = join, .closed = turn >= 0}, workspace).ok());
  EXPECT_EQ(std::count(bytes.begin(), bytes.end(), 0), 64 * 64);
}

TEST(Polyline, BadArgumentsAreRefusedAndNothingIsDrawn) {
  RecordingSink sink({-10, -10, 20, 20});
  std::vector<StrokeEdge> workspace(30);
  const Status vertices{Error::out_of_domain, Argument::vertices};
  const Status width{Error::out_of_domain, Argument::width};
  const Status rule{Error::out_of_range, Argument::rule};
  const Status limit{Error::out_of_range, Argument::limit};
  const auto draw = [&](const Contour& points, const Stroke& stroke) {
    return draw_polyline(sink, points, stroke, workspace);
  };
  const Contour good{{0, 0}, {512, 0}, {512, 512}};
  for (const int bad : {edge + 1, -edge - 1, INT_MAX, INT_MIN}) {
    EXPECT_EQ(draw({{bad, 0}, {0, 0}}, {}), vertices);
    EXPECT_EQ(draw({{0, 0}, {0, bad}}, {}), vertices);
    EXPECT_EQ(draw({{0, 0}, {0, 5}, {5, bad}}, {}), vertices);
    EXPECT_EQ(draw(good, {.width = bad}), width);
    EXPECT_EQ(draw(good, {.miter_limit = bad}), limit);
  }
  EXPECT_EQ(draw(good, {.width = -1}), width);
  EXPECT_EQ(draw(good, {.join = static_cast<Join>(3)}), rule);
  EXPECT_EQ(draw(good, {.cap = static_cast<Cap>(3)}), rule);
  EXPECT_EQ(draw(good, {.miter_limit = 255}), limit);
  EXPECT_EQ(draw(good, {.miter_limit = 4097}), limit);
  // A corner, and the tip of a miter, beyond the domain.
  EXPECT_EQ(draw({{0, edge}, {512, edge}}, {.width = 512}), vertices);
  const Contour sharp{{edge - 5120, 0}, {edge - 2048, 512}, {edge - 5120, 1024}};
  EXPECT_EQ(draw(sharp, {.width = 1024, .miter_limit = 4096}), vertices);
  EXPECT_EQ(sink.spans(), 0);
  EXPECT_TRUE(draw(sharp, {.width = 1024}).ok());
  // So enormous that the tip leaves all integers, but not the limit.
  const Contour needle{{-1000, 0}, {0, 1}, {-1000, 2}};
  EXPECT_EQ(draw(needle, {.width = 1 << 27, .join = Join::bevel}).ok(), true);
  EXPECT_EQ(draw({{0, 0}, {1000, 0}, {0, 130}}, {.width = 1 << 27, .miter_limit = 4096}), vertices);
}

}  // namespace
