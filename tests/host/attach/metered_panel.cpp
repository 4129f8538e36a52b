// SPDX-License-Identifier: MIT
#include <hal/sim/catalog.hpp>
#include <hal/sim/panel.hpp>
#include <host/attach/metered_panel.hpp>
#include <tests/host/attach/test_card.hpp>

#include <gtest/gtest.h>

namespace {

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
              "frames 20\nvblanks 19\nlate_frames 0\nskipped_vblanks 0\nearly_frames 0\n")
        << panel;
    EXPECT_EQ(counters_of(panel, 3, 0),
              "frames 20\nvblanks 57\nlate_frames 0\nskipped_vblanks 0\nearly_frames 0\n")
        << panel;
  }
}

TEST(MeteredPanel, CountsWhatAPauseCosts) {
  constexpr hal::Nanoseconds four_refreshes = 4 * 16'666'667;
  EXPECT_EQ(counters_of("clcd", 1, four_refreshes),
            "frames 20\nvblanks 23\nlate_frames 1\nskipped_vblanks 4\nearly_frames 0\n");
  // What is sent late to a write panel doesn't wait for the VBLANK after.
  EXPECT_EQ(counters_of("ssd1306", 1, four_refreshes),
            "frames 20\nvblanks 22\nlate_frames 1\nskipped_vblanks 3\nearly_frames 0\n");
}

}  // namespace
