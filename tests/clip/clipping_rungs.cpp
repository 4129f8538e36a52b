// SPDX-License-Identifier: MIT
//
// Rungs that clip: each is within its bound of what is exact, and refuses what its function refuses.
#include <intaglio/clip/line_window_rungs.hpp>
#include <intaglio/clip/polygon_rungs.hpp>
#include <tests/number/each_rung.hpp>
#include <tests/oracle/line_window.hpp>
#include <tests/oracle/random.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace {

using namespace intaglio;
using linear::SubPoint;
using linear::SubRect;

using tests::for_each_rung;
using tests::name;

constexpr SubPoint far_away{INT_MIN, INT_MAX};

// How far an end is from its place n/d along a segment, in pixels.
double off(SubPoint end, SubPoint a, SubPoint b, std::int64_t n, std::int64_t d) {
  const double t = static_cast<double>(n) / static_cast<double>(d);
  return std::hypot(end.x - a.x - t * (b.x - a.x), end.y - a.y - t * (b.y - a.y)) / 256;
}

// How far the corner of a window that is nearest to a line, of some length, is from it, in pixels.
double to_nearest_corner(SubPoint a, SubPoint b, const SubRect& window) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  double nearest = 1e9;
  for (const int x : {window.x, window.right()})
    for (const int y : {window.y, window.bottom()})
      nearest = std::min(nearest, std::abs(dx * (y - a.y) - dy * (x - a.x)) / std::hypot(dx, dy) / 256);
  return nearest;
}

TEST(LineWindowRungTypes, PutEndsWithinTheirBounds) {
  constexpr SubRect window{-1000, -500, 7000, 4000};
  oracle::Random random(31);
  for_each_rung(clip::LineWindowFamily{}, [&]<class R>() {
    double worst = 0;
    int seen = 0;
    for (int i = 0; i < 20'000; ++i) {
      const int far = i % 2 == 0 ? 10'000 : 1 << 28;
      const SubPoint a{random.between(-far, far), random.between(-far, far)};
      const SubPoint b{random.between(-2'000, 7'000) - (i % 4 < 2 ? a.x : 0),
                       random.between(-2'000, 5'000) - (i % 4 < 2 ? a.y : 0)};
      const auto part = oracle::inside_part(a, b, window.x, window.y, window.right(), window.bottom());
      const auto ends = R{}(a, b, window);
      if (!linear::in_domain(b)) {
        worst = std::max(worst, ends.ok() ? 1e9 : 0.0);
        continue;
      }
      ASSERT_TRUE(ends.ok()) << name<R>();
      if (part.visible != ends.value().visible) {
        // Rounded parameters may lose or find what passes near a corner.
        const bool exact = R::bound.thousandths <= 2;
        worst = std::max(worst, exact ? 1e9 : to_nearest_corner(a, b, window));
        continue;
      }
      if (!part.visible) continue;
      ++seen;
      worst = std::max({worst, off(ends.value().from, a, b, part.enter_n, part.enter_d),
                        off(ends.value().to, a, b, part.leave_n, part.leave_d)});
    }
    EXPECT_LE(worst * 1000, R::bound.thousandths) << name<R>();
    EXPECT_GT(seen, 1'000);
  });
}

TEST(LineWindowRungTypes, RefusePlacesOutsideTheDomain) {
  for_each_rung(clip::LineWindowFamily{}, []<class R>() {
    EXPECT_EQ(R{}(far_away, SubPoint{}, SubRect{0, 0, 9, 9}).status().argument(), Argument::point);
    EXPECT_EQ(R{}(SubPoint{}, SubPoint{}, SubRect{INT_MIN, 0, INT_MAX, 9}).status().argument(),
              Argument::rectangle);
    EXPECT_FALSE(R{}(SubPoint{-9, 0}, SubPoint{-8, 0}, SubRect{0, 0, 9, 9}).value().visible);
  });
}

// Twice the area, in 1/65536 pixel.
std::int64_t twice_area(std::span<const SubPoint> vertices) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const SubPoint a = vertices[i];
    const SubPoint b = vertices[(i + 1) % vertices.size()];
    sum += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
  }
  return sum;
}

// Memory for a rung and what it makes, its vertices rounded.
template <class R>
struct Clipped {
  std::array<typename R::Vertex, 64> vertices{};
  std::array<int, 16> lengths{};
  std::array<typename R::Cell, 256> cells{};
  Status status;
  std::int64_t twice_area = 0;

  Clipped(std::span<const SubPoint> polygon, std::span<const SubPoint> window, std::size_t contours = 16) {
    const auto made = R{}(polygon, window, vertices, std::span(lengths).first(contours), cells);
    status = made.status();
    std::size_t begin = 0;
    for (std::size_t i = 0; i < made.value().contours; ++i) {
      std::vector<SubPoint> rounded(static_cast<std::size_t>(lengths[i]));
      for (SubPoint& place : rounded) place = clip::nearest(vertices[begin++]);
      twice_area += ::twice_area(rounded);
    }
  }
};

TEST(PolygonClipRungTypes, LeaveTheSameArea) {
  constexpr std::array<SubPoint, 4> window{
      {{-5'001, -4'000}, {6'000, -5'000}, {7'007, 3'000}, {-3'000, 5'003}}};
  oracle::Random random(77);
  for (int i = 0; i < 200; ++i) {
    std::array<SubPoint, 3> triangle;
    for (SubPoint& p : triangle) p = {random.between(-9'999, 9'999), random.between(-9'999, 9'999)};
    const auto exact = Clipped<clip::CutAndClassify>(triangle, window).twice_area;
    for_each_rung(clip::PolygonClipFamily{}, [&]<class R>() {
      const Clipped<R> made(triangle, window);
      ASSERT_TRUE(made.status.ok()) << name<R>();
      // Seven vertices off by a sub-pixel, sides up to 12,000 long.
      EXPECT_LE(std::abs(std::abs(made.twice_area) - std::abs(exact)), 2 * 7 * 12'000) << name<R>();
    });
  }
}

TEST(PolygonClipRungTypes, RefuseWhatTheirFunctionsRefuse) {
  constexpr std::array<SubPoint, 4> window{{{0, 0}, {2'560, 0}, {2'560, 2'560}, {0, 2'560}}};
  constexpr std::array<SubPoint, 3> within{{{256, 256}, {999, 300}, {300, 999}}};
  constexpr std::array<SubPoint, 3> touching{{{0, 0}, {999, 300}, {300, 999}}};
  constexpr std::array<SubPoint, 3> beyond{{{256, 256}, far_away, {300, 999}}};
  for_each_rung(clip::PolygonClipFamily{}, [&]<class R>() {
    EXPECT_EQ(std::abs(Clipped<R>(within, window).twice_area), twice_area(within)) << name<R>();
    EXPECT_EQ(Clipped<R>(beyond, window).status.argument(), Argument::vertices) << name<R>();
    EXPECT_EQ(Clipped<R>(within, window, 0).status.error(), Error::too_small) << name<R>();
    EXPECT_EQ(Clipped<R>(touching, window).status.ok(), !(std::same_as<R, clip::GreinerHormann>))
        << name<R>();
  });
  std::vector<SubPoint> round;
  for (int i = 0; i < 65; ++i) {
    const double angle = i * 6.283185307179586 / 65;
    round.push_back({static_cast<int>(9'999 * std::cos(angle)), static_cast<int>(9'999 * std::sin(angle))});
  }
  EXPECT_EQ(Clipped<clip::SutherlandHodgman>(within, round).status.error(), Error::too_large);
}

}  // namespace
