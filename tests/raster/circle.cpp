// SPDX-License-Identifier: MIT
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/solid.hpp>
#include <tests/oracle/circle.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/oracle/span_list.hpp>
#include <tests/raster/text.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::raster::draw_circle;
using intaglio::raster::fill_disc;
using oracle::RecordingSink;
using oracle::Span;
using oracle::SpanList;

constexpr int limit = 1 << 20;
constexpr int largest = 3000;

std::string text(Point centre, int radius, const Rect& clip) {
  return "centre " + tests::text(centre) + " radius " + std::to_string(radius) + " in " + tests::text(clip);
}

// What is wrong with the outline (or the disc) in this window; empty if nothing is.
std::string fault(bool disc, Point centre, int radius, const Rect& clip) {
  RecordingSink sink(clip);
  const Status status = disc ? fill_disc(sink, centre, radius) : draw_circle(sink, centre, radius);
  if (!status.ok()) return text(centre, radius, clip) + ": refused";
  if (!sink.violation().empty()) return text(centre, radius, clip) + ": " + sink.violation();
  for (int y = clip.y; y < clip.bottom(); ++y) {
    const int reach = disc ? oracle::outline_reach(radius, y - centre.y) : 0;
    for (int x = clip.x; x < clip.right(); ++x) {
      const bool expected =
          disc ? std::abs(x - centre.x) <= reach : oracle::on_circle(radius, x - centre.x, y - centre.y);
      if (sink.writes(x, y) != (expected ? 1 : 0))
        return text(centre, radius, clip) + ": pixel " + std::to_string(x) + "," + std::to_string(y) +
               " drawn " + std::to_string(sink.writes(x, y)) + " times\n" +
               (clip.width < 100 ? sink.ascii() : "");
    }
  }
  return "";
}

TEST(CircleOracle, ListsExactlyThePixelsOfTheDefinition) {
  for (int r = 0; r <= 40; ++r) {
    std::vector<Span> expected;
    for (int y = -r - 2; y <= r + 2; ++y)
      for (int x = -r - 2; x <= r + 2; ++x)
        if (oracle::on_circle(r, x, y)) {
          if (!expected.empty() && expected.back().y == y && expected.back().end == x)
            ++expected.back().end;
          else
            expected.push_back({y, x, x + 1});
        }
    ASSERT_EQ(oracle::circle_runs(r), expected) << r;
  }
}

// Every radius up to the last, or those up to a few hundred and some of the rest.
int next(int radius) { return radius < oracle::samples(500, largest) ? radius + 1 : radius + 53; }

TEST(Circle, EveryRadiusTo3000IsExactAndEachPixelIsDrawnOnce) {
  SpanList list;
  for (int r = 0; r <= largest; r = next(r)) {
    list.clear();
    ASSERT_TRUE(draw_circle(list, {0, 0}, r).ok());
    ASSERT_TRUE(list.joined() == oracle::circle_runs(r)) << "radius " << r;
  }
}

TEST(Disc, EveryRadiusTo3000IsOneSpanARowFromOutlineToOutline) {
  SpanList list;
  for (int r = 0; r <= largest; r = next(r)) {
    list.clear();
    ASSERT_TRUE(fill_disc(list, {0, 0}, r).ok());
    const std::vector<Span>& spans = list.sorted();
    ASSERT_EQ(spans.size(), 2U * static_cast<unsigned>(r) + 1U) << "radius " << r;
    for (int y = -r; y <= r; ++y) {
      const int reach = oracle::outline_reach(r, y);
      ASSERT_EQ(spans[static_cast<unsigned>(y + r)], (Span{y, -reach, reach + 1})) << "radius " << r;
    }
  }
}

