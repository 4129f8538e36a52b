// SPDX-License-Identifier: MIT
//
// What is recorded of a run, and what is said of it.
#include <host/sim/explain.hpp>
#include <host/sim/timeline.hpp>
#include <intaglio/present/run.hpp>
#include <tests/oracle/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using hal::Nanoseconds;
using hal::sim::Effects;
using hal::sim::Panel;
using hal::sim::TearingDetector;
using hal::sim::VirtualClock;
using host::FrameRecord;
using host::Timeline;
using Bytes = std::vector<std::uint8_t>;

constexpr Nanoseconds millisecond = 1'000'000;

/// A bus that takes so many milliseconds for the pixels of a `Stage`, and no time for anything else.
hal::sim::BusTiming picture_in(std::uint32_t milliseconds) {
  return {.hertz = 32U * 240U * 1000U / milliseconds,
          .clocks_per_byte = 1,
          .bits_per_pixel = 8,
          .command_bytes = 0,
          .gap = 0};
}

/// A panel of 32x240 pixels, a buffer or a bus, with all that watches it.
struct Stage {
  explicit Stage(int buffers, const Effects& effects = {})
      : panel(hal::sim::paletted(32, 240, 8, buffers), clock, effects),
        detector(panel),
        timeline(panel, clock, 1) {}

  void draw(std::uint32_t frame, Nanoseconds time) {
    timeline.draw_begins(frame);
    clock.advance(time);
    timeline.draw_ends();
  }
  void show(std::uint32_t frame) {
    const int buffer = static_cast<int>(frame + 1U) % panel.capabilities().buffers;
    std::ranges::fill(panel.buffer(buffer), static_cast<std::uint8_t>(frame + 1U));
    ASSERT_TRUE(panel.show(buffer, {}).ok());
  }
  void send(std::uint32_t frame) {
    ASSERT_TRUE(
        panel.write({0, 0, 32, 240}, Bytes(32U * 240U, static_cast<std::uint8_t>(frame + 1U)), 32).ok());
    panel.mark_frame();
  }
  std::string explanation() { return host::explain(timeline, detector.tears()); }

  VirtualClock clock;
  Panel panel;
  TearingDetector detector;
  Timeline timeline;
};

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Explain, AGoodRunHasNothingToTell) {
  Stage stage(2);
  for (std::uint32_t frame = 0; frame < 5; ++frame) {
    stage.draw(frame, 3U * millisecond);
    stage.show(frame);
    ASSERT_TRUE(stage.panel.wait_for_vblank().ok());
  }
  EXPECT_EQ(stage.explanation(), "5 frames in 5 refreshes of 16.67 ms: 0 torn, 0 late, 0 dropped.\n");
}

TEST(Explain, AFrameThatTookTooLongToDrawWasLate) {
  Stage stage(2);
  for (std::uint32_t frame = 0; frame < 3; ++frame) {
    stage.draw(frame, frame == 1 ? 20U * millisecond : millisecond);
    stage.show(frame);
    ASSERT_TRUE(stage.panel.wait_for_vblank().ok());
  }
  EXPECT_EQ(stage.explanation(),
            "3 frames in 4 refreshes of 16.67 ms: 0 torn, 1 late, 0 dropped.\n"
            "Frame 1 was late by 1 refresh: due 16.67 ms after the frame before, it came after 33.33 ms. "
            "Drawing took "
            "20.00 ms. Drawing alone takes longer than a frame may.\n");
}

TEST(Explain, AFrameThatWasReplacedWasDropped) {
  Stage stage(3);
  stage.draw(0, millisecond);
  stage.show(0);
  stage.draw(1, 2U * millisecond);
  stage.show(1);
  ASSERT_TRUE(stage.panel.wait_for_vblank().ok());
  const std::string text = stage.explanation();
  EXPECT_TRUE(holds(text, "0 torn, 0 late, 1 dropped.")) << text;
  EXPECT_TRUE(
      holds(text, "Frame 0 was dropped: it was asked for, but 2.00 ms later, before its VBLANK, another"))
      << text;
}

