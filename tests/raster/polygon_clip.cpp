// SPDX-License-Identifier: MIT
//
// What is drawn through a polygon is what is drawn without it, where the oracle says that the polygon is.
#include <intaglio/clip/clip_stack.hpp>
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/dash.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/pixel.hpp>
#include <intaglio/raster/polygon_clip.hpp>
#include <intaglio/raster/rectangle.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/raster/triangle.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace {

using namespace intaglio;
using linear::Point;
using linear::Rect;
using linear::SubPoint;
using oracle::RecordingSink;
using raster::FillRule;
using raster::PolygonClip;
using raster::PolygonClipped;
using raster::PolygonEdge;
using raster::RowSpan;

constexpr int width = 41;
constexpr int height = 31;
constexpr Rect all{0, 0, width, height};

/// A polygon, its memory, and the clip that the library makes of it.
struct Window {
  oracle::Contours contours;
  bool even_odd = true;
  std::vector<RowSpan> spans{};
  PolygonClip clip{};

  [[nodiscard]] bool has(int x, int y) const { return oracle::in_polygon(contours, even_odd, x, y); }

  Result<PolygonClip> make(const Rect& area, std::size_t edges, std::size_t rows) {
    std::vector<SubPoint> vertices;
    std::vector<int> lengths;
    for (const auto& contour : contours) {
      vertices.insert(vertices.end(), contour.begin(), contour.end());
      lengths.push_back(static_cast<int>(contour.size()));
    }
    std::vector<PolygonEdge> workspace(edges);
    spans.resize(rows);
    return PolygonClip::over(even_odd ? FillRule::even_odd : FillRule::non_zero, vertices, lengths, area,
                             workspace, spans);
  }
};

/// With exactly the memory that is asked for.
Window window_of(oracle::Contours contours, bool even_odd, const Rect& area = all) {
  Window window{std::move(contours), even_odd};
  std::size_t edges = 0;
  std::size_t spans = 0;
  for (int attempt = 0; attempt < 3; ++attempt) {
    const auto made = window.make(area, edges, spans);
    if (made.ok()) {
      window.clip = made.value();
      return window;
    }
    EXPECT_EQ(made.status().error(), Error::too_small);
    (made.status().argument() == Argument::workspace ? edges : spans) = made.status().needed();
  }
  ADD_FAILURE() << "refused what it asked for";
  return window;
}

Window random_window(oracle::Random& random, const Rect& area = all) {
  oracle::Contours contours(static_cast<std::size_t>(random.between(1, 2)));
  const bool whole = random.between(0, 1) == 0;
  for (auto& contour : contours) {
    contour.resize(static_cast<std::size_t>(random.between(3, 7)));
    for (SubPoint& p : contour) {
      p = {random.between(-256 * 8, 256 * (width + 8)), random.between(-256 * 8, 256 * (height + 8))};
      if (whole) p = {p.x / 256 * 256, p.y / 256 * 256};
    }
  }
  return window_of(contours, random.between(0, 1) == 0, area);
}

/// One of ten primitives, the same for the same numbers, on any sink. Most stick out of the picture.
struct Shape {
  int kind;
  Point a, b, c;
  int radius;

  explicit Shape(oracle::Random& random)
      : kind(random.between(0, 9)),
        a{random.between(-9, width + 9), random.between(-9, height + 9)},
        b{random.between(-9, width + 9), random.between(-9, height + 9)},
        c{random.between(-9, width + 9), random.between(-9, height + 9)},
        radius(random.between(0, 25)) {}

  template <class S>
  Status draw(S& sink) const {
    const Rect box{a.x, a.y, radius, b.x};
    switch (kind) {
      case 0:
        return raster::draw_pixel(sink, a);
      case 1:
        return raster::draw_line(sink, a, b);
      case 2:
        return raster::draw_dashed_line(sink, a, b, 1 + radius / 5, 2);
      case 3:
        return raster::draw_circle(sink, a, radius);
      case 4:
        return raster::fill_disc(sink, a, radius);
      case 5:
        return raster::fill_rect(sink, box);
      case 6:
        return raster::draw_rect(sink, box);
      case 7:
        return raster::fill_triangle(sink, a, b, c);
      case 8:
        return raster::draw_vertical(sink, a, 2 * radius);
      default:
        return raster::draw_horizontal(sink, a, 2 * radius);
    }
  }
};

