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

/// The area of all four combinations is exact, and what is left of a and what is taken from it make a.
void expect_exact(const Shape& a, const Shape& b) {
  for (const BooleanRule rule : tests::all_rules) {
    const tests::Combined result = combined(rule, a, b);
    ASSERT_TRUE(result.status.ok());
    ASSERT_EQ(result.area(), exact_area(rule, a, b)) << tests::text(a) << " with " << tests::text(b);
  }
  ASSERT_EQ(combined(BooleanRule::intersection, a, b).area() + combined(BooleanRule::a_minus_b, a, b).area(),
            combined(BooleanRule::join, a, {}).area());
}

// polygon-clipping #60: a vertex that lies on an edge but for the last bits. Degrees from (-91.413, 29.5315),
// in 2^-29; the vertex is tried on all places around, so that it is on both sides of the edge and on it.
TEST(BooleanHardCases, PolygonClippingIssue60AVertexNextToAnEdge) {
  for (int dx = -1; dx <= 1; ++dx)
    for (int dy = -1; dy <= 1; ++dy) {
      const Shape a{{{0, 0}, {-327174 + dx, -80531 + dy}, {-265375, -232089}}};
      const Shape b{{{0, 0}, {-387245, 66790}, {-283392, -187905}}};
      expect_exact(a, b);
    }
}
TEST(BooleanHardCases, PolygonClippingIssue60LongThinTriangles) {
  // 4096 to the unit.
  const Shape a{{{598528, -335380}, {99330, 159828}, {322833, -133306}}};
  const Shape b{{{318008, -196701}, {380748, -53381}, {215956, 135773}}};
  const auto half = [](Shape shape) {
    for (auto& p : shape[0]) p = {p.x / 2, p.y / 2};
    return shape;
  };
  expect_exact(half(a), half(b));
}

// polygon-clipping #141: "unable to complete output ring". 2^17 to the unit; the other triangles lie
// practically upon it.
TEST(BooleanHardCases, PolygonClippingIssue141TrianglesPracticallyUponEachOther) {
  const Shape a{{{9345, 157758}, {127887, 169673}, {140968, 215129}}};
  for (int i = 0; i < 729; i += 7) {
    Shape b = a;
    int digits = i;
    for (auto& p : b[0]) {
      p.x += digits % 3 - 1;
      p.y += digits / 3 % 3 - 1;
      digits /= 9;
    }
    expect_exact(a, b);
  }
}

// GEOS #1523: a hole as thin as rounding across which the other's edge runs. From (380, 3425), 60000 to the
// unit: the hole's height is less than one unit there, so it is tried as none and as one either way.
TEST(BooleanHardCases, GeosIssue1523SliverHole) {
  const Shape a{{{-18337, -120000}, {120000, -120000}, {120000, 180000}, {-18337, 180000}}};
  for (int height = -1; height <= 1; ++height) {
    const Shape b{{{0, 198000}, {120000, 240000}, {480000, -180000}, {-180000, -180000}, {-120000, 120000}},
                  {{-50778, 131983}, {44160, 131983}, {-13371, 131983 + height}}};
    expect_exact(a, b);
    const tests::Combined left = combined(BooleanRule::a_minus_b, a, b);
    EXPECT_EQ(left.contours.size(), height == 0 ? 0U : 1U);
    EXPECT_EQ(left.area() > 0, height != 0);
    EXPECT_LT(left.area(), 44160 + 18337);
  }
}

// Earcut: polygons with holes keep their area; here as sets, pixels and parts.
void expect_area_is_kept(const Shape& outer, const Shape& holes) {
  Shape both = outer;
  both.insert(both.end(), holes.begin(), holes.end());
  const mpq_class area = exact_area(BooleanRule::a_minus_b, outer, holes);
  EXPECT_EQ(combined(BooleanRule::a_minus_b, outer, holes).area(), area);
  EXPECT_EQ(combined(BooleanRule::join, both, {}).area(), area);
  EXPECT_EQ(combined(BooleanRule::join, both, holes).area(), combined(BooleanRule::join, outer, {}).area());
}
TEST(BooleanHardCases, EarcutPull177HolesThatShareAVertex) {
  expect_area_is_kept({{{0, 0}, {20, 0}, {20, 25}, {0, 25}}},
                      {{{3, 3}, {2, 12}, {9, 15}}, {{9, 21}, {2, 12}, {7, 22}}});
}
TEST(BooleanHardCases, EarcutIssue147HolesThatShareParts) {
  expect_area_is_kept({{{-2428, 1634},
                        {-2425, 1471},
                        {-2409, 1156},
                        {-2384, 842},
                        {-2349, 529},
                        {-2303, 217},
                        {-2248, -92},
                        {-2183, -401},
                        {-2138, -588},
                        {-2138, -681},
                        {-2163, -681},
                        {-2163, -1570},
                        {-2138, -1570},
                        {-2138, -1708},
                        {2641, -1708},
                        {2641, -29},
                        {3200, -29},
                        {3200, 1634}}},
                      {{{-1845, -1692}, {-930, -1692}, {-930, -1387}, {-1845, -1387}},
                       {{-1235, -1387}, {-321, -1387}, {-321, -1083}, {-1235, -1083}},
                       {{-1540, -1083}, {-625, -1083}, {-625, -778}, {-1540, -778}}});
}
TEST(BooleanHardCases, EarcutIssue208CollinearVerticesHaveNoArea) {
  const Shape line{{{1, 2}, {13, 26}, {25, 50}, {37, 74}}};
  EXPECT_TRUE(combined(BooleanRule::join, line, {}).contours.empty());
  expect_area_is_kept({{{0, 0}, {50, 0}, {50, 80}, {0, 80}}}, line);
}

}  // namespace
