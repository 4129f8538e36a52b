// SPDX-License-Identifier: MIT
//
// Three ways to fill a triangle give the same pixels. The first is compared with the oracle in triangle.cpp;
// near the limit of 32 bits the others are compared with the oracle here as well.
#include <intaglio/raster/triangle.hpp>
#include <intaglio/raster/triangle_box.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Rect;
using intaglio::linear::SubPoint;
using intaglio::raster::fill_triangle;
using intaglio::raster::fill_triangle_blocks;
using intaglio::raster::fill_triangle_box;
using oracle::RecordingSink;

constexpr int limit = 1 << 28;

std::string text(SubPoint p) { return "(" + std::to_string(p.x) + "," + std::to_string(p.y) + ")"; }

// What differs; empty if nothing does.
std::string difference(SubPoint a, SubPoint b, SubPoint c, const Rect& clip) {
  RecordingSink walk(clip);
  RecordingSink box(clip);
  RecordingSink blocks(clip);
  const std::string what = text(a) + text(b) + text(c) + "/256";
  if (!fill_triangle(walk, a, b, c).ok() || !fill_triangle_box(box, a, b, c).ok() ||
      !fill_triangle_blocks(blocks, a, b, c).ok())
    return what + ": refused";
  for (const RecordingSink* sink : {&box, &blocks}) {
    if (!sink->violation().empty()) return what + ": " + sink->violation();
    if (sink->all_writes() != walk.all_writes())
      return what + (sink == &box ? " box\n" : " blocks\n") + sink->ascii() + "walk\n" + walk.ascii();
    if (sink->spans() != walk.spans()) return what + ": spans are split";
  }
  return "";
}

TEST(TriangleRungs, AllTrianglesOnASmallGridAreEqual) {
  std::string first;
  for (int i = 0; i < 5 * 5 * 5 * 5 * 5 * 5 && first.empty(); ++i) {
    const auto digit = [i](int place) {
      int n = i;
      while (place-- > 0) n /= 5;
      return n % 5 * 256;
    };
    first = difference({digit(0), digit(1)}, {digit(2), digit(3)}, {digit(4), digit(5)}, {-1, -1, 7, 7});
  }
  EXPECT_EQ(first, "");
}

TEST(TriangleRungs, RandomTrianglesAndSliversAreEqualInAnyWindow) {
  oracle::Random random(2191);
  std::string first;
  for (int i = 0; i < 20000 && first.empty(); ++i) {
    const int bound = 256 << i % 7;
    const auto point = [&] { return SubPoint{random.between(-bound, bound), random.between(-bound, bound)}; };
    const SubPoint a = point();
    const SubPoint b = point();
    SubPoint c = point();
    if (i % 3 == 0) c = {(a.x + b.x) / 2 + random.between(-2, 2), (a.y + b.y) / 2 + random.between(-2, 2)};
    const Rect clip = i % 2 == 0 ? Rect{-33, -33, 67, 67}
                                 : Rect{random.between(-30, 20), random.between(-30, 20),
                                        random.between(0, 30), random.between(0, 30)};
    first = difference(a, b, c, clip);
  }
  EXPECT_EQ(first, "") << random.seed_text();
}

// Windows at a vertex or on an edge of triangles of any size up to the domain's edge; many of them just below
// and just above the bounding box up to which 32 bits do.
TEST(TriangleRungs, AreEqualAtTheLimitOf32BitsAndAtTheDomainsEdge) {
  oracle::Random random(2192);
  std::string first;
  int wrong = 0;
  for (int i = 0; i < 20000 && first.empty(); ++i) {
    const int side = i % 2 == 0 ? 2032 * 256 + random.between(-1, 1) : limit >> i % 17;
    const int left = random.between(-limit, limit - side);
    const int top = random.between(-limit, limit - side);
    const auto point = [&] {
      return SubPoint{left + random.between(0, 2) * (side / 2), top + random.between(0, 2) * (side / 2)};
    };
    SubPoint a = point();
    SubPoint b{left, top + (i % 4 < 2 ? side : random.between(0, side))};
    SubPoint c{left + side, top + random.between(0, side)};
    const int along = i % 5 == 0 ? 0 : i % 5 == 1 ? 1024 : random.between(0, 1024);
    const int x = static_cast<int>((b.x + (std::int64_t{c.x} - b.x) * along / 1024) / 256);
    const int y = static_cast<int>((b.y + (std::int64_t{c.y} - b.y) * along / 1024) / 256);
    constexpr int pixels = 1 << 20;
    const Rect clip{std::clamp(x - 10, -pixels, pixels), std::clamp(y - 9, -pixels, pixels), 21, 19};
    first = difference(a, b, c, clip);
    if (i % 20 != 0) continue;
    RecordingSink sink(clip);
    ASSERT_TRUE(fill_triangle_blocks(sink, a, b, c).ok());
    for (int py = clip.y; py < clip.bottom(); ++py)
      for (int px = clip.x; px < clip.right(); ++px)
        wrong += sink.writes(px, py) == (oracle::in_triangle(a, b, c, px, py) ? 1 : 0) ? 0 : 1;
  }
  EXPECT_EQ(first, "") << random.seed_text();
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(TriangleRungs, WholeTrianglesOfTheLargestSize32BitsHoldAreEqual) {
  constexpr int side = 2032 * 256;
  for (const int size : {side, side + 1}) {
    const Rect clip{-4, -4, 2045, 2045};
    EXPECT_EQ(difference({0, 0}, {size, 0}, {0, size}, clip), "");
    EXPECT_EQ(difference({size, size}, {size, 0}, {0, size}, clip), "");
    EXPECT_EQ(difference({0, 0}, {size, 1}, {size, size}, clip), "");
  }
}

TEST(TriangleRungs, BadArgumentsAreNamedAndNothingIsDrawn) {
  RecordingSink sink({0, 0, 8, 8});
  const Status expected{Error::out_of_domain, Argument::point};
  for (const int bad : {limit + 1, -limit - 1, INT_MAX, INT_MIN}) {
    EXPECT_EQ(fill_triangle_box(sink, {bad, 0}, {9999, 0}, {0, 9999}), expected);
    EXPECT_EQ(fill_triangle_blocks(sink, {0, 0}, {9999, bad}, {0, 9999}), expected);
  }
  EXPECT_EQ(sink.spans(), 0);
  RecordingSink nowhere({3, 3, 0, 0});
  EXPECT_TRUE(fill_triangle_box(nowhere, {0, 0}, {9999, 0}, {0, 9999}).ok());
  EXPECT_TRUE(fill_triangle_blocks(nowhere, {0, 0}, {9999, 0}, {0, 9999}).ok());
  EXPECT_EQ(nowhere.spans(), 0);
}

}  // namespace
