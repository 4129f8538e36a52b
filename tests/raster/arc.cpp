// SPDX-License-Identifier: MIT
#include <intaglio/raster/arc.hpp>
#include <intaglio/raster/chord.hpp>
#include <tests/oracle/circle.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/oracle/sector.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::number::Angle;
using intaglio::raster::draw_arc;
using intaglio::raster::fill_chord;
using intaglio::raster::fill_pie;
using oracle::RecordingSink;

constexpr int limit = 1 << 20;
constexpr int quarter = 16384;

Angle steps(int n) { return Angle::from_steps(n); }

// What is wrong with an arc and a pie in this window; empty if nothing is.
std::string fault(Point centre, int radius, int start, int sweep, const Rect& clip) {
  RecordingSink arc(clip);
  RecordingSink pie(clip);
  const std::string name = "radius " + std::to_string(radius) + " start " + std::to_string(start) +
                           " sweep " + std::to_string(sweep) + ": ";
  if (!draw_arc(arc, centre, radius, steps(start), sweep).ok() ||
      !fill_pie(pie, centre, radius, steps(start), sweep).ok())
    return name + "refused";
  if (!arc.violation().empty() || !pie.violation().empty()) return name + arc.violation() + pie.violation();
  for (int y = clip.y; y < clip.y + clip.height; ++y) {
    const int reach = oracle::outline_reach(radius, y - centre.y);
    for (int x = clip.x; x < clip.x + clip.width; ++x) {
      const bool on = oracle::on_circle(radius, x - centre.x, y - centre.y);
      const bool in = std::abs(x - centre.x) <= reach;
      const bool swept = (on || in) && oracle::in_sweep(x - centre.x, y - centre.y, start, sweep);
      if (arc.writes(x, y) != (on && swept ? 1 : 0) || pie.writes(x, y) != (in && swept ? 1 : 0))
        return name + "pixel " + std::to_string(x) + "," + std::to_string(y);
    }
  }
  return "";
}

TEST(Arc, SmallOnesAreExactForManyAnglesBothWays) {
  std::string first_fault;
  for (int r = 0; r <= 12; ++r)
    for (int start = 0; start < 65536; start += 2048)
      for (int sweep = -66560; sweep <= 66560 && first_fault.empty(); sweep += 5120)
        first_fault = fault({0, 0}, r, start, sweep, {-13, -13, 27, 27});
  EXPECT_EQ(first_fault, "");
}

TEST(Arc, RandomOnesInWindowsAreExactToTheDomainsEdge) {
  oracle::Random random(36);
  std::string first_fault;
  for (int i = 0; i < oracle::samples(3000, 40000) && first_fault.empty(); ++i) {
    const int radius = random.between(0, limit >> random.between(0, 20));
    const int start = random.between(0, 65535);
    const int sweep = random.between(-65536, 65536);
    // Near an end of the arc.
    const double turn = 6.283185307179586 * (i % 2 == 0 ? start : start + sweep) / 65536;
    const Rect clip{random.between(-70, 10), random.between(-70, 10), random.between(1, 80),
                    random.between(1, 80)};
    const Point centre{-static_cast<int>(radius * std::cos(turn)),
                       -static_cast<int>(radius * std::sin(turn))};
    first_fault = fault(centre, radius, start, sweep, clip);
  }
  EXPECT_EQ(first_fault, "") << random.seed_text();
}

