// SPDX-License-Identifier: MIT
//
// The walk of Greiner and Hormann: exact where it is defined, refused exactly where it isn't, and the same
// sets as the pipeline of Sutherland and Hodgman and as `combine`.
#include <intaglio/clip/convex.hpp>
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
using intaglio::clip::BooleanVertex;
using intaglio::clip::combine_greiner_hormann;
using intaglio::clip::RingNode;
using intaglio::linear::SubPoint;
using tests::all_rules;
using tests::BooleanRule;
using tests::Combined;
using tests::exact_area;
using tests::Flat;
using tests::Shape;
using tests::walked;

constexpr Status touching{Error::unsupported, Argument::vertices};

/// The area of a result as a set by even-odd.
mpq_class set_area(const oracle::RationalContours& contours) {
  return oracle::combined_area(contours, {}, [](bool in, bool) { return in; });
}

/// True if a vertex of one shape lies on an edge of the other, or an edge meets two of the other's in one
/// place: by rational numbers.
bool touch(const Shape& a, const Shape& b) {
  struct Edge {
    SubPoint from, to;
  };
  const auto edges = [](const Shape& shape) {
    std::vector<Edge> all;
    for (const auto& contour : shape)
      for (std::size_t i = 0; contour.size() >= 3 && i < contour.size(); ++i)
        if (!(contour[i] == contour[(i + 1) % contour.size()]))
          all.push_back({contour[i], contour[(i + 1) % contour.size()]});
    return all;
  };
  const auto turn = [](SubPoint p, SubPoint q, SubPoint r) {
    const mpz_class value = mpz_class(q.x - p.x) * (r.y - p.y) - mpz_class(q.y - p.y) * (r.x - p.x);
    return sgn(value);
  };
  const auto on = [&](const Edge& e, SubPoint p) {
    return turn(e.from, e.to, p) == 0 && p.x >= std::min(e.from.x, e.to.x) &&
           p.x <= std::max(e.from.x, e.to.x) && p.y >= std::min(e.from.y, e.to.y) &&
           p.y <= std::max(e.from.y, e.to.y);
  };
  for (const bool swapped : {false, true}) {
    const auto first = edges(swapped ? b : a);
    const auto second = edges(swapped ? a : b);
    for (const Edge& e : first) {
      std::vector<mpq_class> met;
      for (const Edge& f : second) {
        if (on(e, f.from) || on(e, f.to)) return true;
        const int at_from = turn(e.from, e.to, f.from);
        if (at_from * turn(e.from, e.to, f.to) >= 0) continue;
        if (turn(f.from, f.to, e.from) * turn(f.from, f.to, e.to) >= 0) continue;
        const mpz_class over = mpz_class(f.from.x - e.from.x) * (f.to.y - f.from.y) -
                               mpz_class(f.from.y - e.from.y) * (f.to.x - f.from.x);
        const mpz_class under = mpz_class(e.to.x - e.from.x) * (f.to.y - f.from.y) -
                                mpz_class(e.to.y - e.from.y) * (f.to.x - f.from.x);
        mpq_class along(over, under);
        along.canonicalize();
        if (std::find(met.begin(), met.end(), along) != met.end()) return true;
        met.push_back(along);
      }
    }
  }
  return false;
}

Shape random_shape(oracle::Random& random, int reach, int most_vertices) {
  Shape shape(random.between(0, 3) == 0 ? 2 : 1);
  for (auto& contour : shape) {
    contour.resize(static_cast<std::size_t>(random.between(3, most_vertices)));
    for (SubPoint& p : contour) p = {random.between(-reach, reach), random.between(-reach, reach)};
  }
  return shape;
}

TEST(GreinerHormann, RandomPairsHaveTheExactAreasOrTouch) {
  oracle::Random random(2301);
  int refused = 0;
  const int pairs = oracle::samples(1500, 30000);
  for (int i = 0; i < pairs; ++i) {
    const int reach = i % 3 == 0 ? 4 : i % 3 == 1 ? 300 : boolean_limit;
    const Shape a = random_shape(random, reach, 8);
    const Shape b = random_shape(random, reach, 8);
    const BooleanRule rule = all_rules[i % 4];
    const Combined result = walked(rule, a, b);
    if (touch(a, b)) {
      ++refused;
      ASSERT_EQ(result.status, touching) << tests::text(a) << " with " << tests::text(b);
      continue;
    }
    ASSERT_TRUE(result.status.ok()) << tests::text(a) << " with " << tests::text(b);
    ASSERT_EQ(set_area(result.contours), exact_area(rule, a, b))
        << tests::text(a) << " with " << tests::text(b) << " rule " << i % 4 << " " << random.seed_text();
  }
  EXPECT_GT(refused, pairs / 5);
  EXPECT_LT(refused, pairs / 2);
}

TEST(GreinerHormann, ContoursWithoutCrossingsAreKeptWholeOrNotAtAll) {
  const Shape outer{{{0, 0}, {90, 0}, {90, 90}, {0, 90}}};
  const Shape inner{{{30, 30}, {60, 30}, {60, 60}, {30, 60}}};
  const Shape far{{{300, 300}, {600, 300}, {600, 600}}};
  EXPECT_EQ(walked(BooleanRule::intersection, outer, inner).contours.size(), 1U);
  EXPECT_EQ(walked(BooleanRule::join, outer, inner).contours.size(), 1U);
  EXPECT_EQ(walked(BooleanRule::a_minus_b, outer, inner).contours.size(), 2U);
  EXPECT_EQ(walked(BooleanRule::b_minus_a, outer, inner).contours.size(), 0U);
  EXPECT_EQ(walked(BooleanRule::intersection, outer, far).contours.size(), 0U);
  EXPECT_EQ(walked(BooleanRule::join, outer, far).contours.size(), 2U);
  EXPECT_EQ(walked(BooleanRule::join, {}, far).contours.size(), 1U);
  EXPECT_EQ(walked(BooleanRule::join, {{{0, 0}, {9, 9}}}, far).contours.size(), 1U);
}

