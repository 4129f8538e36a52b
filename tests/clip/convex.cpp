// SPDX-License-Identifier: MIT
#include <intaglio/clip/convex.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/random.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::clip::clip_to_convex;
using intaglio::clip::ClipStage;
using intaglio::linear::SubPoint;
using Points = std::vector<SubPoint>;
__extension__ using Int = __int128;

constexpr int limit = 1 << 28;

Status attempt(const Points& polygon, const Points& clipper, std::size_t room, std::size_t stages,
               Points& result) {
  Points out(room);
  std::vector<ClipStage> workspace(stages);
  const auto used = clip_to_convex(polygon, clipper, out, workspace);
  result.assign(used.value().begin(), used.value().end());
  return used.status();
}

Points clipped(const Points& polygon, const Points& clipper) {
  Points result;
  EXPECT_TRUE(attempt(polygon, clipper, 16 * (polygon.size() + clipper.size()), clipper.size(), result).ok());
  return result;
}

Int side(SubPoint from, SubPoint to, SubPoint p) {
  return (Int{to.x} - from.x) * (Int{p.y} - from.y) - (Int{to.y} - from.y) * (Int{p.x} - from.x);
}
Int squared(SubPoint from, SubPoint to) {
  const Int dx = Int{to.x} - from.x;
  const Int dy = Int{to.y} - from.y;
  return dx * dx + dy * dy;
}
// Twice the area times the sign of the turn.
Int area(const Points& points) {
  Int sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SubPoint a = points[i];
    const SubPoint b = points[(i + 1) % points.size()];
    sum += Int{a.x} * b.y - Int{a.y} * b.x;
  }
  return sum;
}

Points reversed(Points points) {
  std::reverse(points.begin(), points.end());
  return points;
}

// A convex polygon: some of the points of a circle-like ring, in order.
Points convex_polygon(oracle::Random& random, int x, int y, int radius) {
  static constexpr int ring[16][2] = {{1000, 0},  {924, 383},   {707, 707},   {383, 924},
                                      {0, 1000},  {-383, 924},  {-707, 707},  {-924, 383},
                                      {-1000, 0}, {-924, -383}, {-707, -707}, {-383, -924},
                                      {0, -1000}, {383, -924},  {707, -707},  {924, -383}};
  Points points;
  while (points.size() < 3) {
    points.clear();
    for (const auto& [dx, dy] : ring)
      if (random.between(0, 2) == 0)
        points.push_back({x + static_cast<int>(std::int64_t{dx} * radius / 1000),
                          y + static_cast<int>(std::int64_t{dy} * radius / 1000)});
  }
  return points;
}

// Table 2.2: seven vertices against one edge (here the upper edge of a huge clipper), cases 2 3 4 2 3 4 1.
TEST(ClipToConvex, TraceOfTheTextbook) {
  const Points clipper{{-1000, 0}, {1000, 0}, {1000, 1000}, {-1000, 1000}};
  const Points polygon{{0, 20}, {10, -20}, {20, -20}, {30, 20}, {40, -20}, {50, -20}, {60, 20}};
  // i1 / - / i2 v3 / i3 / - / i4 v6 / v0
  const Points expected{{5, 0}, {25, 0}, {30, 20}, {35, 0}, {55, 0}, {60, 20}, {0, 20}};
  Points result = clipped(polygon, clipper);
  // Each of the three further edges hands the first vertex that it sees on as the last.
  std::rotate(result.begin(), std::find(result.begin(), result.end(), expected.front()), result.end());
  EXPECT_EQ(result, expected);
}

