// SPDX-License-Identifier: MIT
#include <hal/sim/catalog.hpp>
#include <hal/sim/panel.hpp>
#include <host/attach/metered_panel.hpp>
#include <tests/host/attach/test_card.hpp>

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace {

using intaglio::present::FrameCounts;
using intaglio::present::Late;

/// Runs 20 frames of the test card; frame 10 takes `pause` longer.
std::string counters_of(const char* panel_name, int interval, hal::Nanoseconds pause) {
  hal::sim::VirtualClock clock;
  hal::sim::Panel panel(*hal::sim::find_panel(panel_name), clock);
  host::MeteredPanel metered(panel, interval);
  const auto on_frame = [&](std::uint32_t frame) {
    metered.frame_shown();
    if (frame == 10) clock.advance(pause);
  };
  EXPECT_TRUE(host::run_test_card(metered, interval, 20, on_frame).ok());
  return metered.counters();
}

TEST(MeteredPanel, CountsFramesThatKeepTime) {
  for (const char* const panel : {"clcd", "ssd1306"}) {
    EXPECT_EQ(counters_of(panel, 1, 0),
              "frames 20\nvblanks 19\nlate_frames 0\nskipped_vblanks 0\nearly_frames 0\ndropped_frames 0\n")
        << panel;
    EXPECT_EQ(counters_of(panel, 3, 0),
              "frames 20\nvblanks 57\nlate_frames 0\nskipped_vblanks 0\nearly_frames 0\ndropped_frames 0\n")
        << panel;
  }
}

TEST(MeteredPanel, CountsWhatAPauseCosts) {
  constexpr hal::Nanoseconds four_refreshes = 4 * 16'666'667;
  EXPECT_EQ(counters_of("clcd", 1, four_refreshes),
            "frames 20\nvblanks 23\nlate_frames 1\nskipped_vblanks 4\nearly_frames 0\ndropped_frames 0\n");
  // What is sent late to a write panel doesn't wait for the VBLANK after.
  EXPECT_EQ(counters_of("ssd1306", 1, four_refreshes),
            "frames 20\nvblanks 22\nlate_frames 1\nskipped_vblanks 3\nearly_frames 0\ndropped_frames 0\n");
}

TEST(MeteredPanel, AgreesWithWhatPresentCounts) {
  std::mt19937 random(60'705);
  std::uint32_t shown_late = 0;
  std::uint32_t dropped = 0;
  for (const char* const name : {"64x32x8", "ssd1306", "tft"})
    for (const Late late : {Late::show, Late::drop})
      for (const int interval : {1, 2, 3}) {
        SCOPED_TRACE(std::string(name) + (late == Late::drop ? ", drop, " : ", show, ") +
                     std::to_string(interval));
        hal::sim::VirtualClock clock;
        hal::sim::PanelSpec spec = hal::sim::find_panel(name).value_or(hal::sim::paletted(64, 32, 8, 0));
        spec.capabilities.palette_on_write = spec.capabilities.buffers == 0;
        hal::sim::Panel panel(spec, clock);
        host::MeteredPanel metered(panel, interval);
        FrameCounts counts;
        const host::RunOptions options{.pace = {interval, late},
                                       .frames = 40,
                                       .on_frame =
                                           [&](std::uint32_t, std::uint32_t) {
                                             if (counts.dropped == metered.dropped_frames())
                                               metered.frame_shown();
                                             else
                                               metered.frame_dropped();
                                             return true;
                                           },
                                       .on_draw =
                                           [&](std::uint32_t, bool begins) {
                                             if (begins && random() % 4U == 0)
                                               clock.advance(random() % (4U * panel.frame_time()));
                                           }};
        ASSERT_TRUE(host::find_program("testcard")->run(metered, options, counts).ok());
        EXPECT_EQ((FrameCounts{metered.frames(), metered.late_frames(), metered.dropped_frames(),
                               metered.skipped_vblanks()}),
                  counts);
        EXPECT_EQ(metered.early_frames(), 0U);
        (late == Late::drop ? dropped : shown_late) += late == Late::drop ? counts.dropped : counts.late;
      }
  EXPECT_GT(shown_late, 20U);
  EXPECT_GT(dropped, 20U);
}

}  // namespace
