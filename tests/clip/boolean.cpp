// SPDX-License-Identifier: MIT
#include <tests/clip/combine.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/samples.hpp>

#include <climits>
#include <gtest/gtest.h>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::clip::boolean_limit;
using intaglio::clip::BooleanPiece;
using intaglio::clip::BooleanVertex;
using intaglio::linear::SubPoint;
using tests::all_rules;
using tests::BooleanRule;
using tests::Combined;
using tests::combined;
using tests::exact_area;
using tests::Flat;
using tests::Shape;

Shape random_shape(oracle::Random& random, int low, int high, int most_vertices) {
  Shape shape(random.between(0, 4) == 0 ? 2 : 1);
  for (auto& contour : shape) {
    contour.resize(static_cast<std::size_t>(random.between(3, most_vertices)));
    for (SubPoint& p : contour) p = {random.between(low, high), random.between(low, high)};
  }
  return shape;
}

// Corners only, three or more to a contour.
bool is_tidy(const oracle::RationalContours& contours) {
  for (const auto& contour : contours) {
    const std::size_t n = contour.size();
    if (n < 3) return false;
    for (std::size_t i = 0; i < n; ++i) {
      const auto& p = contour[i];
      const auto& q = contour[(i + 1) % n];
      const auto& r = contour[(i + 2) % n];
      if ((q.x - p.x) * (r.y - q.y) == (q.y - p.y) * (r.x - q.x)) return false;
    }
  }
  return true;
}

// Membership of all places of a grid, half steps included: those on edges count with what lies to their
// right.
bool same_places(const Combined& result, BooleanRule rule, const Shape& a, const Shape& b, int low,
                 int high) {
  const auto first = oracle::rational(a);
  const auto second = oracle::rational(b);
  for (int y = 2 * low; y <= 2 * high; ++y)
    for (int x = 2 * low; x <= 2 * high; ++x) {
      mpq_class px(x, 2);
      mpq_class py(y, 2);
      px.canonicalize();
      py.canonicalize();
      const bool expected =
          tests::taken(rule, oracle::in_rational(first, px, py), oracle::in_rational(second, px, py));
      if (oracle::in_rational(result.contours, px, py) != expected) return false;
    }
  return true;
}

// A grid of 6 x 6 makes shared vertices, overlapping edges and vertices on edges the rule.
TEST(Combine, RandomPairsOnASmallGridHaveTheExactAreas) {
  oracle::Random random(2019);
  const int pairs = oracle::samples(4000, 100000);
  for (int i = 0; i < pairs; ++i) {
    const int size = i % 3 == 0 ? 3 : 5;
    const Shape a = random_shape(random, 0, size, i % 10 == 0 ? 9 : 5);
    const Shape b = i % 50 == 0 ? a : random_shape(random, 0, size, i % 10 == 0 ? 9 : 5);
    const BooleanRule rule = all_rules[i % 4];
    const Combined result = combined(rule, a, b);
    ASSERT_TRUE(result.status.ok()) << tests::text(a) << " with " << tests::text(b);
    ASSERT_EQ(result.area(), exact_area(rule, a, b))
        << tests::text(a) << " with " << tests::text(b) << " rule " << i % 4 << " " << random.seed_text();
    ASSERT_TRUE(is_tidy(result.contours))
        << tests::text(a) << " with " << tests::text(b) << " rule " << i % 4;
    if (oracle::full_run() || i % 16 < 4) {
      ASSERT_TRUE(same_places(result, rule, a, b, 0, size))
          << tests::text(a) << " with " << tests::text(b) << " rule " << i % 4;
    }
  }
}

TEST(Combine, RandomPairsToTheEdgesOfTheDomainHaveTheExactAreas) {
  oracle::Random random(2020);
  for (int i = 0; i < oracle::samples(400, 4000); ++i) {
    const int reach = i % 2 == 0 ? boolean_limit : 1 << random.between(2, 19);
    Shape a = random_shape(random, -reach, reach, 8);
    Shape b = random_shape(random, -reach, reach, 8);
    if (i % 4 == 0) b[0][0] = a[0][0];
    if (i % 4 == 1) b[0][1] = a[0][1], b[0][0] = a[0][0];
    if (i % 8 == 3) a[0] = {{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}};
    for (const BooleanRule rule : all_rules) {
      const Combined result = combined(rule, a, b);
      ASSERT_TRUE(result.status.ok());
      ASSERT_EQ(result.area(), exact_area(rule, a, b))
          << tests::text(a) << " with " << tests::text(b) << " " << random.seed_text();
      ASSERT_TRUE(is_tidy(result.contours));
    }
  }
}

// Edges whose slopes differ by less than any rounding keeps: crossings near the budget's end.
TEST(Combine, NearlyParallelEdgesAcrossTheDomain) {
  oracle::Random random(2021);
  constexpr int l = boolean_limit;
  for (int i = 0; i < oracle::samples(500, 5000); ++i) {
    const auto little = [&] { return random.between(0, 3); };
    const Shape a{
        {{-l + little(), -l + little()}, {l - little(), l - little()}, {l - little(), l - 10 - little()}}};
    const Shape b{
        {{-l + little(), -l + little()}, {l - little(), l - little()}, {-l + little(), -l + 10 + little()}}};
    for (const BooleanRule rule : all_rules)
      ASSERT_EQ(combined(rule, a, b).area(), exact_area(rule, a, b))
          << tests::text(a) << " with " << tests::text(b);
  }
}

