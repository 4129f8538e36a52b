// SPDX-License-Identifier: MIT
//
// Three ways to fill a polygon give the pixels of the oracle, and for convex ones a fourth.
#include <intaglio/raster/convex.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/polygon_basic.hpp>
#include <intaglio/raster/polygon_critical.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/raster/contours.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace intaglio;
using linear::Rect;
using linear::SubPoint;
using oracle::Contours;
using oracle::RecordingSink;
using raster::fill_convex;
using raster::fill_polygon;
using raster::fill_polygon_basic;
using raster::fill_polygon_critical;
using raster::FillRule;
using raster::PolygonChain;
using raster::PolygonCrossing;
using raster::PolygonEdge;
using tests::text;

constexpr int limit = 1 << 28;

// What is wrong with the pixels that `fill` draws with exactly the workspace that it says it needs.
template <class Entry, class Fill>
std::string difference(const std::vector<int>& expected, const Rect& clip, std::size_t vertices, Fill fill) {
  RecordingSink sink(clip);
  std::vector<Entry> workspace;
  Status status = fill(sink, workspace);
  if (!status.ok()) {
    if (status.error() != Error::too_small || status.argument() != Argument::workspace || sink.spans() != 0)
      return "refused";
    if (status.needed() > vertices) return "needs more than there are vertices";
    workspace.resize(status.needed() - 1);
    if (fill(sink, workspace) != status || sink.spans() != 0) return "one entry less did";
    workspace.resize(status.needed());
    status = fill(sink, workspace);
    if (!status.ok()) return "refused what it asked for";
  }
  if (!sink.violation().empty()) return sink.violation();
  return sink.all_writes() == expected ? "" : "\n" + sink.ascii();
}

// What differs; empty if nothing does.
std::string difference(const Contours& contours, const Rect& clip) {
  const auto [vertices, lengths] = tests::flat(contours);
  const std::size_t count = vertices.size();
  for (const FillRule rule : {FillRule::even_odd, FillRule::non_zero}) {
    const auto expected = oracle::polygon_pixels(contours, rule == FillRule::even_odd, clip);
    const auto fill = [&, &v = vertices, &l = lengths](auto how) {
      return [&, how](auto& sink, auto& workspace) { return how(sink, rule, v, l, workspace); };
    };
    const std::string faults[] = {
        difference<PolygonEdge>(expected, clip, count, fill([](auto&... a) { return fill_polygon(a...); })),
        difference<PolygonCrossing>(expected, clip, count,
                                    fill([](auto&... a) { return fill_polygon_basic(a...); })),
        difference<PolygonChain>(expected, clip, count,
                                 fill([](auto&... a) { return fill_polygon_critical(a...); }))};
    for (const std::string& fault : faults)
      if (!fault.empty()) return text(contours) + " way " + std::to_string(&fault - faults) + ": " + fault;
  }
  return "";
}

TEST(PolygonRungs, RandomSelfIntersectingContoursAreEqualInAnyWindow) {
  oracle::Random random(2151);
  std::string first;
  for (int i = 0; i < oracle::samples(3000, 35000) && first.empty(); ++i) {
    const int step = i % 3 == 0 ? 256 : i % 3 == 1 ? 128 : 1;
    Contours contours;
    for (int n = 0; n <= i % 4; ++n)
      contours.push_back(tests::random_contour(random, random.between(0, 12), 256 << i % 6, step));
    const Rect clip = i % 2 == 0 ? Rect{-17, -17, 35, 35}
                                 : Rect{random.between(-16, 10), random.between(-16, 10),
                                        random.between(0, 12), random.between(0, 12)};
    first = difference(contours, clip);
  }
  EXPECT_EQ(first, "") << random.seed_text();
}

TEST(PolygonRungs, PlateausCollinearRunsAndMinimaOnOneRowAreEqual) {
  oracle::Random random(2152);
  std::string first;
  for (int i = 0; i < oracle::samples(3000, 35000) && first.empty(); ++i) {
    Contours contours;
    for (int n = 0; n <= i % 3; ++n) {
      contours.push_back(tests::random_walk(random, random.between(0, 24)));
      if (i % 2 == 0)  // half a pixel on: between the pixels' centres
        for (SubPoint& p : contours.back()) p = {p.x + 128, p.y + 128};
      if (i % 4 < 2)  // steeper
        for (SubPoint& p : contours.back()) p.y = p.y / 2;
    }
    first = difference(contours, {-1, -1, 11, 11});
  }
  EXPECT_EQ(first, "") << random.seed_text();
}

