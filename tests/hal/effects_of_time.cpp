// SPDX-License-Identifier: MIT
//
// What a panel does to time: bus, tearing-effect line, drift, scan-out order, latch, power-on.
#include <hal/sim/effects/drift.hpp>
#include <hal/sim/effects/scan.hpp>
#include <hal/sim/panel.hpp>
#include <hal/sim/tearing.hpp>
#include <tests/oracle/panel_effects.hpp>
#include <tests/oracle/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>
#include <vector>

namespace {

using hal::Nanoseconds;
using hal::ScanDirection;
using hal::sim::Bus;
using hal::sim::BusTiming;
using hal::sim::Effects;
using hal::sim::Panel;
using hal::sim::PanelSpec;
using hal::sim::Tear;
using hal::sim::TearingDetector;
using hal::sim::TeTiming;
using hal::sim::VirtualClock;
using oracle::Wide;
using Bytes = std::vector<std::uint8_t>;

Nanoseconds now(VirtualClock& clock) { return static_cast<hal::Clock&>(clock).now(); }

/// A write panel of 8 bits a pixel without alignment.
PanelSpec write_panel(int width, int height, int total_lines) {
  PanelSpec spec = hal::sim::paletted(width, height, 8, 0);
  spec.total_lines = total_lines;
  return spec;
}

/// Every line that was fetched, with its time.
class Witness final : public hal::sim::Observer {
 public:
  struct Line {
    std::uint64_t refresh;
    int line;
    int y;
    Nanoseconds time;
    Bytes pixels;
  };
  std::vector<Line> lines;
  std::vector<Nanoseconds> vblanks;
  std::vector<Nanoseconds> edges;
  std::vector<std::uint32_t> dropped;