TEST(PolygonClip, HoldsThePixelsThatTheFillDraws) {
  oracle::Random random(2401);
  for (int i = 0; i < 300; ++i) {
    const Window window = random_window(random);
    RecordingSink sink(all);
    PolygonClipped clipped(sink, window.clip);
    ASSERT_TRUE(raster::fill_rect(clipped, all).ok());
    ASSERT_EQ(sink.violation(), "");
    int wrong = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        wrong += static_cast<int>(sink.writes(x, y) != static_cast<int>(window.has(x, y)));
    ASSERT_EQ(wrong, 0) << i << ", " << random.seed_text() << "\n" << sink.ascii();
  }
}

TEST(PolygonClip, WhatIsDrawnThroughItIsTheUnclippedRestrictedToThePolygon) {
  oracle::Random random(2402);
  for (int i = 0; i < 200; ++i) {
    const Window window = random_window(random);
    for (int j = 0; j < 20; ++j) {
      const Shape shape(random);
      RecordingSink free(all);
      RecordingSink behind(all);
      PolygonClipped clipped(behind, window.clip);
      ASSERT_EQ(shape.draw(free), shape.draw(clipped));
      ASSERT_EQ(behind.violation(), "");
      int wrong = 0;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          wrong += static_cast<int>(behind.writes(x, y) != (window.has(x, y) ? free.writes(x, y) : 0));
      ASSERT_EQ(wrong, 0) << "shape " << shape.kind << ", " << random.seed_text() << "\n" << behind.ascii();
    }
  }
}

// The sinks that have cursors and blocks, and every write seen twice: exclusive-or.
template <class F>
void expect_same_on_a_surface() {
  oracle::Random random(2403);
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(F::row_bytes(width) * height));
  const auto surface = image::Surface<F>::over(bytes, {width, height}).value();
  for (int i = 0; i < 100; ++i) {
    const Window window = random_window(random);
    const Shape shape(random);
    RecordingSink free(all);
    ASSERT_TRUE(shape.draw(free).ok());
    const raster::Xor<F> ink(surface, 1);
    PolygonClipped clipped(ink, window.clip);
    ASSERT_TRUE(shape.draw(clipped).ok());
    int wrong = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const int expected = window.has(x, y) ? free.writes(x, y) : 0;
        wrong += static_cast<int>(static_cast<int>(surface.get(x, y)) != expected);
      }
    ASSERT_EQ(wrong, 0) << "shape " << shape.kind << ", " << random.seed_text();
    ASSERT_TRUE(shape.draw(clipped).ok());
    ASSERT_EQ(bytes, std::vector<std::uint8_t>(bytes.size())) << "exclusive-or twice";
  }
}
TEST(PolygonClip, CursorsAreCutAsSpansAre) {
  expect_same_on_a_surface<image::Indexed8>();
  expect_same_on_a_surface<image::Indexed1Lsb>();
}

TEST(PolygonClip, NestsInAStackOfRectanglesAndInAnotherPolygon) {
  oracle::Random random(2404);
  for (int i = 0; i < 100; ++i) {
    clip::ClipStack<2> stack(all);
    const Rect outer{random.between(-5, 20), random.between(-5, 15), random.between(5, 30),
                     random.between(5, 25)};
    ASSERT_TRUE(stack.push(outer).ok());
    ASSERT_TRUE(stack.push({3, 2, 34, 25}).ok());
    const Window first = random_window(random, stack.top());
    const Window second = random_window(random);
    const Shape shape(random);
    RecordingSink free(all);
    RecordingSink behind(stack.top());
    PolygonClipped within(behind, first.clip);
    PolygonClipped clipped(within, second.clip);
    ASSERT_TRUE(shape.draw(free).ok());
    ASSERT_TRUE(shape.draw(clipped).ok());
    ASSERT_EQ(behind.violation(), "");
    int wrong = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const bool inside = stack.top().contains({x, y}) && first.has(x, y) && second.has(x, y);
        wrong += static_cast<int>(behind.writes(x, y) != (inside ? free.writes(x, y) : 0));
      }
    ASSERT_EQ(wrong, 0) << "shape " << shape.kind << ", " << random.seed_text();
  }
}

