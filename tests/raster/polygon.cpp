// SPDX-License-Identifier: MIT
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/triangle.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/recording_sink.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
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
using oracle::RecordingSink;

constexpr int limit = 1 << 28;

struct Flat {
  std::vector<SubPoint> vertices;
  std::vector<int> lengths;
};

Flat flat(const Contours& contours) {
  Flat out;
  for (const auto& contour : contours) {
    out.vertices.insert(out.vertices.end(), contour.begin(), contour.end());
    out.lengths.push_back(static_cast<int>(contour.size()));
  }
  return out;
}

std::string text(const Contours& contours) {
  std::string out;
  for (const auto& contour : contours) {
    out += "[";
    for (const SubPoint p : contour) out += "(" + std::to_string(p.x) + "," + std::to_string(p.y) + ")";
    out += "]";
  }
  return out + "/256";
}

// What is wrong with the polygon in this window, by either rule; empty if nothing is. The workspace is
// exactly as large as the library says it must be.
std::string fault(const Contours& contours, const Rect& clip) {
  const Flat polygon = flat(contours);
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
    for (int y = clip.y; y < clip.bottom(); ++y)
      for (int x = clip.x; x < clip.right(); ++x)
        if (sink.writes(x, y) != (oracle::in_polygon(contours, even_odd, x, y) ? 1 : 0))
          return text(contours) + (even_odd ? " even-odd" : " non-zero") + ": pixel " + std::to_string(x) +
                 "," + std::to_string(y) + " drawn " + std::to_string(sink.writes(x, y)) + " times\n" +
                 sink.ascii();
  }
  return "";
}

oracle::Contour random_contour(std::mt19937& random, int vertices, int bound, int step) {
  std::uniform_int_distribution<int> coordinate(-bound, bound);
  oracle::Contour contour;
  for (int i = 0; i < vertices; ++i)
    contour.push_back({coordinate(random) / step * step, coordinate(random) / step * step});
  return contour;
}

TEST(Polygon, RandomSelfIntersectingContoursAreExactByBothRules) {
  constexpr unsigned seed = 50;
  std::mt19937 random(seed);
  std::string first_fault;
  for (int i = 0; i < 2500 && first_fault.empty(); ++i) {
    const int step = i % 3 == 0 ? 256 : i % 3 == 1 ? 128 : 1;  // on pixel centres, between them, anywhere
    Contours contours;
    for (int n = 0; n <= i % 4; ++n)
      contours.push_back(
          random_contour(random, static_cast<int>(random() % 12U), 256 << random() % 6U, step));
    first_fault = fault(contours, {-17, -17, 35, 35});
  }
  EXPECT_EQ(first_fault, "") << "seed " << seed;
}

TEST(Polygon, ContoursFullOfPlateausCollinearRunsAndRepeatedVerticesAreExact) {
  constexpr unsigned seed = 51;
  std::mt19937 random(seed);
  std::string first_fault;
  for (int i = 0; i < 2500 && first_fault.empty(); ++i) {
    // Steps along one axis or a diagonal on a coarse grid: vertices and edges coincide all the time.
    Contours contours(1 + static_cast<std::size_t>(i % 3));
    for (auto& contour : contours) {
      SubPoint p{static_cast<int>(random() % 9U) * 256, static_cast<int>(random() % 9U) * 256};
      for (auto n = random() % 20U; n > 0; --n) {
        contour.push_back(p);
        const int dx = (static_cast<int>(random() % 3U) - 1) * 512;
        const int dy = (static_cast<int>(random() % 3U) - 1) * 512;
        p = {std::clamp(p.x + dx, 0, 2048), std::clamp(p.y + dy, 0, 2048)};
      }
    }
    first_fault = fault(contours, {-1, -1, 11, 11});
  }
  EXPECT_EQ(first_fault, "") << "seed " << seed;
}

