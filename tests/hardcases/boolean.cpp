// SPDX-License-Identifier: MIT
//
// Pairs of polygons that broke other libraries. The areas were found by exact oracles, apart from this
// library.
#include <tests/clip/combine.hpp>

#include <gtest/gtest.h>

namespace {

using tests::BooleanRule;
using tests::combined;
using tests::exact_area;
using tests::Shape;

mpq_class area(BooleanRule rule, const Shape& a, const Shape& b) {
  mpq_class found = combined(rule, a, b).area();
  EXPECT_EQ(found, exact_area(rule, a, b));
  return found;
}

TEST(BooleanHardCases, Clipper2Issue309OneRegionOfPositiveArea) {
  const Shape a{{{375, 15}, {192, 32}, {192, 0}}};
  const Shape b{{{53, 139}, {53, 29}, {234, 28}, {483, 24}}};
  EXPECT_EQ(area(BooleanRule::intersection, a, b), mpq_class(5721126, 70409));
  EXPECT_EQ(combined(BooleanRule::intersection, a, b).contours.size(), 1U);
}

TEST(BooleanHardCases, Clipper2Issue318AreaIsPositive) {
  const Shape a{{{138, 0}, {469, 0}, {469, 369}, {138, 291}}};
  const Shape b{{{376, 209}, {317, 371}, {251, 546}, {336, 318}}};
  EXPECT_EQ(area(BooleanRule::intersection, a, b), mpq_class(3104264089, 132779832));
}

TEST(BooleanHardCases, Clipper2Issue282IntersectionIsntEmpty) {
  const Shape a{{{4, 1}, {9, 5}, {0, 5}}};
  const Shape b{{{1, 4}, {7, 6}, {3, 6}}};
  EXPECT_EQ(area(BooleanRule::intersection, a, b), 1);
  EXPECT_EQ(area(BooleanRule::join, a, b), 21);
}

TEST(BooleanHardCases, Clipper2Issue923RectangleWithAContourThatFoldsBack) {
  const Shape contour{{{31, 16}, {22, 12}, {7, 12}, {7, 17}, {8, 17}, {8, 12}}};
  EXPECT_EQ(area(BooleanRule::intersection, {{{25, 9}, {31, 9}, {31, 16}, {25, 16}}}, contour),
            mpq_class(112, 23));
  EXPECT_EQ(area(BooleanRule::intersection, {{{26, 10}, {30, 10}, {30, 15}, {26, 15}}}, contour),
            mpq_class(121, 72));
}

TEST(BooleanHardCases, Clipper2Issue1027KeepsTheSharedVertex) {
  const Shape a{{{-4726, -4050}, {-4726, 25150}, {-45526, 25150}, {-45526, -45476}, {-4124, -45476}}};
  const Shape b{{{-4124, -45476}, {-5153, 25304}, {-45526, 25150}, {-45526, -45476}}};
  EXPECT_EQ(area(BooleanRule::a_minus_b, a, b), mpq_class(219785715961, 35390));
}

TEST(BooleanHardCases, MartinezIssue10SquaresThatTouchAlongAnEdge) {
  const Shape a{{{0, 0}, {3, 0}, {3, 3}, {0, 3}}};
  const Shape b{{{3, 1}, {4, 1}, {4, 2}, {3, 2}}};
  EXPECT_EQ(area(BooleanRule::join, a, b), 10);
  EXPECT_EQ(combined(BooleanRule::join, a, b).contours.size(), 1U);
  EXPECT_EQ(area(BooleanRule::a_minus_b, a, b), 9);
  EXPECT_EQ(combined(BooleanRule::a_minus_b, a, b).contours.at(0).size(), 4U);
}

}  // namespace
