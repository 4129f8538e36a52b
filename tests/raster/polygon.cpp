// SPDX-License-Identifier: MIT
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/triangle.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/raster/contours.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Rect;
using intaglio::linear::SubPoint;
using intaglio::raster::fill_polygon;
using intaglio::raster::fill_triangle;
using intaglio::raster::FillRule;
using intaglio::raster::polygon_workspace;
using intaglio::raster::PolygonEdge;
using oracle::Contours;
using oracle::Random;
using oracle::RecordingSink;
using tests::flat;
using tests::FlatContours;
using tests::random_contour;
using tests::text;

constexpr int limit = 1 << 28;

// What is wrong with the polygon in this window, by either rule; empty if nothing is. The workspace is
// exactly as large as the library says it must be.
std::string fault(const Contours& contours, const Rect& clip) {
  const FlatContours polygon = flat(contours);
  const auto needed = polygon_workspace(polygon.vertices, polygon.lengths, clip);
  if (!needed.ok()) return text(contours) + ": no workspace";
  if (needed.value() > polygon.vertices.size()) return text(contours) + ": more edges than vertices";
  std::vector<PolygonEdge> workspace(needed.value());
  for (const bool even_odd : {true, false}) {
    RecordingSink sink(clip);
    const auto rule = even_odd ? FillRule::even_odd : FillRule::non_zero;
    if (!fill_polygon(sink, rule, polygon.vertices, polygon.lengths, workspace).ok())
      return text(contours) + ": refused";
    if (!sink.violation().empty()) return text(contours) + ": " + sink.violation();
    if (sink.all_writes() != oracle::polygon_pixels(contours, even_odd, clip))
      return text(contours) + (even_odd ? " even-odd\n" : " non-zero\n") + sink.ascii();
  }
  return "";
}

TEST(PolygonOracle, RowsAgreeWithPixels) {
  Random random(49);
  for (int i = 0; i < 1500; ++i) {
    Contours contours;
    for (int n = 0; n <= i % 3; ++n)
      contours.push_back(i % 2 == 0 ? tests::random_walk(random, random.between(0, 12))
                                    : random_contour(random, random.between(0, 9), 1500 << i % 8, 1));
    for (int y = -3; y < 7; ++y) {
      const std::vector<int> row = oracle::winding_row(contours, -4, 12, y);
      for (int x = -4; x < 8; ++x)
        ASSERT_EQ(row[static_cast<std::size_t>(x + 4)], oracle::winding(contours, x, y)) << text(contours);
    }
  }
}

TEST(Polygon, RandomSelfIntersectingContoursAreExactByBothRules) {
  Random random(50);
  std::string first_fault;
  for (int i = 0; i < 2500 && first_fault.empty(); ++i) {
    const int step = i % 3 == 0 ? 256 : i % 3 == 1 ? 128 : 1;  // on pixel centres, between them, anywhere
    Contours contours;
    for (int n = 0; n <= i % 4; ++n)
      contours.push_back(random_contour(random, random.between(0, 11), 256 << random.between(0, 5), step));
    first_fault = fault(contours, {-17, -17, 35, 35});
  }
  EXPECT_EQ(first_fault, "") << random.seed_text();
}

TEST(Polygon, ContoursFullOfPlateausCollinearRunsAndRepeatedVerticesAreExact) {
  Random random(51);
  std::string first_fault;
  for (int i = 0; i < 2500 && first_fault.empty(); ++i) {
    Contours contours;
    for (int n = 0; n <= i % 3; ++n) contours.push_back(tests::random_walk(random, random.between(0, 19)));
    first_fault = fault(contours, {-1, -1, 11, 11});
  }
  EXPECT_EQ(first_fault, "") << random.seed_text();
}

TEST(Polygon, AnyWindowSeesTheUnclippedPolygonToTheDomainsEdge) {
  Random random(52);
  std::string first_fault;
  for (int i = 0; i < 6000 && first_fault.empty(); ++i) {
    const int bound = limit >> i % 19;
    Contours contours;
    for (int n = 0; n <= i % 2; ++n)
      contours.push_back(random_contour(random, random.between(3, 12), bound, 1));
    first_fault = fault(
        contours, tests::window_on_edge(contours[0][0], contours[0][1], random.between(0, 1024), 14, 11));
  }
  EXPECT_EQ(first_fault, "") << random.seed_text();
}

