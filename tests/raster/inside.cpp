// SPDX-License-Identifier: MIT
#include <intaglio/raster/inside.hpp>
#include <intaglio/raster/polygon.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::SubPoint;
using intaglio::raster::fill_polygon;
using intaglio::raster::FillRule;
using intaglio::raster::inside_convex;
using intaglio::raster::inside_polygon;
using intaglio::raster::PolygonEdge;
using intaglio::raster::winding_number;

constexpr int limit = 1 << 28;

// Winding number of any point by 128-bit cross products.
int turns_around(const oracle::Contours& contours, SubPoint p) {
  __extension__ using Int = __int128;
  int turns = 0;
  for (const auto& contour : contours)
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const SubPoint a = contour[i];
      const SubPoint b = contour[(i + 1) % contour.size()];
      const Int run = (Int{p.x} - a.x) * (Int{b.y} - a.y) - (Int{p.y} - a.y) * (Int{b.x} - a.x);
      if (a.y <= p.y && p.y < b.y && run >= 0) ++turns;
      if (b.y <= p.y && p.y < a.y && run <= 0) --turns;
    }
  return turns;
}

TEST(Inside, AgreesWithTheFillPixelByPixelByBothRules) {
  oracle::Random random(2121);
  for (int i = 0; i < 1500; ++i) {
    const int step = i % 3 == 0 ? 256 : i % 3 == 1 ? 128 : 1;
    const int bound = 256 << i % 5;
    std::vector<SubPoint> vertices;
    std::vector<int> lengths;
    for (int n = 0; n <= i % 3; ++n) {
      lengths.push_back(random.between(0, 9));
      for (int k = 0; k < lengths.back(); ++k)
        vertices.push_back(
            {random.between(-bound, bound) / step * step, random.between(-bound, bound) / step * step});
    }
    std::vector<PolygonEdge> workspace(vertices.size());
    for (const FillRule rule : {FillRule::even_odd, FillRule::non_zero}) {
      oracle::RecordingSink sink({-9, -9, 19, 19});
      ASSERT_TRUE(fill_polygon(sink, rule, vertices, lengths, workspace).ok());
      int wrong = 0;
      for (int y = -9; y < 10; ++y)
        for (int x = -9; x < 10; ++x)
          wrong +=
              inside_polygon(rule, vertices, lengths, {x * 256, y * 256}).value() == (sink.writes(x, y) == 1)
                  ? 0
                  : 1;
      ASSERT_EQ(wrong, 0) << random.seed_text() << ", polygon " << i;
    }
  }
}

TEST(Inside, WindingNumbersAreExactToTheDomainsEdgeAndOnEdges) {
  oracle::Random random(2122);
  for (int i = 0; i < 20000; ++i) {
    const int bound = limit >> i % 28;
    oracle::Contour contour;
    for (int k = 0; k < 3 + i % 9; ++k)
      contour.push_back({random.between(-bound, bound), random.between(-bound, bound)});
    if (i % 4 == 0) contour[1].y = contour[0].y;
    const SubPoint middle{(contour[0].x + contour[2].x) / 2, (contour[0].y + contour[2].y) / 2};
    const std::vector<int> lengths{static_cast<int>(contour.size())};
    for (const SubPoint p :
         {contour[0], contour[2], middle, SubPoint{random.between(-bound, bound), contour[1].y}})
      ASSERT_EQ(winding_number(contour, lengths, p).value(), turns_around({contour}, p))
          << random.seed_text();
  }
}

TEST(Inside, TheSignTestAgreesWithTheWindingTestOnConvexPolygonsEitherWayAround) {
  oracle::Random random(2123);
  for (int i = 0; i < 2000; ++i) {
    // A triangle or a parallelogram, with collinear and repeated vertices.
    const int bound = i % 2 == 0 ? 6 * 256 : 1 << (8 + i % 20);
    const auto place = [&] {
      return random.between(-bound, bound) / (i % 3 == 0 ? 256 : 2) * (i % 3 == 0 ? 256 : 2);
    };
    const SubPoint a{place(), place()};
    const SubPoint b{place(), place()};
    const SubPoint c{place(), place()};
    oracle::Contour contour{a, {(a.x + b.x) / 2, (a.y + b.y) / 2}, b, b, c};
    if ((a.x + b.x) % 2 != 0 || (a.y + b.y) % 2 != 0) contour.erase(contour.begin() + 1);
    if (i % 4 < 2) contour.push_back({a.x + (c.x - b.x), a.y + (c.y - b.y)});
    if (!(contour.back().x >= -limit && contour.back().x <= limit && contour.back().y >= -limit &&
          contour.back().y <= limit))
      continue;
    for (int n = 0; n < 60; ++n) {
      SubPoint p{place(), place()};
      if (n < 5) p = contour[static_cast<std::size_t>(n) % contour.size()];
      const int turns = turns_around({contour}, p);
      ASSERT_EQ(inside_convex(contour, p).value(), turns != 0) << random.seed_text() << ", polygon " << i;
      ASSERT_EQ(inside_convex(oracle::Contour(contour.rbegin(), contour.rend()), p).value(), turns != 0);
    }
  }
}

TEST(Inside, APartitionOfThePlaneGivesEveryPointOneOwner) {
  const std::array<std::vector<SubPoint>, 4> fan{{{{0, 0}, {1024, 0}, {500, 600}},
                                                  {{1024, 0}, {1024, 1024}, {500, 600}},
                                                  {{1024, 1024}, {0, 1024}, {500, 600}},
                                                  {{0, 1024}, {0, 0}, {500, 600}}}};
  for (int y = -2; y < 1030; ++y)
    for (int x = -2; x < 1030; x += y % 7 == 0 ? 1 : 41) {
      int owners = 0;
      for (const auto& triangle : fan) owners += inside_convex(triangle, {x, y}).value() ? 1 : 0;
      const bool in_square = x >= 0 && y >= 0 && x < 1024 && y < 1024;
      ASSERT_EQ(owners, in_square ? 1 : 0) << x << "," << y;
    }
}

TEST(Inside, BadArgumentsAreNamed) {
  std::vector<SubPoint> square{{0, 0}, {2560, 0}, {2560, 2560}, {0, 2560}};
  const std::vector<int> four{4};
  for (const int bad : {limit + 1, -limit - 1, INT_MAX, INT_MIN}) {
    const Status expected{Error::out_of_domain, Argument::point};
    EXPECT_EQ(winding_number(square, four, {bad, 0}).status(), expected);
    EXPECT_EQ(inside_polygon(FillRule::even_odd, square, four, {0, bad}).status(), expected);
    EXPECT_EQ(inside_convex(square, {bad, bad}).status(), expected);
    square[2].x = bad;
    const Status vertices{Error::out_of_domain, Argument::vertices};
    EXPECT_EQ(winding_number(square, four, {0, 0}).status(), vertices);
    EXPECT_EQ(inside_convex(square, {0, 0}).status(), vertices);
    square[2].x = 2560;
  }
  EXPECT_EQ(winding_number(square, std::vector<int>{5, -1}, {0, 0}).status(),
            (Status{Error::mismatched, Argument::contours}));
  EXPECT_EQ(inside_polygon(static_cast<FillRule>(2), square, four, {0, 0}).status(),
            (Status{Error::out_of_range, Argument::rule}));
  EXPECT_FALSE(inside_convex({}, {0, 0}).value());
  EXPECT_EQ(winding_number({}, {}, {0, 0}).value(), 0);
  EXPECT_FALSE(inside_convex(std::vector<SubPoint>{{5, 5}, {5, 5}}, {5, 5}).value());
}

}  // namespace