TEST(Disc, IsWhatAFloodFromOutsideTheOutlineDoesNotReach) {
  for (int r = 0; r <= 50; ++r) {
    const Rect box{-r - 1, -r - 1, 2 * r + 3, 2 * r + 3};
    RecordingSink outline(box);
    RecordingSink disc(box);
    ASSERT_TRUE(draw_circle(outline, {0, 0}, r).ok());
    ASSERT_TRUE(fill_disc(disc, {0, 0}, r).ok());
    RecordingSink outside(box);
    std::vector<Point> todo{{box.x, box.y}};
    while (!todo.empty()) {
      const Point p = todo.back();
      todo.pop_back();
      if (!box.contains(p) || outline.writes(p.x, p.y) > 0 || outside.writes(p.x, p.y) > 0) continue;
      outside.span(p.y, p.x, p.x + 1);
      for (const Point q : {Point{p.x + 1, p.y}, {p.x - 1, p.y}, {p.x, p.y + 1}, {p.x, p.y - 1}})
        todo.push_back(q);
    }
    for (int y = box.y; y < box.bottom(); ++y)
      for (int x = box.x; x < box.right(); ++x)
        ASSERT_EQ(disc.writes(x, y) + outside.writes(x, y), 1) << "radius " << r << " at " << x << "," << y;
  }
}

TEST(Circle, SmallCirclesInEveryWindowAreTheUnclippedCircleRestricted) {
  std::string first_fault;
  for (int r = 0; r <= 9; ++r)
    for (int y = -11; y <= 11; ++y)
      for (int x = -11; x <= 11 && first_fault.empty(); ++x)
        for (const Rect clip : {Rect{x, y, 1, 1}, Rect{x, y, 3, 5}, Rect{x, y, 7, 2}, Rect{x, y, 19, 19}}) {
          if (first_fault.empty()) first_fault = fault(false, {0, 0}, r, clip);
          if (first_fault.empty()) first_fault = fault(true, {0, 0}, r, clip);
        }
  EXPECT_EQ(first_fault, "");
}

TEST(Circle, RandomCirclesInWindowsNearTheirOutlineAreExactToTheDomainsEdge) {
  constexpr unsigned seed = 30;
  std::mt19937 random(seed);
  std::string first_fault;
  for (int i = 0; i < oracle::samples(4000, 40000) && first_fault.empty(); ++i) {
    const auto within = [&](int bound) { return std::uniform_int_distribution<int>(-bound, bound)(random); };
    const int radius = std::abs(within(limit >> i % 19));
    const Point centre{within(limit >> i % 7), within(limit >> i % 5)};
    // A pixel near the outline: somewhere, or near an axis or a diagonal.
    int dx = within(radius);
    if (i % 3 == 1) dx = std::min(radius, std::abs(within(40)));
    if (i % 3 == 2) dx = std::min(radius, static_cast<int>(radius * 181LL / 256) + within(40));
    dx = std::abs(dx) <= radius ? dx : radius;
    int dy = oracle::floor_root(oracle::Wide{radius} * radius - oracle::Wide{dx} * dx) *
             (random() % 2 == 0 ? 1 : -1);
    if (random() % 2 == 0) std::swap(dx, dy);
    const Rect clip{centre.x + dx + within(30), centre.y + dy + within(30), 1 + std::abs(within(60)),
                    1 + std::abs(within(60))};
    if (!intaglio::linear::in_domain(clip)) continue;
    for (const bool disc : {false, true})
      if (first_fault.empty()) first_fault = fault(disc, centre, radius, clip);
  }
  EXPECT_EQ(first_fault, "") << "seed " << seed;
}