TEST(Combine, AHoleRunsTheOtherWayRound) {
  const Shape outer{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}};
  const Shape inner{{{3, 3}, {6, 3}, {6, 6}, {3, 6}}};
  const Combined ring = combined(BooleanRule::a_minus_b, outer, inner);
  ASSERT_EQ(ring.contours.size(), 2U);
  EXPECT_EQ(oracle::signed_area({ring.contours[0]}) + oracle::signed_area({ring.contours[1]}), -72);
  EXPECT_EQ(oracle::signed_area({ring.contours[0]}) < 0, oracle::signed_area({ring.contours[1]}) > 0);
}

TEST(Combine, PartsThatTouchAtACornerAreContoursOfTheirOwn) {
  const Combined both =
      combined(BooleanRule::join, {{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}, {{{2, 2}, {4, 2}, {4, 4}, {2, 4}}});
  ASSERT_EQ(both.contours.size(), 2U);
  EXPECT_EQ(both.contours[0].size(), 4U);
  EXPECT_EQ(both.contours[1].size(), 4U);
}

TEST(Combine, NeighboursJoinWithoutATraceOfTheirEdge) {
  const Combined both =
      combined(BooleanRule::join, {{{0, 0}, {2, 0}, {2, 4}, {0, 4}}}, {{{2, 0}, {2, 4}, {5, 4}, {5, 0}}});
  ASSERT_EQ(both.contours.size(), 1U);
  EXPECT_EQ(both.contours[0].size(), 4U);
  EXPECT_EQ(both.area(), 20);
}

TEST(Combine, NothingIsNoContour) {
  const Shape square{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};
  EXPECT_TRUE(combined(BooleanRule::a_minus_b, square, square).contours.empty());
  EXPECT_TRUE(combined(BooleanRule::intersection, square, {}).contours.empty());
  EXPECT_TRUE(combined(BooleanRule::join, {}, {}).contours.empty());
  EXPECT_TRUE(combined(BooleanRule::join, {{{1, 1}, {5, 5}}}, {{{3, 3}}}).contours.empty());
  EXPECT_EQ(combined(BooleanRule::join, square, {}).area(), 4);
}

TEST(Combine, RoundsVerticesToTheNearestPlace) {
  EXPECT_EQ(nearest(BooleanVertex{7, -7, 2}), (SubPoint{4, -3}));
  EXPECT_EQ(nearest(BooleanVertex{7, -7, 3}), (SubPoint{2, -2}));
}

TEST(Combine, TooLittleMemoryIsSaidAndExactlyEnoughDoes) {
  const Flat a({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}});
  const Flat b({{{3, 3}, {6, 3}, {6, 6}, {3, 6}}});
  std::vector<BooleanPiece> workspace(100);
  std::vector<BooleanVertex> vertices(100);
  std::vector<int> lengths(100);
  const auto call = [&](std::size_t v, std::size_t c, std::size_t w) {
    return combine(BooleanRule::a_minus_b, a.operand(), b.operand(), std::span(vertices).first(v),
                   std::span(lengths).first(c), std::span(workspace).first(w))
        .status();
  };
  EXPECT_EQ(call(100, 100, 8), (Status{Error::too_small, Argument::workspace, 9}));
  EXPECT_EQ(call(7, 100, 9), (Status{Error::too_small, Argument::vertices, 8}));
  EXPECT_EQ(call(8, 1, 9), (Status{Error::too_small, Argument::contours, 2}));
  EXPECT_TRUE(call(8, 2, 9).ok());
}

TEST(Combine, BadArgumentsAreNamed) {
  const Shape good{{{0, 0}, {9, 0}, {9, 9}}};
  for (const int bad : {INT_MIN, INT_MAX, boolean_limit + 1, -boolean_limit - 1}) {
    const Status outside{Error::out_of_domain, Argument::vertices};
    EXPECT_EQ(combined(BooleanRule::join, good, {{{0, 0}, {bad, 0}, {9, 9}}}).status, outside);
    EXPECT_EQ(combined(BooleanRule::join, {{{0, 0}, {9, bad}, {9, 9}}}, good).status, outside);
  }
  EXPECT_EQ(combined(static_cast<BooleanRule>(4), good, good).status,
            (Status{Error::out_of_range, Argument::rule}));
  const Flat flat(good);
  for (const std::vector<int>& lengths : {std::vector<int>{2}, {4}, {-1, 4}, {INT_MAX, INT_MAX}, {}}) {
    const Status mismatched{Error::mismatched, Argument::contours};
    EXPECT_EQ(combine(BooleanRule::join, {flat.vertices, lengths}, flat.operand(), {}, {}, {}).status(),
              mismatched);
    EXPECT_EQ(combine(BooleanRule::join, flat.operand(), {flat.vertices, lengths}, {}, {}, {}).status(),
              mismatched);
  }
}

}  // namespace
