// SPDX-License-Identifier: MIT
#include <intaglio/raster/triangle.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/raster/text.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::linear::SubPoint;
using intaglio::raster::fill_triangle;
using oracle::RecordingSink;
using tests::text;

constexpr int limit = 1 << 28;

// What is wrong with the triangle in this window; empty if nothing is.
std::string fault(SubPoint a, SubPoint b, SubPoint c, const Rect& clip) {
  const std::string what = text(a) + text(b) + text(c) + " in " + text(clip);
  RecordingSink sink(clip);
  const Status status = fill_triangle(sink, a, b, c);
  if (!status.ok()) return what + ": refused";
  if (!sink.violation().empty()) return what + ": " + sink.violation();
  for (int y = clip.y; y < clip.bottom(); ++y)
    for (int x = clip.x; x < clip.right(); ++x)
      if (sink.writes(x, y) != (oracle::in_triangle(a, b, c, x, y) ? 1 : 0))
        return what + ": pixel " + std::to_string(x) + "," + std::to_string(y) + " drawn " +
               std::to_string(sink.writes(x, y)) + " times\n" + sink.ascii();
  return "";
}

TEST(TriangleOracle, EdgeFunctionsAgreeWithWindingNumbers) {
  std::mt19937 random(40);
  std::uniform_int_distribution<int> coordinate(0, 12);
  for (int i = 0; i < 3000; ++i) {
    const auto point = [&] { return SubPoint{coordinate(random) * 64, coordinate(random) * 64}; };
    const SubPoint a = point();
    const SubPoint b = point();
    const SubPoint c = point();
    for (int y = -1; y <= 4; ++y)
      for (int x = -1; x <= 4; ++x)
        ASSERT_EQ(oracle::in_triangle(a, b, c, x, y), oracle::in_polygon({{a, b, c}}, false, x, y))
            << text(a) << text(b) << text(c);
  }
}

TEST(Triangle, EveryTriangleOnASmallGridIsExactInAnyOrderOfItsVertices) {
  std::string first_fault;
  for (int i = 0; i < 5 * 5 * 5 * 5 * 5 * 5 && first_fault.empty(); ++i) {
    const auto digit = [i](int place) {
      int n = i;
      while (place-- > 0) n /= 5;
      return n % 5 * 256;
    };
    first_fault = fault({digit(0), digit(1)}, {digit(2), digit(3)}, {digit(4), digit(5)}, {-1, -1, 7, 7});
  }
  EXPECT_EQ(first_fault, "");
}

TEST(Triangle, RandomSubPixelTrianglesAreExact) {
  constexpr unsigned seed = 41;
  std::mt19937 random(seed);
  std::string first_fault;
  for (int i = 0; i < 4000 && first_fault.empty(); ++i) {
    // From below a pixel to larger than the window.
    std::uniform_int_distribution<int> coordinate(-(256 << i % 7), 256 << i % 7);
    const auto point = [&] { return SubPoint{coordinate(random), coordinate(random)}; };
    const SubPoint a = point();
    const SubPoint b = point();
    first_fault = fault(a, b, point(), {-20, -20, 40, 40});
  }
  EXPECT_EQ(first_fault, "") << "seed " << seed;
}

TEST(Triangle, ThinSliversAreExact) {
  constexpr unsigned seed = 42;
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> coordinate(-16 * 256, 16 * 256);
  std::uniform_int_distribution<int> nudge(-2, 2);
  std::string first_fault;
  for (int i = 0; i < 4000 && first_fault.empty(); ++i) {
    const SubPoint a{coordinate(random), coordinate(random)};
    const SubPoint b{coordinate(random), coordinate(random)};
    first_fault =
        fault(a, {(a.x + b.x) / 2 + nudge(random), (a.y + b.y) / 2 + nudge(random)}, b, {-16, -16, 33, 33});
  }
  EXPECT_EQ(first_fault, "") << "seed " << seed;
}

TEST(Triangle, AnyWindowSeesTheUnclippedTriangleToTheDomainsEdge) {
  constexpr unsigned seed = 43;
  std::mt19937 random(seed);
  std::string first_fault;
  for (int i = 0; i < 20000 && first_fault.empty(); ++i) {
    const int bound = limit >> i % 18;
    std::uniform_int_distribution<int> coordinate(-bound, bound);
    const auto point = [&] {
      SubPoint p{coordinate(random), coordinate(random)};
      if (random() % 4 == 0) p.x = random() % 2 == 0 ? -bound : bound;
      if (random() % 4 == 0) p.y = random() % 2 == 0 ? -bound : bound;
      return p;
    };
    const SubPoint a = point();
    const SubPoint b = point();
    const SubPoint c = point();
    // A window around a place on an edge or at a vertex.
    const int along = i % 3 == 0 ? 0 : static_cast<int>(random() % 1024);
    const int x = static_cast<int>((a.x + (std::int64_t{b.x} - a.x) * along / 1024) / 256);
    const int y = static_cast<int>((a.y + (std::int64_t{b.y} - a.y) * along / 1024) / 256);
    const Rect clip{std::clamp(x - 6, -(1 << 20), 1 << 20), std::clamp(y - 5, -(1 << 20), 1 << 20), 13, 11};
    first_fault = fault(a, b, c, clip);
  }
  EXPECT_EQ(first_fault, "") << "seed " << seed;
}