TEST(ClipToConvex, VerticesOnAnEdgesLineAreInsideAndMakeNoNewOnes) {
  const Points square{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
  const Points inscribed{{50, 0}, {100, 50}, {50, 100}, {0, 50}};
  EXPECT_EQ(clipped(inscribed, square).size(), 4U);
  EXPECT_EQ(area(clipped(inscribed, square)), area(inscribed));
  EXPECT_EQ(clipped(square, square).size(), 4U);
  // Outside but for one vertex: what is left has no area.
  EXPECT_EQ(area(clipped({{100, 50}, {150, 0}, {150, 100}}, square)), 0);
  EXPECT_TRUE(clipped({{101, 50}, {150, 0}, {150, 100}}, square).empty());
}

TEST(ClipToConvex, AConvexPolygonIsClippedToTheExactArea) {
  // A diamond in a square, the clip's corners cut at places on the grid.
  const Points square{{-60, -60}, {60, -60}, {60, 60}, {-60, 60}};
  const Points diamond{{0, -100}, {100, 0}, {0, 100}, {-100, 0}};
  for (const Points& clipper : {square, reversed(square)}) {
    const Points result = clipped(diamond, clipper);
    EXPECT_EQ(result.size(), 8U);
    EXPECT_EQ(area(result), 2 * (120 * 120 - 4 * 20 * 20 / 2));
  }
  EXPECT_EQ(area(clipped(reversed(diamond), square)), -2 * (120 * 120 - 4 * 20 * 20 / 2));
}

// A pixel whose centre is further from every edge than the bound of the roundings is in the result exactly if
// it is in the polygon and in the clipper.
TEST(ClipToConvex, ResultHoldsWhatPolygonAndClipperHold) {
  oracle::Random random(71);
  int wrong = 0;
  int compared = 0;
  for (int i = 0; i < 3000; ++i) {
    const Points clipper = convex_polygon(random, random.between(2000, 6000), random.between(2000, 6000),
                                          random.between(500, 4000));
    Points polygon(static_cast<std::size_t>(random.between(3, 9)));
    for (SubPoint& p : polygon) p = {random.between(-2000, 10000), random.between(-2000, 10000)};
    const Points result = clipped(polygon, i % 2 == 0 ? clipper : reversed(clipper));
    // 1 + 0.71 * edges, squared, rounded up
    const Int bound = Int{2} * static_cast<int>(clipper.size() * clipper.size()) + 4;
    for (int y = 0; y < 32; y += 3)
      for (int x = 0; x < 32; x += 3) {
        const SubPoint centre{x * 256, y * 256};
        const auto near = [&](const Points& points) {
          for (std::size_t e = 0; e < points.size(); ++e) {
            const SubPoint a = points[e];
            const SubPoint b = points[(e + 1) % points.size()];
            const Int distance = side(a, b, centre);
            if (distance * distance <= bound * squared(a, b)) return true;
          }
          return false;
        };
        if (near(polygon) || near(clipper)) continue;
        ++compared;
        const bool expected =
            oracle::in_polygon({polygon}, true, x, y) && oracle::in_polygon({clipper}, true, x, y);
        if (oracle::in_polygon({result}, true, x, y) != expected) ++wrong;
      }
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
  EXPECT_GT(compared, 200000);
}

// No vertex lies further outside than the head of the file says; against a rectangle none does.
TEST(ClipToConvex, RoundingStaysWithinItsBoundToTheEdgesOfTheDomain) {
  oracle::Random random(72);
  int outside_convex = 0;
  int outside_rectangle = 0;
  std::size_t made = 0;
  for (int i = 0; i < 20000; ++i) {
    const int reach = i % 2 == 0 ? limit : 1 << random.between(4, 28);
    Points polygon(static_cast<std::size_t>(random.between(3, 8)));
    for (SubPoint& p : polygon) p = {random.between(-reach, reach), random.between(-reach, reach)};
    const Points clipper = convex_polygon(random, 0, 0, std::max(20, random.between(reach / 2, reach)));
    const Points result = clipped(polygon, clipper);
    made += result.size();
    const Int bound = static_cast<int>(clipper.size() * clipper.size());  // 2 * (0.71 * edges)^2
    for (const SubPoint p : result)
      for (std::size_t e = 0; e < clipper.size(); ++e) {
        const SubPoint a = clipper[e];
        const SubPoint b = clipper[(e + 1) % clipper.size()];
        // side^2 <= bound / 2 * length^2, by quotients: the squares have up to 118 bits.
        const Int distance = side(a, b, p);
        if (distance < 0 && distance * distance / squared(a, b) > bound / 2 + 1) ++outside_convex;
      }
    const int left = random.between(-reach, reach - 1);
    const int top = random.between(-reach, reach - 1);
    const int right = random.between(left + 1, reach);
    const int bottom = random.between(top + 1, reach);
    for (const SubPoint p : clipped(polygon, {{left, top}, {right, top}, {right, bottom}, {left, bottom}}))
      if (p.x < left || p.x > right || p.y < top || p.y > bottom) ++outside_rectangle;
  }
  EXPECT_EQ(outside_convex, 0) << random.seed_text();
  EXPECT_EQ(outside_rectangle, 0) << random.seed_text();
  EXPECT_GT(made, 50000U);
}

// One edge of the clipper cuts: each new vertex is the exact crossing, rounded to the nearest place.
TEST(ClipToConvex, NewVerticesAreTheNearestToTheExactCrossing) {
  oracle::Random random(74);
  int wrong = 0;
  for (int i = 0; i < 20000; ++i) {
    const int reach = i % 2 == 0 ? limit : 1 << random.between(2, 28);
    const auto point = [&](int low, int high) {
      return SubPoint{random.between(-reach, reach), random.between(low, high)};
    };
    // Below a line from the left to the right side, with the other edges out of the way.
    const int left = random.between(-reach / 4, reach / 4);
    const int right = random.between(-reach / 4, reach / 4);
    const Points clipper{{-limit, left}, {limit, right}, {limit, limit}, {-limit, limit}};
    const SubPoint inside = point(reach / 4 + 1, reach);
    const SubPoint outside = point(-reach, -reach / 4 - 1);
    const Points result = clipped({inside, outside, inside}, clipper);
    const Int whole = side(clipper[0], clipper[1], inside) - side(clipper[0], clipper[1], outside);
    const Int part = side(clipper[0], clipper[1], inside);
    const auto crossing = [&](int from, int to) {
      // floor((2n + d) / 2d) of (from * d + (to - from) * part) / d, in terms that stay below 2^127
      const Int n = 2 * (Int{from} * whole + (Int{to} - from) * part) + whole;
      const Int d = 2 * whole;
      return static_cast<int>(n / d - (n % d < 0 ? 1 : 0));
    };
    const SubPoint expected{crossing(inside.x, outside.x), crossing(inside.y, outside.y)};
    if (std::count(result.begin(), result.end(), expected) != 2) ++wrong;
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

// Whichever way an edge runs, its new vertices are the same: neighbours leave no gap between them.
TEST(ClipToConvex, ReversedPolygonsGetTheSameVertices) {
  oracle::Random random(73);
  int wrong = 0;
  for (int i = 0; i < 20000; ++i) {
    const int reach = i % 2 == 0 ? limit : 1 << random.between(4, 28);
    Points polygon(static_cast<std::size_t>(random.between(3, 8)));
    for (SubPoint& p : polygon) p = {random.between(-reach, reach), random.between(-reach, reach)};
    const Points clipper = convex_polygon(random, 0, 0, std::max(20, random.between(reach / 2, reach)));
    const auto sorted = [](Points points) {
      std::sort(points.begin(), points.end(),
                [](SubPoint a, SubPoint b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
      return points;
    };
    if (sorted(clipped(polygon, clipper)) != sorted(clipped(reversed(polygon), clipper))) ++wrong;
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(ClipToConvex, TooLittleMemoryIsSaidExactly) {
  const Points polygon{{0, 20}, {10, -20}, {20, -20}, {30, 20}, {40, -20}, {50, -20}, {60, 20}};
  const Points clipper{{5, 0}, {55, 0}, {55, 15}, {5, 15}};
  Points result;
  EXPECT_EQ(attempt(polygon, clipper, 100, 3, result), (Status{Error::too_small, Argument::workspace, 4}));
  const Status none = attempt(polygon, clipper, 0, 4, result);
  EXPECT_EQ(none.error(), Error::too_small);
  EXPECT_EQ(none.argument(), Argument::buffer);
  EXPECT_EQ(attempt(polygon, clipper, none.needed() - 1, 4, result), none);
  EXPECT_TRUE(result.empty());
  EXPECT_TRUE(attempt(polygon, clipper, none.needed(), 4, result).ok());
  EXPECT_EQ(result.size(), none.needed());
}

TEST(ClipToConvex, BadArgumentsAreNamed) {
  const Points good{{0, 0}, {100, 0}, {0, 100}};
  const Status vertices{Error::out_of_domain, Argument::vertices};
  const Status malformed{Error::malformed, Argument::contours};
  const Status empty{Error::empty, Argument::contours};
  const auto status = [](const Points& polygon, const Points& clipper) {
    Points result;
    return attempt(polygon, clipper, 100, 20, result);
  };
  for (const int bad : {INT_MIN, INT_MAX, limit + 1, -limit - 1}) {
    EXPECT_EQ(status({{0, 0}, {bad, 0}, {0, 100}}, good), vertices);
    EXPECT_EQ(status(good, {{0, 0}, {1, bad}, {0, 100}}), vertices);
  }
  EXPECT_EQ(status(good, {}), empty);
  EXPECT_EQ(status(good, {{3, 3}, {3, 3}, {3, 3}}), empty);
  EXPECT_EQ(status(good, {{0, 0}, {10, 10}, {30, 30}}), empty);
  EXPECT_EQ(status(good, {{0, 0}, {100, 0}, {50, 10}, {0, 100}}), malformed);                   // a dent
  EXPECT_EQ(status(good, {{0, -100}, {59, 81}, {-95, -31}, {95, -31}, {-59, 81}}), malformed);  // a pentagram
  EXPECT_EQ(status(good, {{0, 0}, {100, 0}, {200, 0}, {100, 0}, {100, 100}, {0, 100}}),
            malformed);  // a spike
  EXPECT_TRUE(status(good, {{0, 0}, {0, 0}, {50, 0}, {100, 0}, {100, 100}, {0, 100}}).ok());
  EXPECT_TRUE(clipped({{1, 1}, {5, 5}}, good).empty());
}

}  // namespace