TEST(Arc, RaysAreExactOnTheNearestPixelsOfEveryAngle) {
  // For each angle the pixels next to the ray at distances up to the domain's edge.
  long wrong = 0;
  for (int angle = 0; angle < 65536; ++angle) {
    const intaglio::raster::detail::Ray ray(steps(angle));
    const long double turn = 6.283185307179586476925286766559L * static_cast<long double>(angle) / 65536;
    for (const int distance : {1, 7, 181, 46341, 741455, limit}) {
      const int x = static_cast<int>(std::lround(std::cos(turn) * static_cast<long double>(distance)));
      const int y = static_cast<int>(std::lround(std::sin(turn) * static_cast<long double>(distance)));
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          wrong += ray.comes_after(x + dx, y + dy) == oracle::at_or_after(x + dx, y + dy, angle) ? 1 : 0;
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST(Arc, AnyCutsMakeTheWholeCircleEachPixelOnce) {
  oracle::Random random(37);
  for (int r = 0; r <= 60; ++r) {
    std::vector<int> cuts{random.between(0, 65535), random.between(0, 65535), random.between(0, 65535)};
    if (r % 2 == 0) cuts = {0, quarter, 2 * quarter, 3 * quarter};
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    RecordingSink arcs({-62, -62, 125, 125});
    RecordingSink pies({-62, -62, 125, 125});
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      const int next = i + 1 < cuts.size() ? cuts[i + 1] : cuts[0] + 65536;
      const int sweep = next - cuts[i];
      // The same piece from either end.
      const bool back = random.between(0, 1) != 0;
      ASSERT_TRUE(draw_arc(arcs, {0, 0}, r, steps(back ? next : cuts[i]), back ? -sweep : sweep).ok());
      ASSERT_TRUE(fill_pie(pies, {0, 0}, r, steps(back ? next : cuts[i]), back ? -sweep : sweep).ok());
    }
    for (int y = -62; y < 63; ++y)
      for (int x = -62; x < 63; ++x) {
        ASSERT_EQ(arcs.writes(x, y), oracle::on_circle(r, x, y) ? 1 : 0) << r << " at " << x << "," << y;
        ASSERT_EQ(pies.writes(x, y), std::abs(x) <= oracle::outline_reach(r, y) ? 1 : 0)
            << r << " at " << x << "," << y;
      }
  }
}

TEST(Arc, AFullTurnOrMoreIsTheCircleAndNoTurnIsNothing) {
  for (const int sweep : {65536, 65537, 200000, INT_MAX, -65536, -65537, INT_MIN})
    EXPECT_EQ(fault({0, 0}, 9, 12345, sweep, {-10, -10, 21, 21}), "") << sweep;
  RecordingSink sink({-10, -10, 21, 21});
  EXPECT_TRUE(draw_arc(sink, {0, 0}, 9, steps(7), 0).ok());
  EXPECT_TRUE(fill_pie(sink, {0, 0}, 9, steps(7), 0).ok());
  EXPECT_EQ(sink.spans(), 0);
}

// True if the chord has the pixel of the disc that is (x, y) from the centre.
bool in_chord(int radius, int start, int sweep, int x, int y) {
  if (std::abs(sweep) >= 65536) return true;
  const auto end_of = [&](int angle) {
    const long double turn = 6.283185307179586476925286766559L * static_cast<long double>(angle) / 65536;
    return Point{static_cast<int>(std::lround(std::cos(turn) * static_cast<long double>(radius))),
                 static_cast<int>(std::lround(std::sin(turn) * static_cast<long double>(radius)))};
  };
  const Point from = end_of(sweep < 0 ? start + sweep : start);
  const Point to = end_of(sweep < 0 ? start : start + sweep);
  if (from == to)
    return std::abs(sweep) == 32768 ? oracle::in_sweep(0, 0, start, sweep) : std::abs(sweep) > 32768;
  // Clockwise on the screen the arc is to the right of the way from its end to its start.
  const oracle::Wide side =
      oracle::Wide{from.x - to.x} * (y - to.y) - oracle::Wide{from.y - to.y} * (x - to.x);
  if (side != 0) return side > 0;
  return to.y > from.y || (to.y == from.y && to.x < from.x);
}

std::string chord_fault(Point centre, int radius, int start, int sweep, const Rect& clip) {
  RecordingSink sink(clip);
  const std::string name = "radius " + std::to_string(radius) + " start " + std::to_string(start) +
                           " sweep " + std::to_string(sweep) + ": ";
  if (!fill_chord(sink, centre, radius, steps(start), sweep).ok()) return name + "refused";
  for (int y = clip.y; y < clip.y + clip.height; ++y) {
    const int reach = oracle::outline_reach(radius, y - centre.y);
    for (int x = clip.x; x < clip.x + clip.width; ++x) {
      const bool in = std::abs(x - centre.x) <= reach && sweep != 0 &&
                      in_chord(radius, start, sweep, x - centre.x, y - centre.y);
      if (sink.writes(x, y) != (in ? 1 : 0))
        return name + "pixel " + std::to_string(x) + "," + std::to_string(y) + "\n" + sink.ascii();
    }
  }
  return sink.violation();
}

TEST(Chord, SmallAndRandomOnesAreExactToTheDomainsEdge) {
  oracle::Random random(38);
  std::string first_fault;
  for (int r = 0; r <= 9; ++r)
    for (int start = 0; start < 65536; start += 2048)
      for (int sweep = -66560; sweep <= 66560 && first_fault.empty(); sweep += 5120)
        first_fault = chord_fault({0, 0}, r, start, sweep, {-10, -10, 21, 21});
  for (int i = 0; i < oracle::samples(1500, 20000) && first_fault.empty(); ++i) {
    const int radius = random.between(0, limit >> random.between(0, 20));
    const int start = random.between(0, 65535);
    const int sweep = random.between(-65536, 65536);
    // Near the middle of the line.
    const double half = 6.283185307179586 * sweep / 131072;
    const double turn = 6.283185307179586 * start / 65536 + half;
    const Rect clip{random.between(-40, 0), random.between(-40, 0), random.between(1, 60),
                    random.between(1, 60)};
    const Point centre{-static_cast<int>(radius * std::cos(half) * std::cos(turn)),
                       -static_cast<int>(radius * std::cos(half) * std::sin(turn))};
    first_fault = chord_fault(centre, radius, start, sweep, clip);
  }
  EXPECT_EQ(first_fault, "") << random.seed_text();
}

TEST(Chord, TheTwoOfALineMakeTheDiscEachPixelOnce) {
  oracle::Random random(39);
  for (int r = 0; r <= 60; ++r) {
    const int start = r % 3 == 0 ? random.between(0, 7) * 8192 : random.between(0, 65535);
    const int sweep = r % 4 == 0 ? 32768 : random.between(1, 65535);
    RecordingSink sink({-62, -62, 125, 125});
    ASSERT_TRUE(fill_chord(sink, {0, 0}, r, steps(start), sweep).ok());
    ASSERT_TRUE(fill_chord(sink, {0, 0}, r, steps(start), sweep - 65536).ok());
    for (int y = -62; y < 63; ++y)
      for (int x = -62; x < 63; ++x)
        ASSERT_EQ(sink.writes(x, y), std::abs(x) <= oracle::outline_reach(r, y) ? 1 : 0) << r << " " << start;
  }
}

TEST(Arc, BadArgumentsAreNamedAndNothingIsDrawn) {
  RecordingSink sink({0, 0, 8, 8});
  for (const int r : {-1, INT_MIN, limit + 1, INT_MAX})
    for (const int sweep : {0, 5, INT_MAX}) {
      EXPECT_EQ(draw_arc(sink, {4, 4}, r, {}, sweep), (Status{Error::out_of_domain, Argument::radius}));
      EXPECT_EQ(fill_pie(sink, {4, 4}, r, {}, sweep), (Status{Error::out_of_domain, Argument::radius}));
      EXPECT_EQ(fill_chord(sink, {4, 4}, r, {}, sweep), (Status{Error::out_of_domain, Argument::radius}));
    }
  EXPECT_EQ(draw_arc(sink, {INT_MIN, 4}, 3, {}, 5), (Status{Error::out_of_domain, Argument::point}));
  EXPECT_EQ(fill_chord(sink, {INT_MAX, 4}, 3, {}, 5), (Status{Error::out_of_domain, Argument::point}));
  EXPECT_EQ(fill_pie(sink, {4, INT_MAX}, 3, {}, 5), (Status{Error::out_of_domain, Argument::point}));
  EXPECT_EQ(sink.spans(), 0);
}

// Start 270 sweep 310 (embedded-graphics #427, #484); 330 to 390, -30 to 30, 120 to 240 (TFT_eSPI #2487):
// empty or flipped elsewhere.
TEST(ArcHardCases, EmbeddedGraphics427AndTftEspi2487AnglesAcrossZero) {
  const auto degrees = [](int d) { return Angle::from_degrees(d).steps(); };
  for (const auto& [from, to] :
       {std::pair{270, 580}, {330, 390}, {-30, 30}, {120, 240}, {360, 400}, {0, 180}})
    for (const int r : {5, 17, 28, 139})
      EXPECT_EQ(fault({0, 0}, r, degrees(from), (to - from) * 8192 / 45, {-140, -140, 281, 281}), "") << from;
}

}  // namespace