// Spans with a value.
struct Levels {
  std::vector<int> values = std::vector<int>(static_cast<std::size_t>(width * height));
  [[nodiscard]] static Rect clip() { return all; }
  void span(int y, int x_begin, int x_end, int coverage) {
    for (int x = x_begin; x < x_end; ++x) values[static_cast<std::size_t>(y * width + x)] += coverage;
  }
};
TEST(PolygonClip, LevelsOfCoverageComeThroughUnchanged) {
  const Window window = window_of({{{0, 0}, {9000, 4000}, {300, 7000}}}, true);
  const std::vector<SubPoint> shape{{700, 500}, {6300, 1700}, {5000, 7100}};
  Levels free;
  Levels behind;
  PolygonClipped clipped(behind, window.clip);
  std::vector<raster::CoverageCell> cells(raster::coverage_cells(3, width));
  ASSERT_TRUE(raster::fill_coverage(free, FillRule::even_odd, shape, cells).ok());
  ASSERT_TRUE(raster::fill_coverage(clipped, FillRule::even_odd, shape, cells).ok());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto at = static_cast<std::size_t>(y * width + x);
      ASSERT_EQ(behind.values[at], window.has(x, y) ? free.values[at] : 0) << x << ' ' << y;
    }
}

TEST(PolygonClip, ACombIsCutToothByTooth) {
  oracle::Contour comb{{-256, 256 * 30}, {-256, 0}};
  for (int x = 0; x < width; x += 2) {
    comb.push_back({256 * x + 255, 256 * 25});
    comb.push_back({256 * x + 257, 0});
  }
  comb.push_back({256 * width, 256 * 30});
  const Window window = window_of({comb}, true);
  RecordingSink behind(all);
  PolygonClipped clipped(behind, window.clip);
  ASSERT_TRUE(raster::draw_line(clipped, {-30, 3}, {70, 22}).ok());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      ASSERT_TRUE(behind.writes(x, y) == 0 || (behind.writes(x, y) == 1 && window.has(x, y)));
  EXPECT_GT(behind.touched(), 10);
}

TEST(PolygonClip, NothingInsideDrawsNothing) {
  for (const Window& window : {window_of({}, true), window_of({{{0, 0}, {256, 0}}}, false),
                               window_of({{{99999, 0}, {199999, 0}, {99999, 9999}}}, true),
                               window_of({{{0, 0}, {9999, 0}, {0, 9999}}}, true, {5, 5, -3, 7}), Window{}}) {
    RecordingSink behind(all);
    PolygonClipped clipped(behind, window.clip);
    EXPECT_TRUE(clipped.clip().empty());
    EXPECT_TRUE(raster::fill_rect(clipped, all).ok());
    EXPECT_TRUE(raster::draw_line(clipped, {0, 0}, {30, 30}).ok());
    EXPECT_EQ(behind.spans(), 0);
  }
}

TEST(PolygonClip, BadArgumentsAreNamed) {
  const std::vector<SubPoint> good{{0, 0}, {2560, 0}, {2560, 2560}};
  const std::vector<int> length{3};
  std::vector<PolygonEdge> edges(3);
  std::vector<RowSpan> spans(20);
  const auto status = [&](FillRule rule, const std::vector<SubPoint>& vertices,
                          const std::vector<int>& lengths, const Rect& area, std::size_t edge_count,
                          std::size_t span_count) {
    return PolygonClip::over(rule, vertices, lengths, area, std::span(edges).first(edge_count),
                             std::span(spans).first(span_count))
        .status();
  };
  for (const int bad : {INT_MIN, INT_MAX, (1 << 28) + 1})
    EXPECT_EQ(status(FillRule::even_odd, {{0, 0}, {bad, 0}, {0, bad}}, length, all, 3, 20),
              (Status{Error::out_of_domain, Argument::vertices}));
  for (const Rect& bad : {Rect{INT_MIN, 0, 5, 5}, Rect{0, 0, INT_MAX, 5}})
    EXPECT_EQ(status(FillRule::even_odd, good, length, bad, 3, 20),
              (Status{Error::out_of_domain, Argument::rectangle}));
  EXPECT_EQ(status(FillRule::even_odd, good, {2}, all, 3, 20),
            (Status{Error::mismatched, Argument::contours}));
  EXPECT_EQ(status(static_cast<FillRule>(7), good, length, all, 3, 20),
            (Status{Error::out_of_range, Argument::rule}));
  EXPECT_EQ(status(FillRule::even_odd, good, length, all, 1, 20),
            (Status{Error::too_small, Argument::workspace, 2}));
  EXPECT_EQ(status(FillRule::even_odd, good, length, all, 2, 9),
            (Status{Error::too_small, Argument::table, 10}));
  EXPECT_TRUE(status(FillRule::even_odd, good, length, all, 2, 10).ok());
}

}  // namespace