// Draws the fan of triangles between a centre and a ring, and says which pixels the counts are wrong at.
std::string fan_fault(SubPoint centre, const std::vector<SubPoint>& ring, const Rect& clip) {
  RecordingSink sink(clip);
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (!fill_triangle(sink, centre, ring[i], ring[(i + 1) % ring.size()]).ok()) return "refused";
  for (int y = clip.y; y < clip.bottom(); ++y)
    for (int x = clip.x; x < clip.right(); ++x)
      if (sink.writes(x, y) != (oracle::in_polygon({ring}, false, x, y) ? 1 : 0))
        return "pixel " + std::to_string(x) + "," + std::to_string(y) + " drawn " +
               std::to_string(sink.writes(x, y)) + " times\n" + sink.ascii();
  return "";
}

TEST(Triangle, FansOfSixteenLeaveNoHoleAndNoDoubleInASquare) {
  constexpr unsigned seed = 44;
  std::mt19937 random(seed);
  for (int i = 0; i < 400; ++i) {
    const int step = i % 2 == 0 ? 1 : 256;  // sub-pixel vertices, or vertices on pixel centres
    const auto place = [&] { return static_cast<int>(random() % (64U * 256U)) / step * step; };
    std::vector<SubPoint> ring;
    for (int side = 0; side < 4; ++side) {
      std::array<int, 4> along{0, place(), place(), place()};
      std::sort(along.begin(), along.end());
      for (const int t : along) {
        constexpr int end = 64 * 256;
        ring.push_back(side == 0   ? SubPoint{t, 0}
                       : side == 1 ? SubPoint{end, t}
                       : side == 2 ? SubPoint{end - t, end}
                                   : SubPoint{0, end - t});
      }
    }
    ASSERT_EQ(fan_fault({place(), place()}, ring, {-1, -1, 67, 67}), "") << "seed " << seed << ", fan " << i;
  }
}

TEST(Triangle, NeighboursSharingAnEdgeShareNoPixelAndLeaveNoneOut) {
  constexpr unsigned seed = 45;
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> coordinate(-20 * 256, 20 * 256);
  const auto side = [](SubPoint a, SubPoint b, SubPoint p) {
    return std::int64_t{b.x - a.x} * (p.y - a.y) - std::int64_t{b.y - a.y} * (p.x - a.x);
  };
  int pairs = 0;
  while (pairs < 3000) {
    const auto point = [&] { return SubPoint{coordinate(random), coordinate(random)}; };
    const SubPoint a = point();
    const SubPoint b = point();
    const SubPoint c = point();
    const SubPoint d = point();
    if ((side(a, b, c) < 0) == (side(a, b, d) < 0)) continue;
    ++pairs;
    RecordingSink sink({-20, -20, 41, 41});
    ASSERT_TRUE(fill_triangle(sink, a, b, c).ok());
    ASSERT_TRUE(fill_triangle(sink, d, b, a).ok());
    ASSERT_LE(sink.most(), 1) << "seed " << seed << ": " << text(a) << text(b) << text(c) << text(d);
    for (int y = -20; y <= 20; ++y)
      for (int x = -20; x <= 20; ++x)
        ASSERT_EQ(sink.writes(x, y), oracle::in_triangle(a, b, c, x, y) + oracle::in_triangle(a, b, d, x, y));
  }
}

TEST(Triangle, WithoutAreaDrawsNothing) {
  RecordingSink sink({-10, -10, 40, 40});
  EXPECT_TRUE(fill_triangle(sink, Point{3, 3}, Point{3, 3}, Point{3, 3}).ok());
  EXPECT_TRUE(fill_triangle(sink, Point{0, 0}, Point{9, 9}, Point{20, 20}).ok());
  EXPECT_TRUE(fill_triangle(sink, Point{0, 5}, Point{9, 5}, Point{-4, 5}).ok());
  EXPECT_TRUE(fill_triangle(sink, Point{2, 0}, Point{2, 9}, Point{2, 4}).ok());
  EXPECT_TRUE(fill_triangle(sink, SubPoint{-limit, -limit}, SubPoint{0, 0}, SubPoint{limit, limit}).ok());
  EXPECT_EQ(sink.spans(), 0);
}

TEST(Triangle, BadArgumentsAreNamedAndNothingIsDrawn) {
  RecordingSink sink({0, 0, 8, 8});
  const Status expected{Error::out_of_domain, Argument::point};
  for (const int bad : {limit + 1, -limit - 1, INT_MAX, INT_MIN}) {
    EXPECT_EQ(fill_triangle(sink, SubPoint{bad, 0}, SubPoint{9999, 0}, SubPoint{0, 9999}), expected);
    EXPECT_EQ(fill_triangle(sink, SubPoint{0, 0}, SubPoint{9999, bad}, SubPoint{0, 9999}), expected);
    EXPECT_EQ(fill_triangle(sink, Point{0, 0}, Point{9, 0}, Point{bad, 9}), expected);
  }
  EXPECT_EQ(fill_triangle(sink, Point{0, 0}, Point{(1 << 20) + 1, 0}, Point{0, 9}), expected);
  EXPECT_EQ(sink.spans(), 0);
}

TEST(Triangle, AnEmptyClipTakesNothing) {
  RecordingSink sink({3, 3, 0, 0});
  EXPECT_TRUE(fill_triangle(sink, Point{0, 0}, Point{9, 0}, Point{0, 9}).ok());
  EXPECT_EQ(sink.spans(), 0);
}

}  // namespace
