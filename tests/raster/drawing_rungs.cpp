// SPDX-License-Identifier: MIT
//
// Rungs that draw: each draws what its function draws, within its bound of what is exact, each pixel once;
// and refuses what its function refuses.
#include <host/lab/errors/pixel_sink.hpp>
#include <intaglio/image/format.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/raster/circle_rungs.hpp>
#include <intaglio/raster/edge_rungs.hpp>
#include <intaglio/raster/ellipse_rungs.hpp>
#include <intaglio/raster/flood_rungs.hpp>
#include <intaglio/raster/line_rungs.hpp>
#include <intaglio/raster/polygon_rungs.hpp>
#include <intaglio/raster/smooth_triangle_rungs.hpp>
#include <intaglio/raster/triangle_rungs.hpp>
#include <tests/number/each_rung.hpp>
#include <tests/oracle/flood.hpp>
#include <tests/oracle/level_sink.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/oracle/samples.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace intaglio;
using linear::Point;
using linear::Rect;
using linear::SubPoint;
using oracle::LevelSink;
using oracle::RecordingSink;
using tests::for_each_rung;
using tests::name;

constexpr Rect window{-20, -20, 60, 60};
constexpr SubPoint far_away{INT_MIN, INT_MAX};

SubPoint anywhere(oracle::Random& random) {
  return {random.between(-30 * 256, 50 * 256), random.between(-30 * 256, 50 * 256)};
}

// How far a pixel's centre is from a segment, in pixels.
double distance(int x, int y, SubPoint a, SubPoint b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length = dx * dx + dy * dy;
  const double along = length == 0 ? 0 : ((256.0 * x - a.x) * dx + (256.0 * y - a.y) * dy) / length;
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(256.0 * x - a.x - t * dx, 256.0 * y - a.y - t * dy) / 256;
}

TEST(LineRungTypes, DrawWhatDrawLineByDraws) {
  for_each_rung(raster::LineFamily{}, []<class R>() {
    RecordingSink drawn(window);
    RecordingSink expected(window);
    EXPECT_TRUE(R{}(drawn, Point{-100, 3}, Point{90, 31}).ok()) << name<R>();
    EXPECT_TRUE(raster::draw_line_by<R>(expected, Point{-100, 3}, Point{90, 31}).ok());
    EXPECT_EQ(drawn.all_writes(), expected.all_writes()) << name<R>();
    EXPECT_FALSE(R{}(drawn, Point{INT_MIN, 0}, Point{0, 0}).ok()) << name<R>();
  });
}

TEST(TriangleRungTypes, MissOnlyPixelsAsNearToAnEdgeAsTheyPromise) {
  oracle::Random random(4711);
  std::string first;
  for (int i = 0; i < 300; ++i) {
    const std::array<SubPoint, 3> t{anywhere(random), anywhere(random), anywhere(random)};
    RecordingSink exact(window);
    ASSERT_TRUE(raster::fill_triangle(exact, t[0], t[1], t[2]).ok());
    for_each_rung(raster::TriangleFamily{}, [&]<class R>() {
      RecordingSink drawn(window);
      if (!R{}(drawn, t[0], t[1], t[2]).ok() || !drawn.violation().empty() || drawn.most() > 1)
        first += name<R>();
      for (int y = window.y; y < window.bottom(); ++y) {
        for (int x = window.x; x < window.right(); ++x) {
          if (drawn.writes(x, y) == exact.writes(x, y)) continue;
          const double off =
              std::min({distance(x, y, t[0], t[1]), distance(x, y, t[1], t[2]), distance(x, y, t[2], t[0])});
          if (off * 1000 > R::bound.thousandths) first += name<R>() + " off by " + std::to_string(off);
        }
      }
    });
    ASSERT_EQ(first, "") << random.seed_text() << ", triangle " << i;
  }
}

