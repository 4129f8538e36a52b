// SPDX-License-Identifier: MIT
#include <intaglio/linear/rect.hpp>

#include <gtest/gtest.h>

namespace {

using intaglio::linear::in_domain;
using intaglio::linear::intersect;
using intaglio::linear::Rect;

TEST(Rect, ContainsItsCornerButNotItsFarEdges) {
  constexpr Rect r{-2, 3, 4, 5};
  EXPECT_TRUE(r.contains({-2, 3}));
  EXPECT_TRUE(r.contains({1, 7}));
  EXPECT_FALSE(r.contains({2, 3}));
  EXPECT_FALSE(r.contains({-2, 8}));
  EXPECT_FALSE(r.contains({-3, 3}));
}

TEST(Rect, NegativeExtentContainsNothing) { EXPECT_FALSE((Rect{0, 0, -1, 5}.contains({-1, 0}))); }

TEST(Rect, IntersectionEqualsTheCommonPixels) {
  for (int ax = -2; ax < 3; ++ax)
    for (int aw = 0; aw < 4; ++aw)
      for (int bx = -2; bx < 3; ++bx)
        for (int bw = 0; bw < 4; ++bw) {
          const Rect a{ax, bx, aw, bw}, b{bx, ax, bw, aw}, c = intersect(a, b);
          for (int y = -4; y < 8; ++y)
            for (int x = -4; x < 8; ++x)
              EXPECT_EQ(c.contains({x, y}), a.contains({x, y}) && b.contains({x, y}));
        }
}

TEST(Domain, EndsAtTwoToTheTwenty) {
  constexpr int limit = 1 << 20;
  EXPECT_TRUE(in_domain(limit));
  EXPECT_TRUE(in_domain(-limit));
  EXPECT_FALSE(in_domain(limit + 1));
  EXPECT_FALSE(in_domain(-limit - 1));
  EXPECT_FALSE(in_domain(2147483647));
  EXPECT_FALSE(in_domain(-2147483647 - 1));
}

}  // namespace