TEST(Circle, LargestRadiiAreExactAtPolesAxesAndDiagonals) {
  std::string first_fault;
  for (const int r : {limit, limit - 1, 46341, 46340, 65535, 65536, 741455}) {
    const int diagonal = static_cast<int>(r * 46341LL / 65536);
    for (const Point at :
         {Point{0, -r}, {0, r}, {r, 0}, {-r, 0}, {diagonal, diagonal}, {-diagonal, diagonal}}) {
      if (!first_fault.empty()) break;
      const Rect clip{at.x - 60, at.y - 60, 120, 120};
      for (const Point centre : {Point{0, 0}, Point{-at.x / 2, -at.y / 2}, Point{7, -5}}) {
        const Rect moved{clip.x + centre.x, clip.y + centre.y, clip.width, clip.height};
        if (!intaglio::linear::in_domain(moved)) continue;
        if (first_fault.empty()) first_fault = fault(false, centre, r, moved);
        if (first_fault.empty()) first_fault = fault(true, centre, r, moved);
      }
    }
  }
  EXPECT_EQ(first_fault, "");
}

TEST(Circle, WorkIsBoundedByTheVisiblePixels) {
  // Forty thousand circles two million pixels wide: milliseconds if only the window is walked, minutes
  // otherwise.
  long spans = 0;
  for (int i = 0; i < 20000; ++i) {
    SpanList list({0, 0, 320, 240});
    ASSERT_TRUE(draw_circle(list, {160, limit - i}, limit - i - 100).ok());
    ASSERT_TRUE(fill_disc(list, {i + 160 - limit, 120}, limit - i).ok());
    spans += static_cast<long>(list.spans().size());
  }
  EXPECT_GT(spans, 20000L * 240);
}

TEST(Circle, CursorsDrawTheSamePixelsAsSpansOnEveryFormat) {
  using intaglio::image::Surface;
  const auto same = [](auto format, int radius) {
    using F = decltype(format);
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(F::row_bytes(101)) * 101U);
    const auto surface = Surface<F>::over(pixels, {101, 101}).value();
    RecordingSink sink({0, 0, 101, 101});
    // Exclusive-or: a pixel drawn twice is missing.
    const Status status = draw_circle(intaglio::raster::Xor(surface, 1U), {50, 50}, radius);
    if (!status.ok() || !draw_circle(sink, {50, 50}, radius).ok()) return false;
    for (int y = 0; y < 101; ++y)
      for (int x = 0; x < 101; ++x)
        if (static_cast<int>(surface.get(x, y)) != sink.writes(x, y)) return false;
    return true;
  };
  for (int r = 0; r <= 52; ++r) {
    EXPECT_TRUE(same(intaglio::image::Indexed8{}, r)) << r;
    EXPECT_TRUE(same(intaglio::image::Indexed4Lsb{}, r)) << r;
    EXPECT_TRUE(same(intaglio::image::Indexed2{}, r)) << r;
    EXPECT_TRUE(same(intaglio::image::Indexed1{}, r)) << r;
  }
}

TEST(Circle, BadArgumentsAreNamedAndNothingIsDrawn) {
  RecordingSink sink({0, 0, 8, 8});
  const Status bad_radius{Error::out_of_domain, Argument::radius};
  const Status bad_point{Error::out_of_domain, Argument::point};
  for (const int r : {-1, INT_MIN, limit + 1, INT_MAX}) {
    EXPECT_EQ(draw_circle(sink, {4, 4}, r), bad_radius);
    EXPECT_EQ(fill_disc(sink, {4, 4}, r), bad_radius);
  }
  for (const Point p : {Point{limit + 1, 0}, {0, -limit - 1}, {INT_MIN, 0}, {0, INT_MAX}}) {
    EXPECT_EQ(draw_circle(sink, p, 3), bad_point);
    EXPECT_EQ(fill_disc(sink, p, 3), bad_point);
  }
  EXPECT_EQ(sink.spans(), 0);
}

TEST(Circle, AnEmptyClipTakesNothing) {
  RecordingSink sink({3, 3, 0, 0});
  EXPECT_TRUE(draw_circle(sink, {3, 3}, 0).ok());
  EXPECT_TRUE(fill_disc(sink, {3, 3}, 10).ok());
  EXPECT_EQ(sink.spans(), 0);
}

}  // namespace