TEST(Explain, ABusSlowerThanTheBeamTears) {
  Effects effects;
  effects.bus = picture_in(18);
  Stage stage(0, effects);
  for (std::uint32_t frame = 0; frame < 2; ++frame) {
    ASSERT_TRUE(stage.panel.wait_for_vblank().ok());
    stage.draw(frame, 0);
    stage.send(frame);
  }
  stage.clock.advance(2U * stage.panel.frame_time());
  const std::string text = stage.explanation();
  // Line 117: tests/hal/effects_of_time.cpp. Six lines are half sent when the beam comes.
  EXPECT_TRUE(holds(
      text,
      "Frame 0 tore in refresh 1: frame 0 up to line 117, what was there at the start from 123 on, both"))
      << text;
  EXPECT_TRUE(
      holds(text,
            "Sending 7680 bytes took 18.00 ms, a refresh takes 16.67 ms. Sending began 1.40 ms before the "
            "refresh; the beam overtook the bus."))
      << text;
  EXPECT_TRUE(holds(text, "2 torn")) << text;
}

TEST(Explain, ASendingOutsideOfVblankTears) {
  Effects effects;
  effects.bus = picture_in(5);
  Stage stage(0, effects);
  stage.clock.wait_until(3U * stage.panel.frame_time() + 4U * millisecond);
  stage.draw(0, 0);
  stage.send(0);
  stage.clock.advance(2U * stage.panel.frame_time());
  const std::string text = stage.explanation();
  EXPECT_TRUE(
      holds(text,
            "Sending began 4.00 ms into the refresh, with the beam at line 62, and not in VBLANK; the bus "
            "overtook the beam."))
      << text;
}

TEST(Explain, ABeamThatGoesAnotherWayIsntSaidToBeOvertaken) {
  struct Case {
    hal::ScanDirection scan;
    const char* beam;
  };
  for (const Case& c : {Case{hal::ScanDirection::up, "with the beam at line 177"},
                        Case{hal::ScanDirection::right, "with the beam at column 8"},
                        Case{hal::ScanDirection::left, "with the beam at column 23"}}) {
    Effects effects;
    effects.bus = picture_in(5);
    effects.scan = c.scan;
    Stage stage(0, effects);
    stage.clock.wait_until(3U * stage.panel.frame_time() + 4U * millisecond);
    stage.draw(0, 0);
    stage.send(0);
    const Nanoseconds late = stage.panel.frame_time() * 6U - 3U * millisecond;
    stage.clock.wait_until(late);
    stage.draw(1, 0);
    stage.send(1);
    stage.clock.advance(2U * stage.panel.frame_time());
    const std::string text = stage.explanation();
    EXPECT_TRUE(holds(text, std::string(c.beam) + ", and not in VBLANK; the bus crossed the beam.")) << text;
    EXPECT_TRUE(holds(text, "ms before the refresh; the beam crossed the bus.")) << text;
    EXPECT_FALSE(holds(text, "overtook")) << text;
  }
}

TEST(Explain, ABufferSwappedInMidPictureIsTheCause) {
  Effects effects;
  effects.latch = hal::sim::PaletteLatch::both_at_once;
  Stage stage(2, effects);
  stage.draw(0, 5U * millisecond);
  stage.show(0);
  stage.clock.advance(2U * stage.panel.frame_time());
  const std::string text = stage.explanation();
  EXPECT_TRUE(
      holds(text,
            "Frame 0 tore in refresh 0: what was there at the start up to line 79, from there on frame 0. "
            "The buffer was swapped 5.00 ms after the refresh began: nothing held the request back"))
      << text;
}

TEST(Explain, FramesInSuccessionThatWereLateAlikeAreToldTogether) {
  Stage stage(2);
  for (std::uint32_t frame = 0; frame < 12; ++frame) {
    stage.draw(frame, frame == 8 ? millisecond : 20U * millisecond);
    stage.show(frame);
    ASSERT_TRUE(stage.panel.wait_for_vblank().ok());
  }
  const std::string late =
      "was late by 1 refresh: due 16.67 ms after the frame before, it came after 33.33 ms. Drawing took "
      "20.00 ms. Drawing alone takes longer than a frame may.\n";
  EXPECT_EQ(stage.explanation(),
            "12 frames in 23 refreshes of 16.67 ms: 0 torn, 10 late, 0 dropped.\n"
            "Each of frames 1 to 7 " +
                late + "Each of frames 9 to 11 " + late);
}

TEST(Explain, TheManyRefreshesOfOneFrameAreCounted) {
  Effects effects;
  effects.bus = picture_in(100);
  Stage stage(0, effects);
  stage.draw(0, 0);
  stage.send(0);  // 100 ms: torn in refreshes 1 to 5, and in 0 by its first bytes.
  stage.clock.advance(2U * stage.panel.frame_time());
  const std::string text = stage.explanation();
  EXPECT_EQ(std::ranges::count(text, '\n'), 5) << text;
  EXPECT_TRUE(holds(text, "Frame 0 tore in 2 refreshes more, the last of them refresh 5.\n")) << text;
}