TEST(Polygon, AnyWindowSeesTheUnclippedPolygonToTheDomainsEdge) {
  constexpr unsigned seed = 52;
  std::mt19937 random(seed);
  std::string first_fault;
  for (int i = 0; i < 6000 && first_fault.empty(); ++i) {
    const int bound = limit >> i % 19;
    Contours contours;
    for (int n = 0; n <= i % 2; ++n)
      contours.push_back(random_contour(random, 3 + static_cast<int>(random() % 10U), bound, 1));
    const SubPoint a = contours[0][0];
    const SubPoint b = contours[0][1];
    const auto along = static_cast<int>(random() % 1025U);
    const int x = static_cast<int>((a.x + (std::int64_t{b.x} - a.x) * along / 1024) / 256);
    const int y = static_cast<int>((a.y + (std::int64_t{b.y} - a.y) * along / 1024) / 256);
    first_fault = fault(
        contours, {std::clamp(x - 7, -(1 << 20), 1 << 20), std::clamp(y - 5, -(1 << 20), 1 << 20), 14, 11});
  }
  EXPECT_EQ(first_fault, "") << "seed " << seed;
}

TEST(Polygon, SmallPolygonsInEveryWindowAreTheUnclippedOnesRestricted) {
  constexpr unsigned seed = 53;
  std::mt19937 random(seed);
  std::string first_fault;
  for (int i = 0; i < 40; ++i) {
    const Contours contours{random_contour(random, 7, 5 * 256, 1), random_contour(random, 4, 5 * 256, 256)};
    for (int y = -7; y <= 6; ++y)
      for (int x = -7; x <= 6; ++x)
        for (const Rect clip : {Rect{x, y, 1, 1}, Rect{x, y, 3, 2}, Rect{x, y, 8, 8}})
          if (first_fault.empty()) first_fault = fault(contours, clip);
  }
  EXPECT_EQ(first_fault, "") << "seed " << seed;
}

TEST(Polygon, EqualsAnyTriangulationOfItPixelByPixel) {
  constexpr unsigned seed = 54;
  std::mt19937 random(seed);
  for (int i = 0; i < 300; ++i) {
    // A convex ring: sorted by angle around the centre of an ellipse, on sub-pixels.
    std::vector<SubPoint> ring;
    for (int part = 0; part < 12; ++part) {
      static constexpr int cosine[] = {256, 222, 128, 0, -128, -222, -256, -222, -128, 0, 128, 222};
      const int radius = 256 * 18;
      ring.push_back({cosine[part] * radius / 256 + static_cast<int>(random() % 200U),
                      cosine[(part + 9) % 12] * radius / 256 + static_cast<int>(random() % 200U)});
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
    ASSERT_EQ(whole.all_writes(), fan.all_writes()) << "seed " << seed << ", ring " << i << "\n"
                                                    << fan.ascii();
  }
}

TEST(Polygon, HolesShareTheirBorderWithWhatFillsThem) {
  const std::vector<SubPoint> outer{{100, 50}, {9000, 700}, {8000, 8200}, {300, 7900}};
  const std::vector<SubPoint> inner{{2000, 2100}, {5000, 1900}, {6100, 6000}, {1800, 5000}};
  const Rect clip{0, 0, 40, 40};
  RecordingSink both(clip);
  const Flat holed = flat({outer, inner});
  std::vector<PolygonEdge> workspace(8);
  ASSERT_TRUE(fill_polygon(both, FillRule::even_odd, holed.vertices, holed.lengths, workspace).ok());
  ASSERT_TRUE(fill_polygon(both, FillRule::even_odd, inner, workspace).ok());
  RecordingSink whole(clip);
  ASSERT_TRUE(fill_polygon(whole, FillRule::even_odd, outer, workspace).ok());
  EXPECT_EQ(both.all_writes(), whole.all_writes()) << both.ascii();
}

TEST(Polygon, ThousandsOfCrossingEdgesAreExact) {
  constexpr unsigned seed = 55;
  std::mt19937 random(seed);
  EXPECT_EQ(fault({random_contour(random, 1500, 64 * 256, 1)}, {-20, -20, 40, 40}), "") << "seed " << seed;
}

TEST(Polygon, EdgesWithoutVisibleRowsTakeNoWorkspace) {
  const Rect clip{0, 0, 320, 240};
  const auto needed = [&](const Contours& contours) {
    const Flat polygon = flat(contours);
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
