// SPDX-License-Identifier: MIT
//
// What is found out about bus and beam, and what is said of it.
#include <host/attach/beam.hpp>
#include <intaglio/present/frame_writer.hpp>
#include <tests/present/slow_panel.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace {

using hal::Nanoseconds;
using hal::ScanDirection;
using hal::sim::VirtualClock;
using host::ClockedBus;
using intaglio::present::BeamTiming;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr ScanDirection all_directions[] = {ScanDirection::down, ScanDirection::up, ScanDirection::right,
                                            ScanDirection::left};

/// VBLANKs at these times.
class Told final : public hal::VblankSource {
 public:
  explicit Told(std::vector<Nanoseconds> times) : times_(std::move(times)) {}

 private:
  std::uint32_t do_count() noexcept override { return static_cast<std::uint32_t>(next_); }
  hal::Status do_wait() noexcept override {
    if (next_ == times_.size()) return {hal::Error::timeout, hal::Part::pin};
    ++next_;
    return {};
  }
  Nanoseconds do_last() noexcept override { return next_ == 0 ? 0 : times_[next_ - 1]; }

  std::vector<Nanoseconds> times_;
  std::size_t next_ = 0;
};

TEST(Refresh, IsTheMeanOfWhatIsToldAndLeapsDoNotCount) {
  constexpr Nanoseconds period = 16'856'000;
  std::mt19937 random(60'701);
  std::vector<Nanoseconds> times;
  Nanoseconds leapt = 0;
  for (unsigned n = 0; n < 20; ++n) {
    if (n == 3) leapt += 5 * period;   // Edges that were lost,
    if (n == 8) leapt += period / 3U;  // and a machine that stood still.
    times.push_back(1'000'000 + leapt + n * period + random() % 40'000U);
  }
  Told told(times);
  const auto refresh = host::measured_refresh(told);
  ASSERT_TRUE(refresh.has_value());
  EXPECT_NEAR(static_cast<double>(*refresh), static_cast<double>(period), 20'000.0);
}

TEST(Refresh, IsNoneWhereNothingIsTold) {
  Told none({});
  EXPECT_FALSE(host::measured_refresh(none).has_value());
  Told few({1'000, 2'000, 3'000});
  EXPECT_FALSE(host::measured_refresh(few).has_value());
}

BeamTiming timing_of(Nanoseconds bus_line, Nanoseconds bus_band = 10'000) {
  return host::beam_timing({.before = 24, .total = 344}, 16'856'000, {bus_line, bus_band});
}

TEST(Bus, IsTimedAsFramesUseIt) {
  for (const ScanDirection scan : all_directions) {
    VirtualClock clock;
    const BeamTiming timing{.refresh = 60'000'000,
                            .first_line = 1'000'000,
                            .scan_line = 200'000,
                            .bus_line = 75'040,
                            .bus_band = 9'000};
    slow::SlowPanel panel(clock, 48, 80, scan, timing);
    const auto bus = host::measured_bus(panel, clock);
    ASSERT_TRUE(bus.has_value());
    EXPECT_NEAR(static_cast<double>(bus->line), 75'040, 8) << static_cast<int>(scan);
    EXPECT_NEAR(static_cast<double>(bus->band), 9'000, 200) << static_cast<int>(scan);
    EXPECT_EQ(panel.glass, std::vector<std::uint16_t>(std::size_t{48} * 80)) << "it stays dark";
    panel.writes_until_fault = 2;
    EXPECT_FALSE(host::measured_bus(panel, clock).has_value());
  }
}

TEST(Beam, GoesThroughTheLinesOfTheController) {
  const BeamTiming t = host::beam_timing({.before = 64, .total = 344}, 16'856'000, {50'000, 7'000});
  EXPECT_EQ(t.scan_line, 49'000U);
  EXPECT_EQ(t.first_line, 64U * 49'000U);
  EXPECT_EQ(t.bus_line, 50'000U);
  EXPECT_EQ(t.bus_band, 7'000U);
  EXPECT_EQ(t.draw_line, 0U) << "frames are drawn before they are sent";
}

hal::Capabilities tft(ScanDirection scan) {
  const bool turned = scan == ScanDirection::left || scan == ScanDirection::right;
  return {.width = turned ? 320 : 240, .height = turned ? 240 : 320, .buffers = 0, .scan = scan};
}

TEST(Tearing, BeginsWhereItIsSaid) {
  for (const ScanDirection scan : all_directions) {
    const Nanoseconds slowest = host::slowest_line(timing_of(1), tft(scan));
    ASSERT_GT(slowest, 0U);
    EXPECT_TRUE(host::tear_free(timing_of(slowest), tft(scan)));
    EXPECT_TRUE(host::tear_free(timing_of(slowest / 2U), tft(scan)));
    EXPECT_TRUE(host::tear_free(timing_of(1), tft(scan)));
    EXPECT_FALSE(host::tear_free(timing_of(slowest + 1U), tft(scan)));
    EXPECT_FALSE(host::tear_free(timing_of(slowest * 2U), tft(scan)));
  }
  // Nearly two refreshes where bus and beam go the same way.
  EXPECT_GT(host::slowest_line(timing_of(1), tft(ScanDirection::down)), 49'000U * 19U / 10U);
  EXPECT_EQ(host::slowest_line(timing_of(1, 20'000'000), tft(ScanDirection::down)), 0U);
}

TEST(Tearing, AClockThatIsSaidToDoDoesAndALowerOneDoesNot) {
  std::mt19937 random(60'702);
  int found = 0;
  for (int round = 0; round < 50; ++round) {
    const hal::Capabilities panel = tft(all_directions[random() % 4U]);
    const ClockedBus bus{.hertz = static_cast<std::uint32_t>(1'000'000U + random() % 20'000'000U),
                         .line_bits = 240 * 16};
    const Nanoseconds rest = random() % 60'000U;
    const auto line = [&](std::uint32_t hertz) {
      return rest + bus.line_bits * Nanoseconds{1'000'000'000} / hertz;
    };
    const auto hertz = host::sufficient_hertz(timing_of(line(bus.hertz)), panel, bus);
    if (!hertz) {
      EXPECT_FALSE(host::tear_free(timing_of(line(80'000'000)), panel));
      continue;
    }
    ++found;
    EXPECT_EQ(*hertz % 100'000U, 0U);
    EXPECT_TRUE(host::tear_free(timing_of(line(*hertz)), panel)) << *hertz;
    EXPECT_FALSE(host::tear_free(timing_of(line(*hertz - 100'000U)), panel)) << *hertz;
  }
  EXPECT_GT(found, 25);
  EXPECT_LT(found, 50);
}

TEST(Tearing, IsSaidWithWhatWouldHelp) {
  // 240 pixels of 16 bits at 10 MHz.
  const ClockedBus spi{.hertz = 10'000'000, .line_bits = 240 * 16};
  const hal::Capabilities down = tft(ScanDirection::down);
  const std::string said = host::tearing_notice(timing_of(384'000), down, spi);
  const std::string hertz = std::to_string(host::sufficient_hertz(timing_of(384'000), down, spi).value_or(0));
  EXPECT_THAT(said, AllOf(HasSubstr("the bus takes 123.1 ms for a picture and the beam 16.9 ms"),
                          HasSubstr("--spi-hz " + hertz), Not(HasSubstr("--rotate"))));
  EXPECT_EQ(said.back(), '\n');
  EXPECT_EQ(host::tearing_notice(timing_of(90'000), down, spi), "");
  const hal::Capabilities right = tft(ScanDirection::right);
  const Nanoseconds between =
      (host::slowest_line(timing_of(1), right) + host::slowest_line(timing_of(1), down)) / 2U;
  EXPECT_EQ(host::tearing_notice(timing_of(between), down, spi), "");
  EXPECT_THAT(host::tearing_notice(timing_of(between), right, spi), HasSubstr("--rotate"));
  EXPECT_THAT(host::tearing_notice(timing_of(384'000 + 100'000), down, spi), HasSubstr("no clock"));
  EXPECT_THAT(host::tearing_notice(timing_of(384'000), down, {}),
              AllOf(HasSubstr("--spi)"), Not(HasSubstr("--spi-hz"))));
  EXPECT_THAT(host::tearing_notice(timing_of(1'000, 20'000'000), down, spi), HasSubstr("any bus"));
}

}  // namespace