TEST(Polygon, SmallPolygonsInEveryWindowAreTheUnclippedOnesRestricted) {
  Random random(53);
  std::string first_fault;
  for (int i = 0; i < 40; ++i) {
    const Contours contours{random_contour(random, 7, 5 * 256, 1), random_contour(random, 4, 5 * 256, 256)};
    for (int y = -7; y <= 6; ++y)
      for (int x = -7; x <= 6; ++x)
        for (const Rect clip : {Rect{x, y, 1, 1}, Rect{x, y, 3, 2}, Rect{x, y, 8, 8}})
          if (first_fault.empty()) first_fault = fault(contours, clip);
  }
  EXPECT_EQ(first_fault, "") << random.seed_text();
}

TEST(Polygon, EqualsAnyTriangulationOfItPixelByPixel) {
  Random random(54);
  for (int i = 0; i < 300; ++i) {
    // A convex ring: sorted by angle around the centre of an ellipse, on sub-pixels.
    std::vector<SubPoint> ring;
    for (int part = 0; part < 12; ++part) {
      static constexpr int cosine[] = {256, 222, 128, 0, -128, -222, -256, -222, -128, 0, 128, 222};
      const int radius = 256 * 18;
      ring.push_back({cosine[part] * radius / 256 + random.between(0, 199),
                      cosine[(part + 9) % 12] * radius / 256 + random.between(0, 199)});
    }
    const Rect clip{-22, -22, 45, 45};
    RecordingSink whole(clip);
    RecordingSink fan(clip);
    std::vector<PolygonEdge> workspace(ring.size());
    ASSERT_TRUE(fill_polygon(whole, FillRule::non_zero, ring, workspace).ok());
    // From a vertex, another one each time.
    const std::size_t hub = static_cast<std::size_t>(i) % 12;
    for (std::size_t k = 1; k + 1 < 12; ++k)
      ASSERT_TRUE(fill_triangle(fan, ring[hub], ring[(hub + k) % 12], ring[(hub + k + 1) % 12]).ok());
    ASSERT_GT(whole.touched(), 900);
    ASSERT_EQ(whole.all_writes(), fan.all_writes()) << random.seed_text() << ", ring " << i << "\n"
                                                    << fan.ascii();
  }
}

TEST(Polygon, HolesShareTheirBorderWithWhatFillsThem) {
  const std::vector<SubPoint> outer{{100, 50}, {9000, 700}, {8000, 8200}, {300, 7900}};
  const std::vector<SubPoint> inner{{2000, 2100}, {5000, 1900}, {6100, 6000}, {1800, 5000}};
  const Rect clip{0, 0, 40, 40};
  RecordingSink both(clip);
  const FlatContours holed = flat({outer, inner});
  std::vector<PolygonEdge> workspace(8);
  ASSERT_TRUE(fill_polygon(both, FillRule::even_odd, holed.vertices, holed.lengths, workspace).ok());
  ASSERT_TRUE(fill_polygon(both, FillRule::even_odd, inner, workspace).ok());
  RecordingSink whole(clip);
  ASSERT_TRUE(fill_polygon(whole, FillRule::even_odd, outer, workspace).ok());
  EXPECT_EQ(both.all_writes(), whole.all_writes()) << both.ascii();
}

TEST(Polygon, ThousandsOfCrossingEdgesAreExact) {
  Random random(55);
  EXPECT_EQ(fault({random_contour(random, 1500, 64 * 256, 1)}, {-20, -20, 40, 40}), "") << random.seed_text();
}

