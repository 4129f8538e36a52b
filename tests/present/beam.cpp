// SPDX-License-Identifier: MIT
//
// Racing the beam: windows against brute force over every start, and pictures on a panel whose bus takes time
// and whose glass remembers what each refresh showed.
#include <hal/sim/virtual_clock.hpp>
#include <intaglio/present/bands.hpp>
#include <intaglio/present/frame_writer.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/present/slow_panel.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <utility>
#include <vector>

namespace {

using hal::Nanoseconds;
using hal::ScanDirection;
using hal::sim::VirtualClock;
using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::image::Indexed8;
using intaglio::image::Surface;
using intaglio::present::BandSizes;
using intaglio::present::BandWriter;
using intaglio::present::BeamChaser;
using intaglio::present::BeamTiming;
using intaglio::present::FrameCounts;
using intaglio::present::FrameWriter;
using intaglio::present::Late;
using intaglio::present::Pace;
using intaglio::present::Pacer;
using intaglio::present::picture_window;
using intaglio::present::start_window;
using intaglio::present::StartWindow;
using intaglio::present::Travel;
using slow::SlowPanel;

/// By the definition, moment by moment: no line is fetched, in the refresh before or the one wanted, while it
/// is being sent, or sent before the former or after the latter.
bool undisturbed(const BeamTiming& t, int first, int end, Travel travel, std::int64_t start) {
  const auto scan = static_cast<std::int64_t>(t.scan_line);
  const auto bus = static_cast<std::int64_t>(t.bus_line);
  const auto band = static_cast<std::int64_t>(t.bus_band);
  const auto margin = static_cast<std::int64_t>(t.margin);
  for (int line = first; line < end; ++line) {
    int before = line - first;
    if (travel == Travel::against) before = end - 1 - line;
    // What a write takes beside its pixels may come before them or not at all.
    std::int64_t send_begin = start + before * bus;
    std::int64_t send_end = start + band + (before + 1) * bus;
    if (travel == Travel::across) {
      send_begin = start;
      send_end = start + band + (end - first) * bus;
    }
    const std::int64_t wanted = static_cast<std::int64_t>(t.first_line) + line * scan;
    const std::int64_t old_end = wanted - static_cast<std::int64_t>(t.refresh) + scan;
    if (send_begin < old_end + margin || send_end > wanted - margin) return false;
  }
  return true;
}

TEST(BeamRace, WindowIsExactlyTheStartsAtWhichNoLineIsMet) {
  int open = 0;
  for (const Travel travel : {Travel::along, Travel::against, Travel::across})
    for (const Nanoseconds scan : {1U, 3U})
      for (const Nanoseconds bus : {1U, 2U, 3U, 4U, 7U})
        for (const Nanoseconds overhead : {0U, 2U})
          for (const Nanoseconds margin : {0U, 1U})
            for (int first = 0; first < 6; ++first)
              for (int end = first + 1; end <= 6; ++end) {
                const BeamTiming t{.refresh = 25,
                                   .first_line = 4,
                                   .scan_line = scan,
                                   .bus_line = bus,
                                   .bus_band = overhead,
                                   .margin = margin};
                const StartWindow window = start_window(t, first, end, travel);
                int wrong = 0;
                for (std::int64_t start = -80; start < 80; ++start) {
                  const bool inside = start >= window.earliest && start <= window.latest;
                  wrong += inside != undisturbed(t, first, end, travel, start) ? 1 : 0;
                }
                ASSERT_EQ(wrong, 0) << first << ' ' << end << " scan " << scan << " bus " << bus;
                open += window.open() ? 1 : 0;
              }
  EXPECT_GT(open, 100);
}

/// True if bands begun from `start` on, each as soon as it is ready and may be sent, keep their windows.
bool picture_goes(const BeamTiming& t, const BandSizes& sizes, Travel travel, std::int64_t start) {
  std::int64_t now = start;
  for (int first = 0, count = sizes.first; first < sizes.lines; first += count, count = sizes.band) {
    const int end = std::min(first + count, sizes.lines);
    if (first > 0) now += (end - first) * static_cast<std::int64_t>(t.draw_line);
    while (!undisturbed(t, first, end, travel, now))
      if (++now > 300) return false;
    if (first == 0 && now != start) return false;
    now += static_cast<std::int64_t>(t.bus_band) + (end - first) * static_cast<std::int64_t>(t.bus_line);
  }
  return true;
}

TEST(BeamRace, WindowOfAPictureIsExactlyTheStartsFromWhichAllBandsKeepTheirs) {
  std::vector<BandSizes> cuts{{1, 1, 1}};
  for (const int lines : {7, 8})
    for (int band = 1; band <= lines; ++band) {
      cuts.push_back({lines, band, band});
      cuts.push_back({lines, (lines - 1) % band + 1, band});
    }
  int open = 0;
  for (const Travel travel : {Travel::along, Travel::against, Travel::across})
    for (const Nanoseconds bus : {1U, 2U, 3U, 5U, 6U})
      for (const Nanoseconds draw : {0U, 1U, 3U})
        for (const Nanoseconds overhead : {0U, 2U})
          for (const BandSizes& cut : cuts) {
            const BeamTiming t{.refresh = 30,
                               .first_line = 3,
                               .scan_line = 3,
                               .bus_line = bus,
                               .bus_band = overhead,
                               .draw_line = draw};
            const StartWindow window = picture_window(t, cut, travel);
            int wrong = 0;
            for (std::int64_t start = -60; start < 60; ++start) {
              const bool inside = start >= window.earliest && start <= window.latest;
              wrong += inside != picture_goes(t, cut, travel, start) ? 1 : 0;
            }
            ASSERT_EQ(wrong, 0) << cut.lines << ": " << cut.first << ", " << cut.band << " bus " << bus
                                << " draw " << draw << " travel " << static_cast<int>(travel);
            open += window.open() ? 1 : 0;
          }
  EXPECT_GT(open, 100);
}

TEST(BeamRace, ABusMayTakeNearlyTwoRefreshes) {
  // 240 lines in 16 ms of a refresh of 16.666667 ms, sent line by line.
  BeamTiming t{.refresh = 16'666'667, .first_line = 500'000, .scan_line = 66'666};
  const auto bus_line_of = [](Nanoseconds picture) { return picture / 240U; };
  const Nanoseconds most = t.refresh + 238U * t.scan_line;
  t.bus_line = bus_line_of(most);
  EXPECT_TRUE(picture_window(t, {240, 1, 1}, Travel::along).open());
  t.bus_line = bus_line_of(most) + 1U;
  EXPECT_FALSE(picture_window(t, {240, 1, 1}, Travel::along).open());
  t.bus_line = 75'000;  // 18 ms
  const StartWindow window = picture_window(t, {240, 240, 240}, Travel::along);
  EXPECT_EQ(window.earliest, 500'000 + 66'666 - 16'666'667) << "right behind the beam";
  EXPECT_EQ(window.latest, 500'000 + 239 * 66'666 - 18'000'000) << "before it comes again";
}

constexpr int width = 24;
constexpr int height = 18;

BeamTiming timing_of(ScanDirection scan, Nanoseconds bus_line) {
  const bool sideways = scan == ScanDirection::left || scan == ScanDirection::right;
  const Nanoseconds lines = sideways ? width : height;
  return {.refresh = 60'000,
          .first_line = 3'000,
          .scan_line = 50'000 / lines,
          .bus_line = bus_line,
          .bus_band = 200,
          .draw_line = 40,
          .margin = 100};
}

/// Fills a band with the number of its frame.
auto drawing(std::uint32_t frame, VirtualClock& clock, Nanoseconds time) {
  return [frame, &clock, time](const Surface<Indexed8>& band) {
    clock.advance(time);
    const auto b = band.bounds();
    for (int y = b.y; y < b.bottom(); ++y)
      for (int x = b.x; x < b.right(); ++x) band.set(x, y, frame & 255U);
    return Status{};
  };
}

TEST(BeamChaser, IsNeverTornWhereItSaysSoInAllDirections) {
  constexpr unsigned seed = 50'001;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  int possible = 0;
  int impossible = 0;
  for (int round = 0; round < oracle::samples(300, 20'000); ++round) {
    const auto scan = static_cast<ScanDirection>(random() % 4U);
    const bool sideways = scan == ScanDirection::left || scan == ScanDirection::right;
    const BeamTiming timing = timing_of(scan, 300U + random() % 5'000U);
    const int band = 1 + static_cast<int>(random() % 6U);
    VirtualClock clock;
    SlowPanel panel(clock, width, height, scan, timing);
    panel.signal_delay = random() % 100U;
    BeamChaser chaser(clock, panel, timing);
    std::vector<std::uint8_t> memory(static_cast<std::size_t>(band * (sideways ? height : width)));
    const int interval = 1 + static_cast<int>(random() % 3U);
    BandWriter<Indexed8> writer(panel, memory, chaser, interval);
    ASSERT_TRUE(writer.status().ok());
    ASSERT_EQ(writer.rows(), band);
    constexpr std::uint32_t frames = 12;
    for (std::uint32_t n = 1; n <= frames; ++n) {
      const Nanoseconds most = timing.draw_line * static_cast<unsigned>(band);
      ASSERT_TRUE(writer.present(drawing(n, clock, random() % (most + 1U))).ok());
      ASSERT_EQ(std::ranges::count(panel.glass, n), width * height) << "every pixel of the frame is there";
      if (random() % 3U == 0) clock.advance(random() % 100'000U);
    }
    clock.advance(2U * timing.refresh);
    ASSERT_EQ(writer.counts().shown, frames);
    if (chaser.tear_free()) {
      ++possible;
      ASSERT_EQ(panel.torn, 0U) << "bus " << timing.bus_line << " band " << band << " direction "
                                << static_cast<int>(scan);
      ASSERT_EQ(chaser.torn(), 0U);
    } else {
      ++impossible;
      ASSERT_EQ(chaser.torn(), frames);
    }
  }
  EXPECT_GT(possible, 50);
  EXPECT_GT(impossible, 30);
}

TEST(BeamChaser, SendsWholeFramesFromMemoryWithoutTearsToo) {
  constexpr unsigned seed = 50'003;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  int possible = 0;
  for (int round = 0; round < oracle::samples(200, 10'000); ++round) {
    const auto scan = static_cast<ScanDirection>(random() % 4U);
    BeamTiming timing = timing_of(scan, 300U + random() % 4'000U);
    timing.draw_line = 0;
    VirtualClock clock;
    SlowPanel panel(clock, width, height, scan, timing);
    BeamChaser chaser(clock, panel, timing);
    std::vector<std::uint8_t> memory(std::size_t{width} * height);
    FrameWriter<Indexed8> writer(panel, memory, chaser, 1 + static_cast<int>(random() % 2U));
    ASSERT_TRUE(writer.status().ok());
    constexpr std::uint32_t frames = 10;
    for (std::uint32_t n = 1; n <= frames; ++n) {
      auto begun = writer.begin();
      ASSERT_TRUE(drawing(n, clock, random() % 70'000U)(begun.value().surface()).ok());
      ASSERT_TRUE(writer.present(std::move(begun).value()).ok());
      ASSERT_EQ(std::ranges::count(panel.glass, n), width * height);
    }
    clock.advance(2U * timing.refresh);
    ASSERT_EQ(writer.counts().shown, frames);
    ASSERT_EQ(chaser.torn(), chaser.tear_free() ? 0U : frames);
    if (!chaser.tear_free()) continue;
    ++possible;
    ASSERT_EQ(panel.torn, 0U) << "bus " << timing.bus_line << " direction " << static_cast<int>(scan);
  }
  EXPECT_GT(possible, 50);
}

TEST(BeamChaser, SendsOnlyBandsOnWhichSomethingChanged) {
  for (const auto scan :
       {ScanDirection::down, ScanDirection::up, ScanDirection::left, ScanDirection::right}) {
    const BeamTiming timing = timing_of(scan, 1'000);
    VirtualClock clock;
    SlowPanel panel(clock, width, height, scan, timing);
    BeamChaser chaser(clock, panel, timing);
    std::vector<std::uint8_t> memory(std::size_t{width} * height);
    FrameWriter<Indexed8> writer(panel, memory, chaser);
    ASSERT_TRUE(writer.present(writer.begin().value()).ok());
    memory.back() = 7;
    memory.front() = 9;  // Not said to have changed, and on another band.
    const std::array<intaglio::linear::Rect, 1> corner{intaglio::linear::Rect{width - 1, height - 1, 1, 1}};
    ASSERT_TRUE(writer.present(writer.begin().value(), {}, corner).ok());
    EXPECT_EQ(panel.glass.back(), 7);
    EXPECT_EQ(panel.glass.front(), 0);
    ASSERT_TRUE(writer.present(writer.begin().value()).ok());
    EXPECT_EQ(panel.glass.front(), 9);
  }
}

TEST(BeamChaser, WithoutItTheSamePicturesAreTorn) {
  const BeamTiming timing = timing_of(ScanDirection::down, 3'000);
  VirtualClock clock;
  SlowPanel panel(clock, width, height, ScanDirection::down, timing);
  std::vector<std::uint8_t> memory(4 * width);
  BandWriter<Indexed8> writer(panel, memory);
  for (std::uint32_t n = 1; n <= 20; ++n) ASSERT_TRUE(writer.present(drawing(n, clock, 50)).ok());
  EXPECT_GT(panel.torn, 10U);
}

TEST(BeamChaser, CountsEveryTearThatSlowDrawingMakes) {
  std::mt19937 random(50'002);
  const BeamTiming timing = timing_of(ScanDirection::down, 2'000);
  VirtualClock clock;
  SlowPanel panel(clock, width, height, ScanDirection::down, timing);
  BeamChaser chaser(clock, panel, timing);
  std::vector<std::uint8_t> memory(3 * width);
  BandWriter<Indexed8> writer(panel, memory, chaser);
  for (std::uint32_t n = 1; n <= 100; ++n) {
    const Nanoseconds time = random() % 5U == 0 ? 20'000U : 100U;
    ASSERT_TRUE(writer.present(drawing(n, clock, time)).ok());
  }
  clock.advance(2U * timing.refresh);
  EXPECT_GT(panel.torn, 0U);
  // A picture that is late may tear two refreshes.
  EXPECT_LE(panel.torn, 2U * chaser.torn());
  EXPECT_LT(chaser.torn(), 40U);
}

TEST(BeamChaser, CountsATearThatASlowBusMakes) {
  const BeamTiming timing = timing_of(ScanDirection::down, 3'500);
  VirtualClock clock;
  SlowPanel panel(clock, width, height, ScanDirection::down, timing);
  BeamChaser chaser(clock, panel, timing);
  std::vector<std::uint8_t> memory(std::size_t{height} * width);
  BandWriter<Indexed8> writer(panel, memory, chaser);
  ASSERT_TRUE(writer.present(drawing(1, clock, 50)).ok());
  EXPECT_EQ(chaser.torn(), 0U);
  panel.extra_per_write = timing.refresh;
  ASSERT_TRUE(writer.present(drawing(2, clock, 50)).ok());
  EXPECT_EQ(chaser.torn(), 1U);
}

TEST(BeamChaser, CountsATearInTheLastBandAlone) {
  const BeamTiming timing = timing_of(ScanDirection::down, 3'500);
  VirtualClock clock;
  SlowPanel panel(clock, width, height, ScanDirection::down, timing);
  BeamChaser chaser(clock, panel, timing);
  std::vector<std::uint8_t> memory(std::size_t{width} * height);
  FrameWriter<Indexed8> writer(panel, memory, chaser);
  ASSERT_TRUE(writer.present(writer.begin().value()).ok());
  const std::array<intaglio::linear::Rect, 1> corner{intaglio::linear::Rect{width - 1, height - 1, 1, 1}};
  ASSERT_TRUE(writer.present(writer.begin().value(), {}, corner).ok());
  EXPECT_EQ(chaser.torn(), 0U);
  panel.extra_per_write = timing.refresh;
  ASSERT_TRUE(writer.present(writer.begin().value(), {}, corner).ok());
  EXPECT_EQ(chaser.torn(), 1U);
}

TEST(BeamChaser, CountsEveryTearOfABusThatIsSlowerThanWasSaid) {
  constexpr unsigned seed = 50'004;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  int whole = 0;
  int torn = 0;
  for (int round = 0; round < oracle::samples(400, 20'000); ++round) {
    const auto scan = static_cast<ScanDirection>(random() % 4U);
    const bool sideways = scan == ScanDirection::left || scan == ScanDirection::right;
    const BeamTiming said = timing_of(scan, 500U + random() % 2'000U);
    BeamTiming true_timing = said;
    true_timing.bus_line += random() % 2'000U;
    const int band = 1 + static_cast<int>(random() % 6U);
    VirtualClock clock;
    SlowPanel panel(clock, width, height, scan, true_timing);
    BeamChaser chaser(clock, panel, said);
    std::vector<std::uint8_t> memory(static_cast<std::size_t>(band * (sideways ? height : width)));
    BandWriter<Indexed8> writer(panel, memory, chaser);
    ASSERT_TRUE(writer.status().ok());
    for (std::uint32_t n = 1; n <= 2; ++n)
      ASSERT_TRUE(writer.present(drawing(n, clock, random() % 10U == 0 ? random() % 20'000U : 0U)).ok());
    clock.advance(2U * said.refresh);
    if (panel.torn > 0) {
      ASSERT_GT(chaser.torn(), 0U) << "said " << said.bus_line << ", is " << true_timing.bus_line << " band "
                                   << band << " direction " << static_cast<int>(scan);
    }
    ++(panel.torn > 0 ? torn : whole);
  }
  EXPECT_GT(whole, 50);
  EXPECT_GT(torn, 50);
}

TEST(BeamChaser, GoesOnWhenSignalsDropOut) {
  const BeamTiming timing = timing_of(ScanDirection::down, 2'000);
  VirtualClock clock;
  SlowPanel panel(clock, width, height, ScanDirection::down, timing);
  panel.silent = {false, false, true, false, true, true, true, false, true};
  BeamChaser chaser(clock, panel, timing);
  std::vector<std::uint8_t> memory(6 * width);
  BandWriter<Indexed8> writer(panel, memory, chaser, 2);
  for (std::uint32_t n = 1; n <= 200; ++n) ASSERT_TRUE(writer.present(drawing(n, clock, 100)).ok());
  EXPECT_EQ(panel.torn, 0U);
  EXPECT_EQ(writer.counts(), (FrameCounts{200, 0, 0, 0}));
  // The first frame was aimed at refresh 1 or so, the last 398 later.
  EXPECT_NEAR(static_cast<double>(panel.refreshes), 399.0, 2.0);
}

/// Signals as a test wants them.
struct Signals final : hal::VblankSource {
  std::uint32_t number = 0;
  Nanoseconds at = 0;
  int waits = 0;

 private:
  std::uint32_t do_count() noexcept override { return number; }
  hal::Status do_wait() noexcept override {
    ++waits;
    return {};
  }
  Nanoseconds do_last() noexcept override { return at; }
};

/// A chaser of a picture sent in one piece, which has seen a signal.
struct Chase {
  Chase() {
    clock.advance(timing.refresh);
    signals.number = 0xFFFF'FFFFU;
    signals.at = timing.refresh;
    EXPECT_TRUE(chaser.prepare({height, height, height}, Travel::along).ok());
    first = aim();
  }
  std::uint32_t aim() { return chaser.aim(Pacer{1}).value(); }

  BeamTiming timing = timing_of(ScanDirection::down, 2'000);
  VirtualClock clock;
  Signals signals;
  BeamChaser chaser{clock, signals, timing};
  std::uint32_t first = 0;
};

TEST(BeamChaser, CountsOfSignalsWrap) {
  Chase chase;
  chase.clock.advance(chase.timing.refresh);
  chase.signals.number = 0;
  chase.signals.at += chase.timing.refresh;
  EXPECT_EQ(chase.aim(), chase.first + 1U);
  EXPECT_EQ(chase.signals.waits, 0) << "0 isn't that none has come";
}

TEST(BeamChaser, AimsAtTheFirstRefreshWhoseWindowIsStillOpen) {
  Chase chase;
  const std::int64_t latest = picture_window(chase.timing, {height, height, height}, Travel::along).latest +
                              2 * static_cast<std::int64_t>(chase.timing.refresh);
  hal::Clock& clock = chase.clock;
  const Nanoseconds told = chase.signals.at;
  clock.wait_until(told + static_cast<Nanoseconds>(latest));
  EXPECT_EQ(chase.aim(), 1U) << "two after 2^32 - 1";
  clock.wait_until(told + static_cast<Nanoseconds>(latest) + 1U);
  EXPECT_EQ(chase.aim(), 2U);
  clock.wait_until(told + static_cast<Nanoseconds>(latest) + chase.timing.refresh);
  EXPECT_EQ(chase.aim(), 2U);
}

TEST(BeamChaser, CountsATearFromTheNanosecondAfterTheWindowWasOpen) {
  for (const Nanoseconds late : {0U, 1U}) {
    Chase chase;
    hal::Clock& clock = chase.clock;
    const StartWindow window = start_window(chase.timing, 0, height, Travel::along);
    ASSERT_GE(window.latest, 0) << "the refresh after the signal is aimed at";
    clock.wait_until(chase.signals.at + static_cast<Nanoseconds>(window.latest) + late);
    chase.chaser.before_write(0, height);
    // Late, but so fast that it is out in time: the beam may be in the middle all the same.
    if (late == 0) chase.clock.advance(chase.timing.bus_band + height * chase.timing.bus_line);
    chase.chaser.after_write();
    chase.chaser.complete();
    EXPECT_EQ(chase.chaser.torn(), late);
  }
}

TEST(BeamChaser, GoesOnWhenTheSourceLeaps) {
  Chase chase;
  const Nanoseconds told = chase.signals.at;
  chase.clock.advance(1);
  chase.signals.at = told + 1U;
  EXPECT_EQ(chase.aim(), chase.first) << "a signal that bounces";
  for (const Nanoseconds leap : {Nanoseconds{0}, told - 1U, 1'000U * told}) {
    chase.signals.at = leap;
    EXPECT_EQ(chase.aim(), chase.first) << leap;
  }
  chase.clock.advance(3U * chase.timing.refresh);
  chase.signals.at = told + 3U * chase.timing.refresh;
  EXPECT_EQ(chase.aim(), chase.first + 3U);
}

TEST(BeamChaser, AimsAsFarAheadAsAPaceCanAsk) {
  BeamTiming timing = timing_of(ScanDirection::down, 2'000);
  timing.refresh = 1'000'000'000;
  VirtualClock clock;
  clock.advance(1'000'000'000'000'000'000);
  Signals signals;
  signals.number = 1;
  signals.at = 1'000'000'000'000'000'000;
  BeamChaser chaser(clock, signals, timing);
  ASSERT_TRUE(chaser.prepare({height, height, height}, Travel::along).ok());
  Pacer pacer{Pace(INT32_MAX)};
  pacer.appeared(1);
  EXPECT_EQ(chaser.aim(pacer).value(), 1U + INT32_MAX);
  chaser.before_write(0, height);
  hal::Clock& time = clock;
  EXPECT_NEAR(static_cast<double>(time.now()), 1e18 + 2'147'483'647e9, 2e9);
}

TEST(BeamChaser, DropsOrShowsLateFramesAndCounts) {
  for (const Late late : {Late::show, Late::drop}) {
    const BeamTiming timing = timing_of(ScanDirection::up, 2'000);
    VirtualClock clock;
    SlowPanel panel(clock, width, height, ScanDirection::up, timing);
    BeamChaser chaser(clock, panel, timing);
    std::vector<std::uint8_t> memory(6 * width);
    BandWriter<Indexed8> writer(panel, memory, chaser, Pace(1, late));
    for (std::uint32_t n = 1; n <= 50; ++n) {
      ASSERT_TRUE(writer.present(drawing(n, clock, 100)).ok());
      if (n % 10U == 0) clock.advance(2U * timing.refresh + timing.refresh / 3U);
    }
    EXPECT_EQ(panel.torn, 0U);
    const FrameCounts counts = writer.counts();
    EXPECT_EQ(counts.shown + counts.dropped, 50U);
    EXPECT_EQ(late == Late::show ? counts.late : counts.dropped, 4U) << "those after a pause";
  }
}

TEST(BeamChaser, CountsWholeFramesAsBands) {
  for (const Late late : {Late::show, Late::drop}) {
    const BeamTiming timing = timing_of(ScanDirection::down, 2'000);
    VirtualClock clock;
    SlowPanel panel(clock, width, height, ScanDirection::down, timing);
    BeamChaser chaser(clock, panel, timing);
    std::vector<std::uint8_t> memory(std::size_t{width} * height);
    FrameWriter<Indexed8> writer(panel, memory, chaser, Pace(2, late));
    for (std::uint32_t n = 1; n <= 50; ++n) {
      ASSERT_TRUE(writer.present(writer.begin().value()).ok());
      if (n % 10U == 0) clock.advance(3U * timing.refresh);
    }
    const FrameCounts counts = writer.counts();
    EXPECT_EQ(counts.shown + counts.dropped, 50U);
    EXPECT_EQ(late == Late::show ? counts.late : counts.dropped, 4U) << "those after a pause";
    EXPECT_EQ(counts.repeated, late == Late::show ? 4U : 8U);
    // The one after the last pause may be dropped; no two are.
    for (int i = 0; i < 2; ++i) ASSERT_TRUE(writer.present(writer.begin().value()).ok());
    const FrameCounts before = writer.counts();
    panel.writes_until_fault = 1;
    EXPECT_EQ(writer.present(writer.begin().value()), Status(Error::device, Argument::panel));
    EXPECT_EQ(writer.counts().shown, before.shown);
    EXPECT_EQ(writer.counts().dropped, before.dropped + 1U);
  }
}

TEST(BeamChaser, AFailedWriteLosesTheFrameAndTheNextGoesOn) {
  const BeamTiming timing = timing_of(ScanDirection::down, 2'000);
  VirtualClock clock;
  SlowPanel panel(clock, width, height, ScanDirection::down, timing);
  BeamChaser chaser(clock, panel, timing);
  std::vector<std::uint8_t> memory(6 * width);
  BandWriter<Indexed8> writer(panel, memory, chaser);
  panel.writes_until_fault = 1;
  EXPECT_EQ(writer.present(drawing(1, clock, 0)), Status(Error::device, Argument::panel));
  panel.writes_until_fault = -1;
  EXPECT_TRUE(writer.present(drawing(2, clock, 0)).ok());
  EXPECT_EQ(writer.counts(), (FrameCounts{1, 0, 1, 0}));
}

TEST(BeamChaser, WhoWatchesSeesBandsFromTheTopWhicheverWayTheyAreSent) {
  for (const auto scan :
       {ScanDirection::down, ScanDirection::up, ScanDirection::left, ScanDirection::right}) {
    const BeamTiming timing = timing_of(scan, 1'000);
    VirtualClock clock;
    SlowPanel panel(clock, width, height, scan, timing);
    BeamChaser chaser(clock, panel, timing);
    std::vector<std::uint8_t> memory(5 * width);
    BandWriter<Indexed8> writer(panel, memory, chaser);
    int next = 0;
    const auto watch = [&next](const intaglio::image::Picture<Indexed8>& band) {
      EXPECT_EQ(band.bounds().y, next);
      EXPECT_EQ(band.bounds().width, width);
      next = band.bounds().bottom();
    };
    ASSERT_TRUE(writer.present(drawing(1, clock, 0), {}, watch).ok());
    EXPECT_EQ(next, height);
  }
}

TEST(BeamChaser, TimesThatCannotBeAreRefused) {
  VirtualClock clock;
  const BeamTiming good = timing_of(ScanDirection::down, 2'000);
  SlowPanel panel(clock, width, height, ScanDirection::down, good);
  std::vector<std::uint8_t> memory(6 * width);
  const auto status = [&](const BeamTiming& timing) {
    BeamChaser chaser(clock, panel, timing);
    return BandWriter<Indexed8>(panel, memory, chaser).status();
  };
  EXPECT_TRUE(status(good).ok());
  const Status wrong(Error::out_of_range, Argument::table);
  for (auto member : {&BeamTiming::refresh, &BeamTiming::scan_line, &BeamTiming::bus_line}) {
    BeamTiming bad = good;
    bad.*member = 0;
    EXPECT_EQ(status(bad), wrong);
  }
  BeamTiming bad = good;
  bad.margin = 1'000'000'001U;
  EXPECT_EQ(status(bad), wrong);
  bad = good;
  bad.scan_line = good.refresh / static_cast<Nanoseconds>(height) + 1U;
  EXPECT_EQ(status(bad), wrong);
  BeamTiming most = good;
  most.refresh = 1'000'000'000;
  most.scan_line = 1;
  EXPECT_FALSE(most.valid(0));
  EXPECT_TRUE(most.valid(1));
  EXPECT_TRUE(most.valid(1 << 20));
  EXPECT_FALSE(most.valid((1 << 20) + 1));
}

}  // namespace