 private:
  void on_line(const hal::sim::ScannedLine& line) override {
    lines.push_back({line.refresh, line.line, line.y, line.time, {line.pixels.begin(), line.pixels.end()}});
  }
  void on_vblank(std::uint64_t, Nanoseconds time) override { vblanks.push_back(time); }
  void on_te(std::uint64_t, Nanoseconds time) override { edges.push_back(time); }
  void on_dropped(std::uint32_t frame, Nanoseconds) override { dropped.push_back(frame); }
};

TEST(BusEffect, EachPixelArrivesWhenItsLastBitDoes) {
  oracle::Random random(41);
  for (int round = 0; round < 200; ++round) {
    const BusTiming timing{.hertz = static_cast<std::uint32_t>(random.between(1, 1 << random.between(1, 30))),
                           .clocks_per_byte = random.between(8, 9),
                           .bits_per_pixel = random.between(1, 24),
                           .command_bytes = random.between(0, 20),
                           .gap = static_cast<Nanoseconds>(random.between(0, 100'000))};
    const Bus bus(timing, {});
    VirtualClock clock;
    clock.advance(static_cast<Nanoseconds>(random.between(0, 1'000'000)));
    const Nanoseconds begin = now(clock);
    const hal::Rect area{3, 5, random.between(1, 20), random.between(1, 20)};
    int pixel = 0;
    int wrong = 0;
    bus.send(area, clock, [&](int x, int y) {
      const Wide due = oracle::bus_arrival(timing.gap, timing.hertz, timing.clocks_per_byte,
                                           timing.command_bytes, timing.bits_per_pixel, pixel);
      if (x != pixel % area.width || y != pixel / area.width || now(clock) - begin != due) ++wrong;
      ++pixel;
    });
    ASSERT_EQ(wrong, 0) << random.seed_text() << " round " << round;
    ASSERT_EQ(pixel, area.width * area.height);
  }
}

TEST(BusEffect, TheLongestWindowOnTheSlowestAndTheFastestBusIsExact) {
  for (const std::uint32_t hertz : {1U, 3U, 999'999'999U, 4'000'000'000U}) {
    const Bus bus({.hertz = hertz, .clocks_per_byte = 9, .bits_per_pixel = 32, .command_bytes = 0, .gap = 7},
                  {});
    const std::uint64_t pixels = std::uint64_t{1} << 28U;
    EXPECT_TRUE(bus.time_of(bus.bytes_of(pixels)) ==
                oracle::bus_arrival(7, hertz, 9, 0, 32, Wide{pixels} - 1))
        << hertz;
  }
}

TEST(BusEffect, MemoryMadeOfPagesIsSentPageByPageAndColumnByColumn) {
  const hal::Capabilities c{
      .width = 16, .height = 24, .bits_per_pixel = 1, .x_alignment = 8, .y_alignment = 8};
  const Bus bus({.hertz = 8'000'000, .bits_per_pixel = 0, .command_bytes = 3, .gap = 1000}, c);
  VirtualClock clock;
  std::vector<std::pair<int, int>> order;
  const std::uint64_t bytes =
      bus.send({0, 0, 16, 16}, clock, [&](int x, int y) { order.emplace_back(x, y); });
  EXPECT_EQ(bytes, 2U * (3U + 16U));
  EXPECT_EQ(now(clock), 2U * (1000U + 19U * 1000U));
  ASSERT_EQ(order.size(), 256U);
  EXPECT_EQ(std::set(order.begin(), order.end()).size(), 256U);
  EXPECT_EQ(order[7], std::pair(0, 7));
  EXPECT_EQ(order[8], std::pair(1, 0));
  EXPECT_EQ(order[128], std::pair(0, 8));
}

TEST(BusEffect, TheBeamSeesThePixelsThatHaveArrived) {
  oracle::Random random(42);
  for (int round = 0; round < 20; ++round) {
    constexpr int width = 12;
    constexpr int height = 30;
    VirtualClock clock;
    Effects effects;
    effects.bus =
        BusTiming{.hertz = static_cast<std::uint32_t>(random.between(20'000, 600'000)), .bits_per_pixel = 16};
    Panel panel(write_panel(width, height, 33), clock, effects);
    Witness witness;
    panel.attach(witness);
    clock.advance(static_cast<Nanoseconds>(random.between(1, 40'000'000)));
    const Nanoseconds begin = now(clock);
    ASSERT_TRUE(panel.write({0, 0, width, height}, Bytes(width * height, 1), width).ok());
    clock.advance(panel.frame_time());
    const oracle::Beam beam{static_cast<Wide>(panel.frame_time()), height, 33};
    const auto arrival = [&](Wide pixel) {
      return oracle::bus_arrival(effects.bus->gap, effects.bus->hertz, 8, effects.bus->command_bytes, 16,
                                 pixel);
    };
    for (const Witness::Line& line : witness.lines) {
      const int count = oracle::arrived(beam, static_cast<Wide>(line.refresh), line.line, width,
                                        static_cast<Wide>(begin), arrival);
      ASSERT_EQ(std::ranges::count(line.pixels, 1), count) << random.seed_text() << " round " << round;
      ASSERT_TRUE(std::ranges::is_sorted(line.pixels, std::greater{}));
    }
    panel.detach(witness);
  }
}

/// A whole picture sent from the edge of TE on tears where the beam overtakes the bus, if anywhere.
void expect_tear_at_computed_line(Nanoseconds bus_time, Nanoseconds phase) {
  SCOPED_TRACE(testing::Message() << bus_time << " ns on the bus, phase " << phase);
  constexpr int width = 32;
  constexpr int height = 240;
  constexpr int total = 262;
  VirtualClock clock;
  Effects effects;
  // One clock a byte and a byte a pixel: so many clocks are `bus_time`.
  const auto hertz = static_cast<std::uint32_t>(1'000'000'000ULL * width * height / bus_time);
  effects.bus =
      BusTiming{.hertz = hertz, .clocks_per_byte = 1, .bits_per_pixel = 8, .command_bytes = 0, .gap = 0};
  effects.te = TeTiming{.phase = phase};
  effects.tearing = true;
  Panel panel(write_panel(width, height, total), clock, effects);
  TearingDetector detector(panel);
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  const Nanoseconds begin = now(clock);
  ASSERT_EQ(begin, panel.frame_time() * height / total + phase);
  ASSERT_TRUE(panel.write({0, 0, width, height}, Bytes(width * height, 1), width).ok());
  panel.mark_frame();
  clock.advance(2U * panel.frame_time());

  // By the definition: the first line of refresh 1 of which not all had arrived, then of refresh 2.
  const oracle::Beam beam{static_cast<Wide>(panel.frame_time()), height, total};
  std::vector<std::pair<std::uint64_t, int>> expected;
  for (const Wide refresh : {1, 2, 3}) {
    std::vector<int> arrived;
    arrived.reserve(height);
    for (int y = 0; y < height; ++y)
      arrived.push_back(oracle::arrived(beam, refresh, y, width, static_cast<Wide>(begin), [&](Wide pixel) {
        return oracle::bus_arrival(0, hertz, 1, 0, 8, pixel);
      }));
    const auto kind = [&](int y) {
      const int count = arrived[static_cast<std::size_t>(y)];
      return count == 0 ? 0 : count == width ? 1 : 2;
    };
    for (int y = 1; y < height; ++y)
      if (kind(y) != kind(y - 1)) expected.emplace_back(static_cast<std::uint64_t>(refresh), y);
  }
  std::vector<std::pair<std::uint64_t, int>> found;
  for (const Tear& tear : detector.tears()) found.emplace_back(tear.refresh, tear.line);
  EXPECT_EQ(found, expected);
  if (bus_time == 18'000'000 && phase == 0) {
    ASSERT_EQ(expected.size(), 2U)
        << "the first line of which only a part was there, and the first of which nothing was";
    // 22 lines of blanking ahead, a line takes 75 us on the bus and 63.6 us under the beam: from y = 117 on,
    // 75 (y + 1) is more than 63.6 (y + 22).
    EXPECT_EQ(expected[0].second, 117);
  }
}

TEST(Tearing, At60HzAnd18MsOnTheBusThePictureTearsAtTheComputedLine) {
  expect_tear_at_computed_line(18'000'000, 0);
}

TEST(Tearing, AnyBusAndAnyPhaseTearsAtTheComputedLine) {
  for (const Nanoseconds bus_time :
       {4'000'000U, 12'000'000U, 16'600'000U, 17'000'000U, 20'000'000U, 30'000'000U})
    for (const Nanoseconds phase : {0U, 500'000U, 1'390'000U, 1'500'000U, 8'000'000U})
      expect_tear_at_computed_line(bus_time, phase);
}

TEST(TeEffect, EdgesKeepTheirBoundsAndWaitsEndWithThem) {
  VirtualClock clock;
  Effects effects;
  effects.te = TeTiming{.phase = 200'000, .jitter = 3'000'000};
  Panel panel(write_panel(4, 20, 22), clock, effects);
  Witness witness;
  panel.attach(witness);
  std::vector<Nanoseconds> waits;
  for (std::uint32_t n = 1; n <= 1000; ++n) {
    ASSERT_TRUE(panel.wait_for_vblank().ok());
    ASSERT_EQ(panel.vblank_count(), n);
    waits.push_back(now(clock));
    clock.advance(1);
    ASSERT_EQ(panel.vblank_count(), n);
  }
  ASSERT_EQ(waits, witness.edges);
  Nanoseconds least = ~Nanoseconds{0};
  Nanoseconds most = 0;
  for (std::size_t i = 0; i < waits.size(); ++i) {
    const Nanoseconds delay = waits[i] - witness.vblanks[i];
    ASSERT_EQ(witness.vblanks[i], i * panel.frame_time() + panel.frame_time() * 20 / 22);
    least = std::min(least, delay);
    most = std::max(most, delay);
  }
  EXPECT_GE(least, 200'000U);
  EXPECT_LT(least, 230'000U);
  EXPECT_LE(most, 3'200'000U);
  EXPECT_GT(most, 3'170'000U);
  panel.detach(witness);
}

TEST(TeEffect, AVblankIsCountedOnceItsEdgeHasCome) {
  VirtualClock clock;
  Effects effects;
  effects.te = TeTiming{.phase = 1'000'000};
  Panel panel(write_panel(4, 20, 22), clock, effects);
  clock.wait_until(panel.frame_time() * 20 / 22);
  EXPECT_EQ(panel.vblank_count(), 0U) << "VBLANK has begun, but its edge hasn't come";
  clock.advance(999'999);
  EXPECT_EQ(panel.vblank_count(), 0U);
  clock.advance(1);
  EXPECT_EQ(panel.vblank_count(), 1U);
}

TEST(TeEffect, WithoutALineTheProgramCountsByItsOwnClockAtTheNominalRate) {
  VirtualClock clock;
  Effects effects;
  effects.te = TeTiming{.connected = false, .millihertz = 66'000};
  Panel panel(write_panel(4, 20, 22), clock, effects);
  Witness witness;
  panel.attach(witness);
  for (int i = 0; i < 600; ++i) ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_NEAR(static_cast<double>(now(clock)), 1e10, 1e3);
  EXPECT_EQ(witness.vblanks.size(), 660U);
  EXPECT_TRUE(witness.edges.empty());
  panel.detach(witness);
}

TEST(TeEffect, AClockOfTheProgramsOwnKeepsPaceWithAPanelOfTheNominalRate) {
  VirtualClock clock;
  Effects effects;
  effects.te = TeTiming{.connected = false};
  Panel panel(write_panel(4, 16384, 17874), clock, effects);
  Effects told;
  told.te = TeTiming{};
  Panel reference(write_panel(4, 16384, 17874), clock, told);
  ASSERT_EQ(panel.vblank_count(), 0U);
  for (int minutes = 1; minutes <= 24 * 60; minutes += 60) {
    clock.wait_until(static_cast<Nanoseconds>(minutes) * 60'000'000'000U);
    ASSERT_EQ(panel.vblank_count(), static_cast<std::uint32_t>(minutes) * 3600U) << minutes << " minutes";
    const std::uint32_t real = reference.vblank_count();
    ASSERT_LE(std::abs(static_cast<int>(real - panel.vblank_count())), 1) << minutes << " minutes";
  }
}

TEST(TeEffect, TheSlowestPanelIsSimulatedInTime) {
  VirtualClock clock;
  Effects effects;
  effects.te = TeTiming{};
  effects.drift = hal::sim::RefreshDrift{.ppm = 50'000};
  PanelSpec spec = write_panel(4, 20, 22);
  spec.capabilities.refresh_millihertz = 0;  // As 1: a refresh of 1000 s.
  Panel panel(spec, clock, effects);
  for (std::uint32_t n = 1; n <= 3; ++n) {
    ASSERT_TRUE(panel.wait_for_vblank().ok());
    EXPECT_EQ(now(clock), 950'000'000'000U * (n - 1U) + 950'000'000'000U * 20U / 22U);
    EXPECT_EQ(panel.vblank_count(), n);
  }
}

TEST(DriftEffect, RefreshesLastWhatTheFormulaSays) {
  oracle::Random random(43);
  for (int i = 0; i < 20'000; ++i) {
    const hal::sim::RefreshDrift drift{
        .ppm = random.between(-100'000, 100'000),
        .period = i % 3 == 0 ? 0 : static_cast<Nanoseconds>(random.between(1'000'000, 2'000'000'000)) * 30U};
    const auto nominal = static_cast<Nanoseconds>(random.between(1'000'000, 2'000'000'000)) *
                         (i % 5 == 0 ? 500U : 1U);  // Up to 1000 s.
    const auto time = static_cast<Nanoseconds>(random.between(0, 2'000'000'000)) * 1000U;
    const long double exact =
        oracle::drifting_frame(static_cast<long double>(nominal), drift.ppm, static_cast<Wide>(drift.period),
                               static_cast<Wide>(time));
    const auto found = static_cast<long double>(hal::sim::drifting_frame_time(drift, nominal, time));
    // Half a nanosecond of its own, half of 10^-9 of the refresh for the rounded drift.
    ASSERT_LE(std::abs(found - exact), 0.5001L + 0.5e-9L * static_cast<long double>(nominal))
        << drift.ppm << ' ' << drift.period;
  }
}

TEST(DriftEffect, APanelThatIsFastShowsMoreRefreshes) {
  for (const int ppm : {-1000, 1000}) {
    VirtualClock clock;
    Effects effects;
    effects.drift = hal::sim::RefreshDrift{.ppm = ppm};
    Panel panel(write_panel(4, 20, 22), clock, effects);
    clock.advance(100 * panel.frame_time() * 100);
    const int count = static_cast<int>(panel.vblank_count());
    EXPECT_LE(std::abs(count - (10'000 + ppm / 100)), 1);
  }
}

/// Index of the pixel in the picture below: its row and column in one number.
constexpr std::uint8_t mark(int x, int y) { return static_cast<std::uint8_t>(16 * y + x); }

TEST(ScanEffect, LinesComeInTheOrderOfTheBeam) {
  constexpr int width = 9;
  constexpr int height = 5;
  for (const ScanDirection scan :
       {ScanDirection::down, ScanDirection::up, ScanDirection::right, ScanDirection::left}) {
    VirtualClock clock;
    Effects effects;
    effects.scan = scan;
    Panel panel(hal::sim::paletted(width, height, 8, 1), clock, effects);
    EXPECT_EQ(panel.capabilities().scan, scan);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) panel.buffer(0)[static_cast<std::size_t>(y * width + x)] = mark(x, y);
    Witness witness;
    panel.attach(witness);
    ASSERT_TRUE(panel.wait_for_vblank().ok());
    const bool columns = scan == ScanDirection::left || scan == ScanDirection::right;
    const bool backwards = scan == ScanDirection::left || scan == ScanDirection::up;
    const int lines = columns ? width : height;
    ASSERT_EQ(witness.lines.size(), static_cast<std::size_t>(lines));
    for (int i = 0; i < lines; ++i) {
      const Witness::Line& line = witness.lines[static_cast<std::size_t>(i)];
      const int place = backwards ? lines - 1 - i : i;
      EXPECT_EQ(line.line, i);
      EXPECT_EQ(line.y, place);
      EXPECT_EQ(line.time, panel.frame_time() * static_cast<Nanoseconds>(i) /
                               static_cast<Nanoseconds>(panel.spec().total_lines));
      Bytes expected;
      for (int k = 0; k < (columns ? height : width); ++k)
        expected.push_back(columns ? mark(place, k) : mark(k, place));
      EXPECT_EQ(line.pixels, expected);
    }
    panel.detach(witness);
  }
}

TEST(ScanEffect, ATearIsFoundWhereTheBeamWas) {
  struct Case {
    ScanDirection scan;
    int line;
    const char* text;
  };
  for (const Case& c :
       {Case{ScanDirection::down, 4, "refresh 1, line 4: frame 1 above, frame 2 below"},
        Case{ScanDirection::up, 5, "refresh 1, line 5: frame 2 above, frame 1 below"},
        Case{ScanDirection::right, 4, "refresh 1, column 4: frame 1 on the left, frame 2 on the right"},
        Case{ScanDirection::left, 5, "refresh 1, column 5: frame 2 on the left, frame 1 on the right"}}) {
    VirtualClock clock;
    Effects effects;
    effects.scan = c.scan;
    effects.latch = hal::sim::PaletteLatch::both_at_once;
    Panel panel(hal::sim::paletted(10, 10, 8, 2), clock, effects);
    std::ranges::fill(panel.buffer(1), std::uint8_t{1});
    std::ranges::fill(panel.buffer(0), std::uint8_t{2});
    TearingDetector detector(panel);
    ASSERT_TRUE(panel.show(1, {}).ok());
    clock.wait_until(panel.frame_time() + 3U * panel.line_time() + 1U);
    ASSERT_TRUE(panel.show(0, {}).ok());
    clock.advance(panel.frame_time());
    ASSERT_EQ(detector.tears().size(), 1U);
    EXPECT_EQ(detector.tears()[0].line, c.line);
    EXPECT_EQ(hal::sim::to_text(detector.tears()[0]), c.text);
  }
}

TEST(LatchEffect, ColoursThatArentHeldBackChangeInTheMiddleOfAPicture) {
  VirtualClock clock;
  Effects effects;
  effects.latch = hal::sim::PaletteLatch::at_once;
  Panel panel(hal::sim::paletted(10, 10, 8, 2), clock, effects);
  TearingDetector detector(panel);
  clock.wait_until(panel.frame_time() + 3U * panel.line_time() + 1U);
  ASSERT_TRUE(panel.show(0, Bytes{9, 9, 9}).ok());
  EXPECT_TRUE(panel.show_pending()) << "the buffer waits";
  clock.advance(panel.frame_time());
  ASSERT_EQ(detector.tears().size(), 1U);
  EXPECT_EQ(detector.tears()[0].kind, Tear::Kind::palette);
  EXPECT_EQ(detector.tears()[0].line, 4);
}

TEST(WritePanel, ColoursAppliedAsPixelsAreWrittenStayUntilTheyAreWrittenAgain) {
  for (const ScanDirection scan : {ScanDirection::down, ScanDirection::right}) {
    VirtualClock clock;
    Effects effects;
    effects.scan = scan;
    PanelSpec spec = write_panel(4, 4, 5);
    spec.capabilities.palette_on_write = true;
    Panel panel(spec, clock, effects);
    TearingDetector detector(panel);
    ASSERT_TRUE(panel.load_palette(Bytes{0, 0, 0, 10, 20, 30}).ok());
    ASSERT_TRUE(panel.write({0, 0, 4, 4}, Bytes(16, 1), 4).ok());
    panel.mark_frame();
    clock.advance(panel.frame_time());
    ASSERT_TRUE(panel.load_palette(Bytes{0, 0, 0, 40, 50, 60}).ok());
    EXPECT_EQ(panel.displayed().rgb[0], 10);
    clock.wait_until(panel.frame_time() + 2U * panel.line_time() + 1U);
    ASSERT_TRUE(panel.write({0, 0, 4, 4}, Bytes(16, 1), 4).ok());
    panel.mark_frame();
    EXPECT_EQ(panel.displayed().rgb[0], 40);
    EXPECT_EQ(panel.displayed().rgb[47], 60);
    EXPECT_EQ(panel.displayed().indices[0], 1);
    clock.advance(panel.frame_time());
    ASSERT_EQ(detector.tears().size(), 1U) << "the same indices in other colours are another picture";
    EXPECT_EQ(detector.tears()[0].refresh, 1U);
    EXPECT_EQ(detector.tears()[0].line, 3);
  }
}

TEST(GarbageEffect, MemoryIsNoiseUntilItIsWritten) {
  const auto picture = [](std::uint64_t seed) {
    VirtualClock clock;
    Effects effects;
    effects.garbage = hal::sim::PowerOnGarbage{seed};
    Panel panel(write_panel(16, 16, 20), clock, effects);
    return panel.displayed();
  };
  EXPECT_EQ(picture(1), picture(1));
  EXPECT_NE(picture(1).indices, picture(2).indices);
  const auto noise = picture(3);
  EXPECT_GT(std::set(noise.indices.begin(), noise.indices.end()).size(), 100U) << "of 256 pixels";
  EXPECT_NE(std::set(noise.rgb.begin(), noise.rgb.end()).size(), 1U);
}

TEST(Observer, AFrameThatIsReplacedBeforeItsVblankIsDropped) {
  VirtualClock clock;
  Panel panel(hal::sim::paletted(4, 10, 8, 2), clock);
  Witness witness;
  panel.attach(witness);
  ASSERT_TRUE(panel.show(1, {}).ok());
  ASSERT_TRUE(panel.show(0, {}).ok());
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  ASSERT_TRUE(panel.show(1, {}).ok());
  EXPECT_EQ(witness.dropped, std::vector<std::uint32_t>{1});
  panel.detach(witness);
}

}  // namespace