TEST(Polygon, EdgesWithoutVisibleRowsTakeNoWorkspace) {
  const Rect clip{0, 0, 320, 240};
  const auto needed = [&](const Contours& contours) {
    const FlatContours polygon = flat(contours);
    return polygon_workspace(polygon.vertices, polygon.lengths, clip).value();
  };
  // A coast far outside: above, below, right; and a long one at the left that winds around the window's side.
  std::vector<SubPoint> above;
  std::vector<SubPoint> right;
  std::vector<SubPoint> left;
  for (int i = 0; i < 1400; ++i) {
    above.push_back({i * 977 % 300000, -300 - i * 31 % 90000});
    right.push_back({82000 + i * 977 % 300000, i * 31});
    left.push_back({-i * 977 % 300000, i * 31 + i % 2 * 600});
  }
  EXPECT_EQ(needed({above}), 0U);
  EXPECT_EQ(needed({right}), 0U);
  left.push_back({40000, 43000});
  EXPECT_LE(needed({left}), 3U);
}

TEST(Polygon, TooSmallAWorkspaceSaysHowMuchAndDrawsNothing) {
  const std::vector<SubPoint> square{{0, 0}, {2560, 0}, {2565, 2560}, {5, 2560}};
  std::vector<PolygonEdge> one(1);
  RecordingSink sink({0, 0, 20, 20});
  const Status status = fill_polygon(sink, FillRule::even_odd, square, one);
  EXPECT_EQ(status.error(), Error::too_small);
  EXPECT_EQ(status.argument(), Argument::workspace);
  EXPECT_EQ(status.needed(), 2U);  // the two upright edges; level ones have no rows
  EXPECT_EQ(sink.spans(), 0);
  std::vector<PolygonEdge> enough(status.needed());
  EXPECT_TRUE(fill_polygon(sink, FillRule::even_odd, square, enough).ok());
  EXPECT_GT(sink.touched(), 0);
}

TEST(Polygon, BadArgumentsAreNamedAndNothingIsDrawn) {
  RecordingSink sink({0, 0, 20, 20});
  std::vector<PolygonEdge> workspace(16);
  std::vector<SubPoint> square{{0, 0}, {2560, 0}, {2560, 2560}, {0, 2560}};
  const auto draw = [&](std::vector<int> lengths, FillRule rule = FillRule::even_odd) {
    return fill_polygon(sink, rule, square, lengths, workspace);
  };
  EXPECT_EQ(draw({5}), (Status{Error::mismatched, Argument::contours}));
  EXPECT_EQ(draw({3}), (Status{Error::mismatched, Argument::contours}));
  EXPECT_EQ(draw({}), (Status{Error::mismatched, Argument::contours}));
  EXPECT_EQ(draw({INT_MAX, INT_MAX, 6}), (Status{Error::mismatched, Argument::contours}));
  EXPECT_EQ(draw({5, -1}), (Status{Error::mismatched, Argument::contours}));
  EXPECT_EQ(draw({-1, 5}), (Status{Error::mismatched, Argument::contours}));
  EXPECT_EQ(draw({4}, static_cast<FillRule>(2)), (Status{Error::out_of_range, Argument::rule}));
  for (const int bad : {limit + 1, -limit - 1, INT_MAX, INT_MIN}) {
    square[2].y = bad;
    EXPECT_EQ(draw({4}), (Status{Error::out_of_domain, Argument::vertices}));
  }
  EXPECT_EQ(sink.spans(), 0);
  square[2].y = 2560;
  EXPECT_EQ(polygon_workspace(square, std::vector<int>{4}, {INT_MAX, 0, 5, 5}).status(),
            (Status{Error::out_of_domain, Argument::rectangle}));
  EXPECT_EQ(polygon_workspace(square, std::vector<int>{2}, {0, 0, 5, 5}).status(),
            (Status{Error::mismatched, Argument::contours}));
}

TEST(Polygon, ContoursOfFewerThanThreeVerticesAreEmpty) {
  RecordingSink sink({-5, -5, 20, 20});
  std::vector<PolygonEdge> workspace(4);
  const std::vector<SubPoint> vertices{{0, 0}, {0, 2560}, {9, 9}};
  EXPECT_TRUE(fill_polygon(sink, FillRule::non_zero, vertices, std::vector<int>{0, 2, 1, 0}, workspace).ok());
  EXPECT_TRUE(fill_polygon(sink, FillRule::non_zero, {}, workspace).ok());
  EXPECT_EQ(sink.spans(), 0);
}

}  // namespace
