// SPDX-License-Identifier: MIT
//
// Three ways to fill a triangle give the pixels of the oracle, a span a row.
#include <intaglio/raster/triangle.hpp>
#include <intaglio/raster/triangle_box.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/oracle/span_list.hpp>
#include <tests/raster/contours.hpp>

#include <climits>
#include <gtest/gtest.h>

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
using oracle::SpanList;

constexpr int limit = 1 << 28;

// What is wrong with the triangle in this window; empty if nothing is.
std::string fault(SubPoint a, SubPoint b, SubPoint c, const Rect& clip) {
  const std::vector<oracle::Span> expected = oracle::triangle_spans(a, b, c, clip);
  SpanList walk(clip);
  SpanList box(clip);
  SpanList blocks(clip);
  const bool drawn = fill_triangle(walk, a, b, c).ok() && fill_triangle_box(box, a, b, c).ok() &&
                     fill_triangle_blocks(blocks, a, b, c).ok();
  const char* const wrong = !drawn                       ? "refused"
                            : walk.spans() != expected   ? "edge walking"
                            : box.spans() != expected    ? "bounding box"
                            : blocks.spans() != expected ? "blocks"
                                                         : nullptr;
  return wrong == nullptr ? "" : tests::text({{a, b, c}}) + ": " + wrong;
}

TEST(TriangleRungs, AllTrianglesOnASmallGridAreEqual) {
  std::string first;
  for (int i = 0; i < 5 * 5 * 5 * 5 * 5 * 5 && first.empty(); ++i) {
    const auto digit = [i](int place) {
      int n = i;
      while (place-- > 0) n /= 5;
      return n % 5 * 256;
    };
    first = fault({digit(0), digit(1)}, {digit(2), digit(3)}, {digit(4), digit(5)}, {-1, -1, 7, 7});
  }
  EXPECT_EQ(first, "");
}

TEST(TriangleRungs, RandomTrianglesAndSliversAreEqualInAnyWindow) {
  oracle::Random random(2191);
  std::string first;
  for (int i = 0; i < oracle::samples(20000, 500000) && first.empty(); ++i) {
    const int bound = 256 << i % 7;
    const auto point = [&] { return SubPoint{random.between(-bound, bound), random.between(-bound, bound)}; };
    const SubPoint a = point();
    const SubPoint b = point();
    SubPoint c = point();
    if (i % 3 == 0) c = {(a.x + b.x) / 2 + random.between(-2, 2), (a.y + b.y) / 2 + random.between(-2, 2)};
    const Rect clip = i % 2 == 0 ? Rect{-33, -33, 67, 67}
                                 : Rect{random.between(-30, 20), random.between(-30, 20),
                                        random.between(0, 30), random.between(0, 30)};
    first = fault(a, b, c, clip);
  }
  EXPECT_EQ(first, "") << random.seed_text();
}

// Windows at a vertex or on an edge of triangles of any size up to the domain's edge; many of them just below
// and just above the bounding box up to which 32 bits do.
TEST(TriangleRungs, AreEqualAtTheLimitOf32BitsAndAtTheDomainsEdge) {
  oracle::Random random(2192);
  std::string first;
  for (int i = 0; i < oracle::samples(20000, 500000) && first.empty(); ++i) {
    const int side = i % 2 == 0 ? 2032 * 256 + random.between(-1, 1) : limit >> i % 17;
    const int left = random.between(-limit, limit - side);
    const int top = random.between(-limit, limit - side);
    SubPoint a{left + random.between(0, 2) * (side / 2), top + random.between(0, 2) * (side / 2)};
    if (i % 3 == 0) a = {left + random.between(0, side), top + random.between(0, side)};
    const SubPoint b{left, top + (i % 4 < 2 ? side : random.between(0, side))};
    const SubPoint c{left + side, top + random.between(0, side)};
    const int along = i % 5 == 0 ? 0 : i % 5 == 1 ? 1024 : random.between(0, 1024);
    first = fault(
        a, b, c,
        i % 7 == 0 ? tests::window_on_edge(a, b, along, 21, 19) : tests::window_on_edge(b, c, along, 21, 19));
  }
  EXPECT_EQ(first, "") << random.seed_text();
}

TEST(TriangleRungs, WholeTrianglesOfTheLargestSize32BitsHoldAreEqual) {
  constexpr int side = 2032 * 256;
  for (const int size : {side, side + 1}) {
    const Rect clip{-4, -4, 2045, 2045};
    EXPECT_EQ(fault({0, 0}, {size, 0}, {0, size}, clip), "");
    EXPECT_EQ(fault({size, size}, {size, 0}, {0, size}, clip), "");
    EXPECT_EQ(fault({0, 0}, {size, 1}, {size, size}, clip), "");
  }
}

TEST(TriangleRungs, BadArgumentsAreNamedAndNothingIsDrawn) {
  SpanList sink({0, 0, 8, 8});
  const Status expected{Error::out_of_domain, Argument::point};
  for (const int bad : {limit + 1, -limit - 1, INT_MAX, INT_MIN}) {
    EXPECT_EQ(fill_triangle_box(sink, {bad, 0}, {9999, 0}, {0, 9999}), expected);
    EXPECT_EQ(fill_triangle_blocks(sink, {0, 0}, {9999, bad}, {0, 9999}), expected);
  }
  EXPECT_EQ(sink.spans().size(), 0U);
  SpanList nowhere({3, 3, 0, 0});
  EXPECT_TRUE(fill_triangle_box(nowhere, {0, 0}, {9999, 0}, {0, 9999}).ok());
  EXPECT_TRUE(fill_triangle_blocks(nowhere, {0, 0}, {9999, 0}, {0, 9999}).ok());
  EXPECT_EQ(nowhere.spans().size(), 0U);
}

}  // namespace
