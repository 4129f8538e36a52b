// SPDX-License-Identifier: MIT
#include <intaglio/raster/arc.hpp>
#include <intaglio/raster/ring_arc.hpp>
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

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::number::Angle;
using intaglio::raster::fill_pie;
using intaglio::raster::fill_ring_arc;
using oracle::RecordingSink;

constexpr int limit = 1 << 20;

// What is wrong with an arc of a ring in this window; empty if nothing is.
std::string fault(Point centre, int inner, int outer, int start, int sweep, const Rect& clip) {
  const std::string name = "radii " + std::to_string(inner) + "," + std::to_string(outer) + " start " +
                           std::to_string(start) + " sweep " + std::to_string(sweep) + ": ";
  RecordingSink sink(clip);
  if (!fill_ring_arc(sink, centre, inner, outer, Angle::from_steps(start), sweep).ok())
    return name + "refused";
  if (!sink.violation().empty()) return name + sink.violation();
  for (int y = clip.y; y < clip.y + clip.height; ++y) {
    const int hole = oracle::outline_reach(inner, y - centre.y);
    const int reach = oracle::outline_reach(outer, y - centre.y);
    for (int x = clip.x; x < clip.x + clip.width; ++x) {
      const int dx = x - centre.x;
      const bool in = std::abs(dx) <= reach && std::abs(dx) > hole;
      if (sink.writes(x, y) != (in && oracle::in_sweep(dx, y - centre.y, start, sweep) ? 1 : 0))
        return name + "pixel " + std::to_string(x) + "," + std::to_string(y);
    }
  }
  return "";
}

TEST(RingArc, SmallOnesAreExactForManyAnglesBothWays) {
  std::string first_fault;
  for (int outer = 0; outer <= 12; outer += outer < 4 ? 1 : 8)
    for (int inner = 0; inner <= outer; ++inner)
      for (int start = 0; start < 65536; start += 4096)
        for (int sweep = -66560; sweep <= 66560 && first_fault.empty(); sweep += 5120)
          first_fault = fault({0, 0}, inner, outer, start, sweep, {-13, -13, 27, 27});
  EXPECT_EQ(first_fault, "");
}

TEST(RingArc, RandomOnesInWindowsAreExactToTheDomainsEdge) {
  oracle::Random random(2611);
  std::string first_fault;
  for (int i = 0; i < oracle::samples(3000, 40000) && first_fault.empty(); ++i) {
    const int outer = random.between(0, limit >> random.between(0, 20));
    const int inner = std::max(0, outer - random.between(0, i % 3 == 0 ? outer : std::min(outer, 40)));
    const int start = random.between(0, 65535);
    const int sweep = random.between(-65536, 65536);
    // Near an end of the arc, within its width.
    const double turn = 6.283185307179586 * (i % 2 == 0 ? start : start + sweep) / 65536;
    const int distance = random.between(inner, outer);
    const Rect clip{random.between(-70, 10), random.between(-70, 10), random.between(1, 80),
                    random.between(1, 80)};
    const Point centre{-static_cast<int>(distance * std::cos(turn)),
                       -static_cast<int>(distance * std::sin(turn))};
    first_fault = fault(centre, inner, outer, start, sweep, clip);
  }
  EXPECT_EQ(first_fault, "") << random.seed_text();
}

TEST(RingArc, WithThePieInsideMakesThePieOutside) {
  oracle::Random random(2612);
  for (int i = 0; i < 200; ++i) {
    const int outer = random.between(0, 50);
    const int inner = random.between(0, outer);
    const Angle start = Angle::from_steps(random.between(0, 65535));
    const int sweep = random.between(-66000, 66000);
    RecordingSink both({-52, -52, 105, 105});
    RecordingSink whole({-52, -52, 105, 105});
    ASSERT_TRUE(fill_ring_arc(both, {0, 0}, inner, outer, start, sweep).ok());
    ASSERT_TRUE(fill_pie(both, {0, 0}, inner, start, sweep).ok());
    ASSERT_TRUE(fill_pie(whole, {0, 0}, outer, start, sweep).ok());
    ASSERT_EQ(both.all_writes(), whole.all_writes()) << random.seed_text();
  }
}

TEST(RingArc, AFullTurnOrMoreIsTheRingAndNoTurnIsNothing) {
  for (const int sweep : {65536, 65537, 200000, INT_MAX, -65536, -65537, INT_MIN})
    EXPECT_EQ(fault({0, 0}, 5, 9, 12345, sweep, {-10, -10, 21, 21}), "") << sweep;
  RecordingSink sink({-10, -10, 21, 21});
  EXPECT_TRUE(fill_ring_arc(sink, {0, 0}, 4, 9, Angle::from_steps(7), 0).ok());
  EXPECT_EQ(sink.spans(), 0);
}

// Sweeps of 310 degrees from 270 on and of a turn or more, 5 wide (embedded-graphics #427, #484); 330 to 390,
// -30 to 30, 120 to 240 (TFT_eSPI #2487); four quarters (roo_display #12); as wide as the radius (LVGL 9830).
TEST(RingArcHardCases, EmbeddedGraphics427TftEspi2487AndLvgl9830ThickArcs) {
  for (const auto& [from, sweep] : {std::pair{270, 310},
                                    {270, 360},
                                    {330, 60},
                                    {-30, 60},
                                    {120, 120},
                                    {360, 40},
                                    {0, 180},
                                    {0, 90},
                                    {90, 90},
                                    {180, 90},
                                    {270, 90}})
    for (const int r : {5, 17, 28, 139})
      for (const int inner : {0, r - 4})
        EXPECT_EQ(fault({0, 0}, inner, r, Angle::from_degrees(from).steps(), sweep * 8192 / 45,
                        {-r - 1, -r - 1, 2 * r + 3, 2 * r + 3}),
                  "")
            << from;
}

TEST(RingArc, BadArgumentsAreNamedAndNothingIsDrawn) {
  RecordingSink sink({0, 0, 8, 8});
  const Status bad_radius{Error::out_of_domain, Argument::radius};
  for (const int sweep : {0, 5, INT_MAX}) {
    for (const int r : {-1, INT_MIN, limit + 1, INT_MAX}) {
      EXPECT_EQ(fill_ring_arc(sink, {4, 4}, 3, r, {}, sweep), bad_radius);
      EXPECT_EQ(fill_ring_arc(sink, {4, 4}, r, 3, {}, sweep), bad_radius);
    }
    EXPECT_EQ(fill_ring_arc(sink, {4, 4}, 4, 3, {}, sweep), (Status{Error::mismatched, Argument::radius}));
    EXPECT_EQ(fill_ring_arc(sink, {INT_MIN, 4}, 1, 3, {}, sweep),
              (Status{Error::out_of_domain, Argument::point}));
  }
  EXPECT_EQ(sink.spans(), 0);
}

}  // namespace
