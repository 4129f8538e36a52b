// SPDX-License-Identifier: MIT
#include <intaglio/clip/line_window.hpp>
#include <tests/clip/line_window_difference.hpp>
#include <tests/oracle/integer.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/samples.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::clip::ClippedLine;
using intaglio::clip::cohen_sutherland;
using intaglio::clip::FractionPoint;
using intaglio::clip::liang_barsky;
using intaglio::clip::region_code;
using intaglio::clip::skala;
using intaglio::clip::skala_edges;
using intaglio::linear::SubPoint;
using intaglio::linear::SubRect;
using intaglio::number::Fraction;
using tests::difference;

constexpr int limit = 1 << 28;

std::string text(SubPoint a, SubPoint b, const SubRect& w) {
  const auto n = [](int v) { return std::to_string(v) + " "; };
  return n(a.x) + n(a.y) + "to " + n(b.x) + n(b.y) + "in " + n(w.x) + n(w.y) + n(w.width) + n(w.height);
}

TEST(LineWindow, ExampleOfTheTextbook) {
  // (1/2, 1/2) to (3, 3) in the window 1 .. 4.
  const auto line = liang_barsky({128, 128}, {768, 768}, {256, 256, 768, 768});
  ASSERT_TRUE(line.ok());
  EXPECT_TRUE(line.value().visible);
  EXPECT_EQ(line.value().enter.numerator, 1);
  EXPECT_EQ(line.value().enter.denominator, 5);
  EXPECT_EQ(line.value().leave.numerator, 1);
  EXPECT_EQ(line.value().leave.denominator, 1);
  EXPECT_EQ(nearest(line.value().from), (SubPoint{256, 256}));
  EXPECT_EQ(nearest(line.value().to), (SubPoint{768, 768}));
  EXPECT_EQ(difference({128, 128}, {768, 768}, {256, 256, 768, 768}), "");
}

TEST(LineWindow, RegionCodesOfTheTextbook) {
  const SubRect window{10, 10, 10, 10};
  EXPECT_EQ(region_code({15, 25}, window), 0b1000U);
  EXPECT_EQ(region_code({15, 5}, window), 0b0100U);
  EXPECT_EQ(region_code({25, 15}, window), 0b0010U);
  EXPECT_EQ(region_code({5, 15}, window), 0b0001U);
  EXPECT_EQ(region_code({5, 5}, window), 0b0101U);
  for (const SubPoint inside : {SubPoint{10, 10}, SubPoint{20, 20}, SubPoint{15, 12}})
    EXPECT_EQ(region_code(inside, window), 0U);
  // a = 0001 and b = 0101 share a bit: rejected. c and d have none: accepted.
  EXPECT_FALSE(cohen_sutherland({5, 15}, {5, 5}, window).value().visible);
  const ClippedLine whole = cohen_sutherland({12, 13}, {19, 20}, window).value();
  EXPECT_TRUE(whole.visible);
  EXPECT_EQ(whole.enter, (Fraction{0, 1}));
  EXPECT_EQ(whole.leave, (Fraction{1, 1}));
}

TEST(LineWindow, SkalasTableNamesTheEdgesWhoseEndsDiffer) {
  EXPECT_EQ(skala_edges(0b0100), 0b0110U);  // v2 alone: the edges v1v2 and v2v3
  for (unsigned corners = 0; corners < 16; ++corners) {
    unsigned edges = 0;
    for (unsigned i = 0; i < 4; ++i)
      if ((corners >> i & 1U) != (corners >> (i + 1) % 4 & 1U)) edges |= 1U << i;
    EXPECT_EQ(skala_edges(corners), edges) << corners;
  }
}

TEST(LineWindow, SkalasLineCrossesButTheSegmentEndsSooner) {
  EXPECT_EQ(difference({0, 0}, {4, 4}, {5, 5, 10, 10}), "");
  EXPECT_FALSE(skala({0, 0}, {4, 4}, {5, 5, 10, 10}).value().visible);
  EXPECT_TRUE(skala({0, 0}, {5, 5}, {5, 5, 10, 10}).value().visible);
}