TEST(PolygonRungs, AreEqualToTheDomainsEdge) {
  oracle::Random random(2153);
  std::string first;
  for (int i = 0; i < oracle::samples(3000, 35000) && first.empty(); ++i) {
    const Contours contours{tests::random_contour(random, random.between(3, 12), limit >> i % 19, 1)};
    first = difference(
        contours, tests::window_on_edge(contours[0][0], contours[0][1], random.between(0, 1024), 14, 11));
  }
  EXPECT_EQ(first, "") << random.seed_text();
}

TEST(PolygonRungs, CriticalPointsNeedTwoEntriesForEachMinimum) {
  // A saw of 50 teeth and a long way back; a ring of 1000 vertices with one minimum.
  std::vector<SubPoint> saw;
  saw.reserve(102);
  for (int i = 0; i < 50; ++i) {
    saw.push_back({i * 512, 0});
    saw.push_back({i * 512 + 256, 2560});
  }
  saw.push_back({50 * 512, 5000});
  saw.push_back({0, 5000});
  std::vector<SubPoint> ring;
  ring.reserve(1000);
  for (int i = 0; i < 500; ++i) ring.push_back({-i * i / 99, i * 20});
  for (int i = 500; i > 0; --i) ring.push_back({i * i / 99, i * 20});
  const auto needed = [](const std::vector<SubPoint>& vertices) {
    RecordingSink sink({-10, -10, 120, 60});
    const std::vector<int> lengths{static_cast<int>(vertices.size())};
    return fill_polygon_critical(sink, FillRule::even_odd, vertices, lengths, {}).needed();
  };
  EXPECT_EQ(needed(saw), 100U);
  EXPECT_EQ(needed(ring), 2U);
  EXPECT_EQ(difference({saw}, {-10, -10, 120, 60}), "");
  EXPECT_EQ(difference({ring}, {-10, -10, 60, 60}), "");
}

TEST(PolygonRungs, BadArgumentsAreNamedAndNothingIsDrawn) {
  RecordingSink sink({0, 0, 20, 20});
  std::vector<PolygonCrossing> crossings(8);
  std::vector<PolygonChain> chains(8);
  std::vector<SubPoint> square{{0, 0}, {2560, 0}, {2560, 2560}, {0, 2560}};
  const auto expect = [&](const std::vector<int>& lengths, FillRule rule, Status status) {
    EXPECT_EQ(fill_polygon_basic(sink, rule, square, lengths, crossings), status);
    EXPECT_EQ(fill_polygon_critical(sink, rule, square, lengths, chains), status);
  };
  expect({5}, FillRule::even_odd, {Error::mismatched, Argument::contours});
  expect({5, -1}, FillRule::even_odd, {Error::mismatched, Argument::contours});
  expect({4}, static_cast<FillRule>(2), {Error::out_of_range, Argument::rule});
  for (const int bad : {limit + 1, -limit - 1, INT_MAX, INT_MIN}) {
    square[2].y = bad;
    expect({4}, FillRule::non_zero, {Error::out_of_domain, Argument::vertices});
    EXPECT_EQ(fill_convex(sink, square), (Status{Error::out_of_domain, Argument::vertices}));
  }
  EXPECT_EQ(sink.spans(), 0);
}