TEST(Explain, ALongListIsCut) {
  Stage stage(2);
  for (std::uint32_t frame = 0; frame < 30; ++frame) {
    stage.draw(frame, (20U + frame % 2U) * millisecond);
    stage.show(frame);
    ASSERT_TRUE(stage.panel.wait_for_vblank().ok());
  }
  const std::string text = stage.explanation();
  EXPECT_EQ(std::ranges::count(text, '\n'), 22);
  EXPECT_TRUE(holds(text, "... and 9 more.")) << text;
}

/// A program whose drawing takes random time.
class Slow {
 public:
  Slow(Stage& stage, oracle::Random& random) : stage_(&stage), random_(&random) {}
  void update(std::uint32_t frame) { frame_ = frame; }
  [[nodiscard]] std::span<const std::uint8_t> palette() const { return {}; }
  intaglio::Status draw(intaglio::image::Surface<intaglio::image::Indexed8>) const {
    stage_->draw(frame_, static_cast<Nanoseconds>(random_->between(0, 40)) * millisecond);
    return {};
  }

 private:
  Stage* stage_;
  oracle::Random* random_;
  std::uint32_t frame_ = 0;
};

template <class Screen>
void expect_counters_agree(Stage& stage, Screen& screen) {
  oracle::Random random(61);
  Slow program(stage, random);
  std::uint32_t dropped = 0;
  const auto on_frame = [&](std::uint32_t) {
    if (screen.counts().dropped != dropped) {
      stage.timeline.drop();
    } else if (stage.panel.capabilities().buffers == 0) {
      stage.panel.mark_frame();
    }
    dropped = screen.counts().dropped;
  };
  ASSERT_TRUE(intaglio::present::run(program, screen, 200, on_frame).ok());
  const auto& frames = stage.timeline.frames();
  ASSERT_EQ(frames.size(), 200U);
  const auto late = std::ranges::count_if(frames, [](const FrameRecord& frame) { return frame.late > 0; });
  EXPECT_EQ(static_cast<std::uint32_t>(late), screen.counts().late);
  EXPECT_EQ(std::ranges::count_if(frames, &FrameRecord::dropped), screen.counts().dropped);
  EXPECT_GT(late, 20);
  EXPECT_LT(late, 180);
  for (const FrameRecord& frame : frames) {
    EXPECT_NE(frame.appeared, frame.dropped);
    EXPECT_TRUE(frame.draw && frame.presented.has_value() == frame.appeared);
  }
}

TEST(Timeline, CountsTheLateFramesThatTheSwapChainCounts) {
  Stage stage(2);
  intaglio::present::SwapChain<intaglio::image::Indexed8> screen(stage.panel);
  expect_counters_agree(stage, screen);
}

TEST(Timeline, CountsTheDroppedFramesThatTheSwapChainCounts) {
  Stage stage(2);
  intaglio::present::SwapChain<intaglio::image::Indexed8> screen(stage.panel,
                                                                 {1, intaglio::present::Late::drop});
  expect_counters_agree(stage, screen);
  EXPECT_GT(screen.counts().dropped, 20U);
}

TEST(Timeline, CountsTheDroppedFramesThatTheFrameWriterCounts) {
  Stage stage(0);
  Bytes memory(32U * 240U);
  intaglio::present::FrameWriter<intaglio::image::Indexed8> screen(stage.panel, memory,
                                                                   {1, intaglio::present::Late::drop});
  expect_counters_agree(stage, screen);
  EXPECT_GT(screen.counts().dropped, 20U);
}

TEST(Timeline, NamesTornFramesAsTheProgramDoesWhereSomeWereDropped) {
  Stage stage(2);
  stage.draw(0, 0);
  stage.show(0);
  stage.draw(1, 0);
  stage.timeline.drop();
  stage.draw(2, 0);
  stage.show(2);
  hal::sim::Tear tear;
  tear.above = 0;
  tear.below = 2;
  const auto named = stage.timeline.of_frames({tear});
  EXPECT_EQ(named[0].above, 0U);
  EXPECT_EQ(named[0].below, 3U);
}

TEST(Timeline, CountsTheLateFramesThatTheFrameWriterCounts) {
  Effects effects;
  effects.bus = hal::sim::BusTiming{.hertz = 20'000'000};
  Stage stage(0, effects);
  Bytes memory(32U * 240U);
  intaglio::present::FrameWriter<intaglio::image::Indexed8> screen(stage.panel, memory);
  expect_counters_agree(stage, screen);
}

}  // namespace
