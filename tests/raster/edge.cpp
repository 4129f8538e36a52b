// SPDX-License-Identifier: MIT
#include <intaglio/raster/edge.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>

namespace {

using intaglio::linear::SubPoint;
using intaglio::raster::ceil_to_pixel;
using intaglio::raster::Edge;

constexpr int limit = 1 << 28;

// The first column whose centre isn't left of the edge, by a rational that is searched for, not computed.
int first_column(SubPoint top, SubPoint bottom, int row) {
  __extension__ using Int = __int128;
  const Int dy = Int{bottom.y} - top.y;
  const Int crossing = Int{top.x} * dy + (Int{bottom.x} - top.x) * (Int{row} * 256 - top.y);  // x * dy
  int column = -(1 << 21);
  for (int step = 1 << 22; step > 0; step /= 2)
    if (Int{column + step - 1} * 256 * dy < crossing) column += step;
  return column;
}

SubPoint random_point(std::mt19937& random, int bound) {
  std::uniform_int_distribution<int> coordinate(-bound, bound);
  return {coordinate(random), coordinate(random)};
}

TEST(Edge, StartsExactlyOnAnyRowOfTheDomain) {
  std::mt19937 random(20);
  for (int i = 0; i < 200000; ++i) {
    SubPoint top = random_point(random, limit >> i % 24);
    SubPoint bottom = random_point(random, limit >> (i / 24) % 24);
    if (top.y > bottom.y) std::swap(top, bottom);
    const int first = ceil_to_pixel(top.y);
    const int rows = ceil_to_pixel(bottom.y) - first;
    if (rows <= 0) continue;
    const int row = first + static_cast<int>(random() % static_cast<unsigned>(rows));
    ASSERT_EQ(Edge(top, bottom, row).x(), first_column(top, bottom, row))
        << "seed 20, edge " << i << ": " << top.x << "," << top.y << " " << bottom.x << "," << bottom.y
        << " row " << row;
  }
}

TEST(Edge, SingleStepsEqualOneJump) {
  std::mt19937 random(21);
  for (int i = 0; i < 400; ++i) {
    SubPoint top = random_point(random, limit >> i % 20);
    SubPoint bottom = random_point(random, limit >> i % 20);
    if (top.y > bottom.y) std::swap(top, bottom);
    const int first = ceil_to_pixel(top.y);
    const int end = std::min(ceil_to_pixel(bottom.y), first + 3000);
    if (first >= end) continue;
    Edge walked(top, bottom, first);
    for (int row = first; row < end; ++row, walked.next())
      ASSERT_EQ(walked.x(), Edge(top, bottom, row).x()) << "seed 21, edge " << i << " row " << row;
  }
}

TEST(Edge, AMillionStepsDontDrift) {
  for (const int dx : {1, -1, 255, -257, 123456789, -268435455}) {
    const SubPoint top{0, -limit};
    const SubPoint bottom{dx, limit - 1};
    const int first = ceil_to_pixel(top.y);
    const int last = ceil_to_pixel(bottom.y) - 1;
    Edge walked(top, bottom, first);
    for (int row = first; row < last; ++row) walked.next();
    EXPECT_EQ(walked.x(), first_column(top, bottom, last)) << dx;
  }
}

TEST(Edge, WorstEdgesOfTheDomainDontOverflow) {
  for (const SubPoint top :
       {SubPoint{-limit, -limit}, SubPoint{limit, -limit}, SubPoint{limit - 1, -limit + 1}})
    for (const SubPoint bottom :
         {SubPoint{-limit, limit}, SubPoint{limit, limit}, SubPoint{1 - limit, limit - 1}})
      for (const int row : {(-limit / 256) + 1, -1, 0, 1, limit / 256 - 1})
        EXPECT_EQ(Edge(top, bottom, row).x(), first_column(top, bottom, row)) << row;
  // Nearly level: one row, and a slope of 2^29 columns a row.
  EXPECT_EQ(Edge({-limit, -1}, {limit, 1}, 0).x(), first_column({-limit, -1}, {limit, 1}, 0));
  EXPECT_EQ(Edge({limit, 0}, {-limit, 1}, 0).x(), limit / 256);
}

}  // namespace