TEST(TriangleRungTypes, RefuseWhatIsTooFarAndTooLarge) {
  for_each_rung(raster::TriangleFamily{}, []<class R>() {
    RecordingSink drawn(window);
    EXPECT_EQ(R{}(drawn, SubPoint{}, far_away, SubPoint{256, 0}).error(), Error::out_of_domain) << name<R>();
    constexpr bool narrow = std::same_as<R, raster::Box32> || std::same_as<R, raster::Box32Snapped4>;
    const SubPoint wide{2'100 * 256, 0};
    EXPECT_EQ(R{}(drawn, SubPoint{-256, -256}, wide, SubPoint{0, 9999}).error(),
              narrow ? Error::too_large : Error::none)
        << name<R>();
    EXPECT_EQ(drawn.spans() == 0, narrow) << name<R>();
  });
}

using host::lab::Pixels;
using host::lab::PixelSink;

// What a call draws on a sink, anywhere.
template <class Draw>
Pixels drawn_by(Draw draw) {
  Pixels pixels;
  const PixelSink everywhere({-5'000, -5'000, 10'000, 10'000}, pixels);
  EXPECT_TRUE(draw(everywhere).ok());
  return pixels;
}

// What is wrong with the pixels that a rung draws, beside the exact ones; empty if nothing is.
template <class R>
std::string fault(Pixels drawn, const Pixels& exact) {
  const int wrong = host::lab::differences(drawn, exact);
  std::sort(drawn.begin(), drawn.end());
  if (std::adjacent_find(drawn.begin(), drawn.end()) != drawn.end()) return name<R>() + ": one drawn twice";
  if (wrong * 1000 > R::bound.thousandths) return name<R>() + ": " + std::to_string(wrong) + " wrong";
  return "";
}

TEST(CircleRungTypes, HaveFewPixelsWrongAndNoneTwice) {
  for (int radius = 0; radius <= 1'024; radius += radius < 20 ? 1 : oracle::samples(41, 1)) {
    const Pixels exact = drawn_by([&](auto& sink) {
      return raster::draw_circle(sink, Point{1, -2}, radius);
    });
    for_each_rung(raster::CircleFamily{}, [&]<class R>() {
      EXPECT_EQ(fault<R>(drawn_by([&](auto& sink) {
                           return R{}(sink, Point{1, -2}, radius);
                         }),
                         exact),
                "")
          << radius;
    });
  }
}

TEST(CircleRungTypes, ReachTheirLargestRadiusAndNoFurther) {
  for_each_rung(raster::CircleFamily{}, []<class R>() {
    RecordingSink drawn(window);
    if constexpr (requires { R::most; }) {
      const Rect east{R::most - 100, -90, 100, 180};
      RecordingSink exact(east);
      RecordingSink largest(east);
      ASSERT_TRUE(raster::draw_circle(exact, Point{-50, 0}, R::most).ok());
      EXPECT_TRUE(R{}(largest, Point{-50, 0}, R::most).ok());
      EXPECT_GT(largest.touched(), 150) << name<R>();
      if (R::bound.exact()) {
        EXPECT_EQ(largest.all_writes(), exact.all_writes()) << name<R>();
      }
      const Status beyond = R{}(drawn, Point{}, R::most + 1);
      EXPECT_EQ(beyond.argument(), Argument::radius) << name<R>();
      if (R::most < linear::coordinate_limit) {
        EXPECT_EQ(beyond.needed(), static_cast<unsigned>(R::most)) << name<R>();
      }
    }
    EXPECT_EQ(R{}(drawn, Point{}, -1).argument(), Argument::radius) << name<R>();
    EXPECT_EQ(R{}(drawn, Point{}, INT_MAX).argument(), Argument::radius) << name<R>();
    EXPECT_EQ(R{}(drawn, Point{INT_MIN, 0}, 5).argument(), Argument::point) << name<R>();
    EXPECT_EQ(drawn.spans(), 0);
  });
}

TEST(EllipseRungTypes, HaveFewPixelsWrongAndNoneTwice) {
  const auto check = [](int a, int b) {
    const Pixels exact = drawn_by([&](auto& sink) { return raster::draw_ellipse(sink, Point{-9, 2}, a, b); });
    for_each_rung(raster::EllipseFamily{}, [&]<class R>() {
      if constexpr (requires { R::most; }) {
        if (std::max(a, b) > R::most) return;
      }
      EXPECT_EQ(fault<R>(drawn_by([&](auto& sink) {
                           return R{}(sink, Point{-9, 2}, a, b);
                         }),
                         exact),
                "")
          << a << ", " << b;
    });
  };
  for (int a = 0; a <= 20; ++a)
    for (int b = 0; b <= 20; ++b) check(a, b);
  for (const int longest : {645, 1'024})
    for (const int other : {1, 2, longest / 3, longest}) check(longest, other), check(other, longest);
  check(434, 438);  // the worst by sines
  oracle::Random random(1884);
  for (int i = 0; i < oracle::samples(40, 4'000); ++i)
    check(random.between(0, 1'024), random.between(0, 450));
}

TEST(EllipseRungTypes, RefuseWhatTheirBitsDoNotHold) {
  for_each_rung(raster::EllipseFamily{}, []<class R>() {
    RecordingSink drawn(window);
    if constexpr (requires { R::most; }) {
      EXPECT_EQ(R{}(drawn, Point{}, R::most + 1, 3).error(), Error::too_large) << name<R>();
      EXPECT_EQ(R{}(drawn, Point{}, 3, R::most + 1).needed(), static_cast<unsigned>(R::most)) << name<R>();
    }
    EXPECT_EQ(R{}(drawn, Point{}, 3, -1).argument(), Argument::radius) << name<R>();
    EXPECT_EQ(R{}(drawn, Point{}, INT_MAX, INT_MIN).argument(), Argument::radius) << name<R>();
    EXPECT_EQ(R{}(drawn, Point{0, INT_MAX}, 5, 5).argument(), Argument::point) << name<R>();
    EXPECT_EQ(drawn.spans(), 0);
  });
}

TEST(EdgeRungTypes, StayWithinTheirBoundsOverAllRows) {
  oracle::Random random(99);
  for_each_rung(raster::EdgeFamily{}, [&]<class R>() {
    double worst = 0;
    for (int i = 0; i < 40; ++i) {
      constexpr int far = 256 << 13;
      const SubPoint top{random.between(-far, far), -far};
      const SubPoint bottom{random.between(-far, far), i % 2 == 0 ? far : random.between(256 - far, far)};
      R edge;
      const int end = (bottom.y + 255) >> 8;
      edge.start(top, bottom, -far / 256);
      for (int row = -far / 256; row < end; ++row, edge.next()) {
        const double place = (top.x + (256.0 * row - top.y) * (bottom.x - top.x) / (bottom.y - top.y)) / 256;
        // The first column not left of it: 0 .. 1 beyond.
        const double beyond = edge.x() - place;
        worst = std::max({worst, -beyond, beyond - 1});
      }
    }
    EXPECT_LE(worst * 1000, R::bound.thousandths + 1e-6) << name<R>();
  });
}

TEST(PolygonRungTypes, DrawTheSamePixelsAndSayWhatTheyNeed) {
  oracle::Random random(5);
  for (int i = 0; i < 60; ++i) {
    std::array<SubPoint, 9> vertices;
    for (SubPoint& v : vertices) v = anywhere(random);
    constexpr std::array<int, 2> lengths{4, 5};
    const auto rule = i % 2 == 0 ? raster::FillRule::even_odd : raster::FillRule::non_zero;
    std::array<raster::PolygonEdge, 9> edges;
    RecordingSink two(window);
    RecordingSink one(window);
    ASSERT_TRUE(raster::fill_polygon(two, rule, vertices, lengths, edges).ok());
    ASSERT_TRUE(raster::fill_polygon(one, rule, vertices, edges).ok());
    for_each_rung(raster::PolygonFamily{}, [&]<class R>() {
      std::array<typename R::Cell, 9> workspace;
      RecordingSink drawn(window);
      EXPECT_TRUE(R{}(drawn, rule, vertices, lengths, workspace).ok()) << name<R>();
      EXPECT_EQ(drawn.all_writes(), two.all_writes()) << name<R>();
      drawn.clear();
      EXPECT_TRUE(R{}(drawn, rule, vertices, workspace).ok()) << name<R>();
      EXPECT_EQ(drawn.all_writes(), one.all_writes()) << name<R>();
    });
  }
}

TEST(PolygonRungTypes, FillConvexContoursAlikeAndRefuseOthers) {
  constexpr std::array<SubPoint, 5> convex{
      {{0, -1000}, {3000, 500}, {2500, 4000}, {-900, 4000}, {-2000, 700}}};
  constexpr std::array<SubPoint, 4> dented{{{0, 0}, {3000, 0}, {500, 500}, {0, 3000}}};
  std::array<raster::PolygonEdge, 5> edges;
  RecordingSink expected(window);
  ASSERT_TRUE(raster::fill_polygon(expected, raster::FillRule::even_odd, convex, edges).ok());
  for_each_rung(raster::ConvexFamily{}, [&]<class R>() {
    std::array<typename R::Cell, 5> workspace;
    RecordingSink drawn(window);
    EXPECT_TRUE(R{}(drawn, raster::FillRule::even_odd, convex, workspace).ok()) << name<R>();
    EXPECT_EQ(drawn.all_writes(), expected.all_writes()) << name<R>();
    drawn.clear();
    constexpr bool of_convex = std::same_as<R, raster::EdgeFunctionFill>;
    EXPECT_EQ(R{}(drawn, raster::FillRule::even_odd, dented, workspace).ok(), !of_convex) << name<R>();
    drawn.clear();
    const auto starved = R{}(drawn, raster::FillRule::even_odd, convex, {});
    EXPECT_EQ(starved.argument(), of_convex ? Argument::none : Argument::workspace) << name<R>();
    EXPECT_EQ(drawn.spans() == 0, !of_convex) << name<R>();
    EXPECT_FALSE(
        R{}(drawn, raster::FillRule::even_odd, std::array{SubPoint{}, far_away, SubPoint{9, 9}}, workspace)
            .ok());
  });
}

// A picture strewn with ones, and a flood of it.
class Strewn {
 public:
  explicit Strewn(std::uint32_t seed) {
    oracle::Random random(seed);
    for (std::uint8_t& pixel : pixels_) pixel = random.between(0, 2) == 0 ? 1 : 0;
  }
  image::Surface<image::Indexed8> surface() {
    return image::Surface<image::Indexed8>::over(pixels_, {side, side}).value();
  }
  [[nodiscard]] int at(int x, int y) const { return pixels_[static_cast<std::size_t>(y * side + x)]; }
  [[nodiscard]] const auto& pixels() const { return pixels_; }
  static constexpr int side = 30;

 private:
  std::array<std::uint8_t, std::size_t{900}> pixels_{};
};

TEST(FloodRungTypes, FillTheRegionOfTheSeedAndSayWhenMemoryIsShort) {
  constexpr Rect clip{2, 1, 26, 27};
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Strewn before(seed);
    const Point at{10, static_cast<int>(seed)};
    const int region = before.at(at.x, at.y);
    const auto reached = oracle::region(Strewn::side, Strewn::side, clip, false, at.x, at.y,
                                        [&](int x, int y) { return before.at(x, y) == region; });
    for_each_rung(raster::FloodFamily{}, [&]<class R>() {
      Strewn picture(seed);
      const raster::Solid pen(picture.surface(), 7, clip);
      std::array<typename R::Cell, 900> workspace;
      EXPECT_TRUE(R{}(pen, at, workspace).ok()) << name<R>();
      int wrong = 0;
      for (std::size_t i = 0; i < reached.size(); ++i)
        wrong += picture.pixels()[i] == (reached[i] != 0 ? 7 : before.pixels()[i]) ? 0 : 1;
      EXPECT_EQ(wrong, 0) << name<R>() << ", seed " << seed;
      const auto filled = picture.pixels();
      EXPECT_TRUE(R{}(pen, at, workspace).ok()) << "again";
      EXPECT_TRUE(R{}(pen, Point{0, 0}, workspace).ok()) << "outside the clip";
      EXPECT_EQ(picture.pixels(), filled);
      EXPECT_EQ(R{}(pen, Point{INT_MAX, 0}, workspace).argument(), Argument::point) << name<R>();
    });
  }
  Strewn picture(1);
  const raster::Solid pen(picture.surface(), 7);
  std::array<raster::FloodPlace, 1> short_of_memory;
  const Status status = raster::PixelStackFlood{}(pen, Point{10, 1}, short_of_memory);
  EXPECT_EQ(status.argument(), Argument::workspace);
  EXPECT_EQ(status.needed(), 2U);
}

TEST(SmoothTriangleRungTypes, AreWithinTheirBoundsOfTheArea) {
  oracle::Random random(815);
  for (int i = 0; i < 60; ++i) {
    const raster::TriangleCorners t{anywhere(random), anywhere(random), anywhere(random)};
    LevelSink exact(window);
    std::array<raster::CoverageCell, raster::coverage_cells(3, 60)> cells;
    ASSERT_TRUE(raster::fill_coverage(exact, raster::FillRule::non_zero, t, cells).ok());
    for_each_rung(raster::SmoothTriangleFamily{}, [&]<class R>() {
      std::vector<typename R::Cell> workspace(R::cells(window.width));
      LevelSink drawn(window);
      EXPECT_TRUE(R{}(drawn, t, workspace).ok() && !drawn.bad()) << name<R>();
      int worst = 0;
      for (int y = window.y; y < window.bottom(); ++y)
        for (int x = window.x; x < window.right(); ++x)
          worst = std::max(worst, std::abs(drawn.level(x, y) - exact.level(x, y)));
      EXPECT_LE(1000 * worst, R::bound.thousandths + 500) << name<R>() << ", " << random.seed_text();
    });
  }
}

TEST(SmoothTriangleRungTypes, RefuseTooLittleMemoryAndPlacesFarAway) {
  constexpr raster::TriangleCorners t{{{0, 0}, {3000, 100}, {100, 4000}}};
  for_each_rung(raster::SmoothTriangleFamily{}, [&]<class R>() {
    LevelSink drawn(window);
    std::vector<typename R::Cell> workspace(R::cells(window.width));
    EXPECT_EQ(R{}(drawn, {{{0, 0}, far_away, {100, 4000}}}, workspace).error(), Error::out_of_domain)
        << name<R>();
    if (R::cells(1) != 0) {
      const Status status = R{}(drawn, t, {});
      EXPECT_EQ(status.argument(), Argument::workspace) << name<R>();
      EXPECT_LE(status.needed(), R::cells(window.width)) << name<R>();
    }
    EXPECT_EQ(drawn.spans(), 0) << name<R>();
    LevelSink nowhere({0, 0, 0, 0});
    EXPECT_TRUE(R{}(nowhere, t, workspace).ok()) << name<R>();
    EXPECT_EQ(nowhere.spans(), 0);
  });
}

}  // namespace