TEST(GreinerHormann, DegenerateContactsAreRefused) {
  const Shape square{{{0, 0}, {30, 0}, {30, 30}, {0, 30}}};
  for (const Shape& other : {Shape{{{0, 0}, {50, 20}, {20, 50}}},      // a shared vertex
                             Shape{{{10, 0}, {20, 0}, {15, -20}}},     // overlapping edges
                             Shape{{{10, 10}, {30, 15}, {10, 20}}},    // a vertex on an edge
                             Shape{{{-10, 10}, {10, -10}, {20, 20}}},  // a vertex touched by an edge
                             Shape{{{-10, 5}, {10, 25}, {10, 5}, {-10, 25}}}, square})  // crossing on an edge
    for (const BooleanRule rule : all_rules) EXPECT_EQ(walked(rule, square, other).status, touching);
}

// The book's comparison of the two clippers, on input that both can take: polygons on a grid of 10 x 10 cells
// of 5040 sub-pixels, windows half a cell off. All crossings are whole there, so that rounding hides nothing.
TEST(GreinerHormann, GivesTheSetsOfSutherlandHodgmanOnGeneratedPolygons) {
  constexpr int cell = 5040;
  oracle::Random random(2302);
  int compared = 0;
  for (int i = 0; i < 1000; ++i) {
    Shape subject(1);
    subject[0].resize(static_cast<std::size_t>(random.between(3, 9)));
    for (SubPoint& p : subject[0]) p = {cell * random.between(0, 10), cell * random.between(0, 10)};
    const int left = cell * random.between(0, 8) + cell / 2;
    const int top = cell * random.between(0, 8) + cell / 2;
    const int right = left + cell * random.between(1, 9);
    const int bottom = top + cell * random.between(1, 9);
    const Shape window{{{left, top}, {right, top}, {right, bottom}, {left, bottom}}};
    const Combined walk = walked(BooleanRule::intersection, subject, window);
    if (walk.status == touching) continue;
    ASSERT_TRUE(walk.status.ok());
    std::vector<SubPoint> out(100);
    std::vector<intaglio::clip::ClipStage> stages(4);
    const auto pipeline = clip_to_convex(subject[0], window[0], out, stages);
    ASSERT_TRUE(pipeline.ok());
    const Shape clipped{{pipeline.value().begin(), pipeline.value().end()}};
    const mpq_class area = set_area(oracle::rational(clipped));
    ASSERT_EQ(set_area(walk.contours), area) << tests::text(subject) << " in " << tests::text(window);
    ASSERT_EQ(tests::combined(BooleanRule::intersection, subject, window).area(), area);
    // As sets of places, not only in size.
    const mpq_class apart = oracle::combined_area(walk.contours, oracle::rational(clipped),
                                                  [](bool in_a, bool in_b) { return in_a != in_b; });
    ASSERT_EQ(apart, 0) << tests::text(subject) << " in " << tests::text(window);
    ++compared;
  }
  EXPECT_GT(compared, 600);
}

TEST(GreinerHormann, TooLittleMemoryIsSaidAndExactlyEnoughDoes) {
  const Flat a({{{0, 0}, {90, 0}, {90, 90}, {0, 90}}});
  const Flat b({{{30, -30}, {60, -30}, {60, 120}, {30, 120}}});
  std::vector<RingNode> workspace(100);
  std::vector<BooleanVertex> vertices(100);
  std::vector<int> lengths(100);
  const auto call = [&](std::size_t v, std::size_t c, std::size_t w) {
    return combine_greiner_hormann(BooleanRule::a_minus_b, a.operand(), b.operand(),
                                   std::span(vertices).first(v), std::span(lengths).first(c),
                                   std::span(workspace).first(w))
        .status();
  };
  EXPECT_EQ(call(100, 100, 15), (Status{Error::too_small, Argument::workspace, 16}));
  EXPECT_EQ(call(7, 100, 16), (Status{Error::too_small, Argument::vertices, 8}));
  EXPECT_EQ(call(8, 1, 16), (Status{Error::too_small, Argument::contours, 2}));
  EXPECT_TRUE(call(8, 2, 16).ok());
}

TEST(GreinerHormann, BadArgumentsAreNamed) {
  const Shape good{{{0, 0}, {9, 0}, {9, 9}}};
  for (const int bad : {INT_MIN, INT_MAX, boolean_limit + 1, -boolean_limit - 1}) {
    const Status outside{Error::out_of_domain, Argument::vertices};
    EXPECT_EQ(walked(BooleanRule::join, good, {{{0, 0}, {bad, 0}, {9, 9}}}).status, outside);
    EXPECT_EQ(walked(BooleanRule::join, {{{0, 0}, {9, bad}, {9, 9}}}, good).status, outside);
  }
  EXPECT_EQ(walked(static_cast<BooleanRule>(4), good, good).status,
            (Status{Error::out_of_range, Argument::rule}));
  const Flat flat(good);
  const std::vector<int> lengths{2};
  EXPECT_EQ(combine_greiner_hormann(BooleanRule::join, {flat.vertices, lengths}, flat.operand(), {}, {}, {})
                .status(),
            (Status{Error::mismatched, Argument::contours}));
}

}  // namespace