// Every segment on a grid of 8 x 8 against every window on it, those without area and the empty ones
// included.
TEST(LineWindow, AgreesWithTheDefinitionOnEverySmallCase) {
  int cases = 0;
  for (int w = -1; w <= 3; ++w)
    for (int h = -1; h <= 3; ++h)
      for (int i = 0; i < 8 * 8 * 8 * 8; ++i) {
        const SubPoint a{i % 8, i / 8 % 8};
        const SubPoint b{i / 64 % 8, i / 512};
        const SubRect window{2, 3, w, h};
        const std::string wrong = difference(a, b, window);
        ASSERT_EQ(wrong, "") << text(a, b, window);
        ++cases;
      }
  EXPECT_EQ(cases, 25 * 4096);
}

TEST(LineWindow, AgreesWithTheDefinitionToTheEdgesOfTheDomain) {
  oracle::Random random(33);
  int seen = 0;
  for (int i = 0; i < oracle::samples(200000, 3000000); ++i) {
    const int reach = i % 3 == 0 ? limit : 1 << random.between(3, 28);
    const auto point = [&] { return SubPoint{random.between(-reach, reach), random.between(-reach, reach)}; };
    SubPoint a = point();
    SubPoint b = point();
    const SubPoint corner = point();
    SubRect window{corner.x, corner.y, random.between(0, reach), random.between(0, reach)};
    if (i % 5 == 0) b.y = a.y;
    if (i % 7 == 0) a.x = window.x;
    if (i % 11 == 0) b = {window.x, window.y};
    if (i % 101 == 0) window = {-limit, -limit, 2 * limit, 2 * limit};
    if (i % 103 == 0) window = {limit, limit, 2 * limit, 2 * limit};
    const std::string wrong = difference(a, b, window);
    ASSERT_EQ(wrong, "") << text(a, b, window) << random.seed_text();
    if (liang_barsky(a, b, window).value().visible) ++seen;
  }
  EXPECT_GT(seen, 30000);
}

TEST(LineWindow, RoundsPlacesOnceAndExactly) {
  oracle::Random random(34);
  int wrong = 0;
  for (int i = 0; i < oracle::samples(200000, 2000000); ++i) {
    const int d = i % 4 == 0 ? 2 : i % 9 == 0 ? 1 << 29 : random.between(1, 1 << random.between(0, 29));
    const auto numerator = [&] {
      const std::int64_t whole = random.between(-limit, limit - 1);
      return whole * d + random.between(0, d - 1);
    };
    const FractionPoint p{numerator(), numerator(), d};
    const SubPoint near = nearest(p);
    const SubPoint low = floor(p);
    if (near.x != oracle::nearest_quotient(p.x, d) || near.y != oracle::nearest_quotient(p.y, d)) ++wrong;
    if (low.x != oracle::floor_quotient(p.x, d) || low.y != oracle::floor_quotient(p.y, d)) ++wrong;
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(LineWindow, BadArgumentsAreNamed) {
  const SubRect window{0, 0, 10, 10};
  const Status point{Error::out_of_domain, Argument::point};
  const Status rectangle{Error::out_of_domain, Argument::rectangle};
  for (const auto clipper : {cohen_sutherland, skala, liang_barsky}) {
    for (const int bad : {INT_MIN, INT_MAX, limit + 1, -limit - 1}) {
      EXPECT_EQ(clipper({bad, 0}, {1, 1}, window).status(), point);
      EXPECT_EQ(clipper({0, 0}, {1, bad}, window).status(), point);
      EXPECT_EQ(clipper({0, 0}, {1, 1}, {bad, 0, 1, 1}).status(), rectangle);
    }
    for (const int bad : {INT_MIN, INT_MAX}) {
      EXPECT_EQ(clipper({0, 0}, {1, 1}, {0, 0, bad, 1}).status(), rectangle);
      EXPECT_EQ(clipper({0, 0}, {1, 1}, {0, 0, 1, bad}).status(), rectangle);
    }
    EXPECT_FALSE(clipper({0, 0}, {1, 1}, {0, 0, -2 * limit, 1}).value().visible);
  }
}

}  // namespace