TEST(Convex, EqualsThePolygonFillInAnyWindowEitherWayAround) {
  oracle::Random random(2211);
  int drawn = 0;
  for (int i = 0; i < 4000; ++i) {
    // A convex ring: edges sorted by direction, which then close. Some are level, upright, repeated or empty.
    const int scale = i % 2 == 0 ? 256 : 1 << i % 22;
    const auto part = [&] { return random.between(0, 4) * (i % 3 == 0 ? scale : random.between(0, scale)); };
    struct Step {
      int x, y;
    };
    std::vector<Step> steps;
    for (int n = random.between(1, 6); n > 0; --n) steps.push_back({part(), part()});
    std::erase_if(steps, [](const Step& s) { return s.x == 0 && s.y == 0; });
    std::sort(steps.begin(), steps.end(),
              [](const Step& a, const Step& b) { return std::int64_t{a.y} * b.x < std::int64_t{b.y} * a.x; });
    // Down to the right in steps that get steeper, and back the same way turned around: a convex lens.
    SubPoint p{random.between(-9 * 256, 0), random.between(-9 * 256, 0)};
    std::vector<SubPoint> ring;
    for (const Step& s : steps) {
      ring.push_back(p);
      p = {p.x + s.x, p.y + s.y};
    }
    for (const Step& s : steps) {
      ring.push_back(p);
      p = {p.x - s.x, p.y - s.y};
    }
    if (i % 2 != 0)
      for (SubPoint& q : ring) q.x = -q.x;
    if (ring.empty()) continue;
    if (i % 5 == 0) ring.insert(ring.begin() + 1, ring[0]);
    std::rotate(ring.begin(), ring.begin() + random.between(0, static_cast<int>(ring.size()) - 1),
                ring.end());
    for (int way = 0; way < 2; ++way) {
      ASSERT_TRUE(raster::is_convex(ring)) << text({ring}) << random.seed_text();
      const Rect clip = i % 3 == 0 ? Rect{-3, -4, 9, 8} : Rect{-30, -30, 60, 60};
      RecordingSink expected(clip);
      std::vector<PolygonEdge> workspace(ring.size());
      ASSERT_TRUE(fill_polygon(expected, FillRule::non_zero, ring, workspace).ok());
      RecordingSink sink(clip);
      ASSERT_TRUE(fill_convex(sink, ring).ok());
      ASSERT_EQ(sink.violation(), "");
      ASSERT_EQ(sink.all_writes(), expected.all_writes())
          << random.seed_text() << ": " << text({ring}) << "\n"
          << sink.ascii() << "expected\n"
          << expected.ascii();
      drawn += expected.touched() > 0 ? 1 : 0;
      std::reverse(ring.begin(), ring.end());
    }
  }
  EXPECT_GT(drawn, 2000);
}

TEST(Convex, TrianglesToTheDomainsEdgeAreEqual) {
  oracle::Random random(2212);
  for (int i = 0; i < 3000; ++i) {
    const int bound = limit >> i % 20;
    std::vector<SubPoint> triangle;
    triangle.reserve(3);
    for (int k = 0; k < 3; ++k)
      triangle.push_back(
          {random.between(-1, 1) * (bound - random.between(0, 300)), random.between(-bound, bound)});
    const int x = static_cast<int>((std::int64_t{triangle[0].x} + triangle[1].x) / 512);
    const int y = static_cast<int>((std::int64_t{triangle[0].y} + triangle[1].y) / 512);
    const Rect clip{x - 8, y - 7, 17, 15};
    int wrong = 0;
    RecordingSink sink(clip);
    ASSERT_TRUE(fill_convex(sink, triangle).ok());
    for (int py = clip.y; py < clip.bottom(); ++py)
      for (int px = clip.x; px < clip.right(); ++px)
        wrong += sink.writes(px, py) ==
                         (oracle::in_triangle(triangle[0], triangle[1], triangle[2], px, py) ? 1 : 0)
                     ? 0
                     : 1;
    ASSERT_EQ(wrong, 0) << random.seed_text() << ": " << text({triangle});
  }
}

TEST(Convex, DentsStarsAndSecondRoundsAreRefused) {
  RecordingSink sink({-20, -20, 60, 60});
  const Status malformed{Error::malformed, Argument::vertices};
  const std::vector<SubPoint> dent{{0, 0}, {2560, 0}, {1280, 1000}, {2560, 2560}, {0, 2560}};
  const std::vector<SubPoint> star{{5120, 256}, {7936, 9216}, {512, 3584}, {9984, 3584}, {2304, 9216}};
  const std::vector<SubPoint> twice{{0, 0}, {2560, 0}, {2560, 2560}, {0, 2560},
                                    {0, 0}, {2560, 0}, {2560, 2560}, {0, 2560}};
  const std::vector<SubPoint> spike{{0, 0}, {2560, 0}, {5120, 0}, {2560, 0}, {2560, 2560}};
  const std::vector<SubPoint> bow{{0, 0}, {2560, 2560}, {2560, 0}, {0, 2560}};
  for (const auto* contour : {&dent, &star, &twice, &spike, &bow}) {
    EXPECT_EQ(fill_convex(sink, *contour), malformed);
    EXPECT_EQ(fill_convex(sink, std::vector<SubPoint>(contour->rbegin(), contour->rend())), malformed);
  }
  // No area is convex and empty.
  EXPECT_TRUE(fill_convex(sink, {}).ok());
  EXPECT_TRUE(fill_convex(sink, std::vector<SubPoint>{{5, 5}}).ok());
  EXPECT_TRUE(fill_convex(sink, std::vector<SubPoint>{{0, 0}, {2560, 2560}, {1280, 1280}}).ok());
  EXPECT_EQ(sink.spans(), 0);
}

}  // namespace
