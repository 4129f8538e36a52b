// SPDX-License-Identifier: MIT
#include <hal/sim/panel.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace {

using hal::BitOrder;
using hal::Nanoseconds;
using hal::sim::catalog;
using hal::sim::find_panel;
using hal::sim::Observer;
using hal::sim::paletted;
using hal::sim::Panel;
using hal::sim::PanelSpec;
using hal::sim::ScannedLine;
using hal::sim::VirtualClock;

/// Keeps all it sees.
class Witness : public Observer {
 public:
  struct Line {
    std::uint64_t refresh;
    int y;
    Nanoseconds time;
    std::uint8_t first_pixel;
    std::uint8_t first_colour;
  };
  std::vector<Line> lines;
  std::vector<Nanoseconds> vblanks;
  int presented = 0;

 private:
  void on_line(const ScannedLine& line) override {
    lines.push_back({line.refresh, line.y, line.time, line.pixels[0], line.palette[0]});
  }
  void on_vblank(std::uint64_t, Nanoseconds time) override { vblanks.push_back(time); }
  void on_presented(const hal::sim::PresentedFrame&) override { ++presented; }
};

TEST(SimPanel, ScansEveryLineInItsTime) {
  VirtualClock clock;
  Panel panel(paletted(8, 240, 8), clock);
  Witness witness;
  panel.attach(witness);
  clock.advance(2U * panel.frame_time());
  // The line of the third refresh that is due at this very moment, too.
  ASSERT_EQ(witness.lines.size(), 481U);
  for (std::size_t i = 0; i < witness.lines.size(); ++i) {
    const auto& line = witness.lines[i];
    ASSERT_EQ(line.refresh, i / 240U);
    ASSERT_EQ(line.y, static_cast<int>(i % 240U));
    ASSERT_EQ(line.time, line.refresh * panel.frame_time() + i % 240U * panel.line_time());
  }
  ASSERT_EQ(witness.vblanks.size(), 2U);
  EXPECT_EQ(witness.vblanks[0], 240U * panel.line_time());
  EXPECT_EQ(witness.vblanks[1], panel.frame_time() + 240U * panel.line_time());
  panel.detach(witness);
}

TEST(SimPanel, RefreshRateIsMetWithinOnePartInTenThousand) {
  VirtualClock clock;
  for (const std::uint32_t millihertz : {1'000U, 24'000U, 50'000U, 59'940U, 60'000U, 144'000U}) {
    for (const int height : {16, 240, 480}) {
      PanelSpec spec = paletted(8, height, 8);
      spec.capabilities.refresh_millihertz = millihertz;
      const Panel panel(spec, clock);
      const double wanted = 1e12 / millihertz;
      EXPECT_NEAR(static_cast<double>(panel.frame_time()), wanted, wanted * 1e-4);
    }
  }
}

TEST(SimPanel, WhetherAnyoneLooksChangesNothing) {
  VirtualClock clock;
  Panel watched(paletted(8, 30, 8), clock);
  Panel alone(paletted(8, 30, 8), clock);
  Witness witness;
  watched.attach(witness);
  const std::array<std::uint8_t, 3> colour{1, 2, 3};
  for (int i = 0; i < 100; ++i) {
    if (i % 3 == 0) {
      EXPECT_TRUE(watched.show(i % 2, colour).ok());
      EXPECT_TRUE(alone.show(i % 2, colour).ok());
    }
    clock.advance(static_cast<Nanoseconds>(i) * 700'001U);
    ASSERT_EQ(watched.vblank_count(), alone.vblank_count());
    ASSERT_EQ(watched.show_pending(), alone.show_pending());
    ASSERT_EQ(watched.displayed(), alone.displayed());
  }
  watched.detach(witness);
}

TEST(SimPanel, AnObserverThatComesLaterSeesTheLinesStillToCome) {
  VirtualClock clock;
  Panel panel(paletted(8, 30, 8), clock);
  clock.advance(panel.frame_time() + 10U * panel.line_time() + 1U);
  Witness witness;
  panel.attach(witness);
  EXPECT_EQ(witness.presented, 1);
  clock.advance(panel.line_time());
  ASSERT_EQ(witness.lines.size(), 1U);
  EXPECT_EQ(witness.lines[0].refresh, 1U);
  EXPECT_EQ(witness.lines[0].y, 11);
  panel.detach(witness);
  clock.advance(panel.frame_time());
  EXPECT_EQ(witness.lines.size(), 1U);
}

TEST(SimPanel, LinesShowTheMemoryOfTheirMoment) {
  VirtualClock clock;
  Panel panel(paletted(4, 10, 8), clock);
  Witness witness;
  panel.attach(witness);
  const auto memory = panel.buffer(0);
  std::ranges::fill(memory, std::uint8_t{1});
  clock.wait_until(4U * panel.line_time());
  std::ranges::fill(memory, std::uint8_t{2});
  clock.wait_until(10U * panel.line_time());
  ASSERT_EQ(witness.lines.size(), 10U);
  for (const auto& line : witness.lines) EXPECT_EQ(line.first_pixel, line.y <= 4 ? 1 : 2);
  panel.detach(witness);
}

TEST(SimPanel, BufferAndPaletteOfARequestMeetTheSameRefresh) {
  VirtualClock clock;
  Panel panel(paletted(4, 10, 8), clock);
  Witness witness;
  panel.attach(witness);
  std::ranges::fill(panel.buffer(1), std::uint8_t{9});
  const std::array<std::uint8_t, 3> colour{7, 7, 7};
  clock.advance(3U * panel.line_time());
  ASSERT_TRUE(panel.show(1, colour).ok());
  clock.advance(2U * panel.frame_time());
  for (const auto& line : witness.lines) {
    EXPECT_EQ(line.first_pixel, line.refresh == 0 ? 0 : 9);
    EXPECT_EQ(line.first_colour, line.refresh == 0 ? 0 : 7);
  }
  panel.detach(witness);
}

TEST(SimPanel, ALaterRequestReplacesOneThatWaits) {
  VirtualClock clock;
  Panel panel(paletted(4, 10, 8), clock);
  panel.buffer(0)[0] = 5;
  panel.buffer(1)[0] = 6;
  ASSERT_TRUE(panel.show(1, {}).ok());
  ASSERT_TRUE(panel.show(0, {}).ok());
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(panel.displayed().indices[0], 5);
}

TEST(SimPanel, WaitingEndsWithTheVblankAndEachWaitWithAnother) {
  VirtualClock clock;
  Panel panel(paletted(4, 10, 8), clock);
  for (std::uint32_t n = 1; n < 5; ++n) {
    ASSERT_TRUE(panel.wait_for_vblank().ok());
    EXPECT_EQ(panel.vblank_count(), n);
    const hal::Nanoseconds now = static_cast<hal::Clock&>(clock).now();
    EXPECT_EQ(now, (n - 1U) * panel.frame_time() + 10U * panel.line_time());
  }
}

TEST(SimPanel, ColoursKeepTheBitsTheDeviceKeeps) {
  VirtualClock clock;
  Panel panel(*find_panel("clcd"), clock);
  panel.buffer(0)[0] = 1;
  const std::array<std::uint8_t, 6> palette{0, 0, 0, 255, 7, 0x8F};
  ASSERT_TRUE(panel.load_palette(palette).ok());
  const hal::sim::Picture picture = panel.displayed();
  EXPECT_EQ(picture.rgb[0], 248) << "31 of 31 is read as 248, as QEMU's PL110 shows it";
  EXPECT_EQ(picture.rgb[1], 0);
  EXPECT_EQ(picture.rgb[2], 0x88);
}

TEST(SimPanel, FixedColoursAreShownInFull) {
  VirtualClock clock;
  Panel panel(*find_panel("oled"), clock);
  const std::array<std::uint8_t, 1> two_pixels{0x3F};
  ASSERT_TRUE(panel.write({2, 5, 2, 1}, two_pixels, 1).ok());
  const hal::sim::Picture picture = panel.displayed();
  const std::size_t place = 5 * 128 + 2;
  EXPECT_EQ(picture.indices[place], 3) << "the high nibble is left";
  EXPECT_EQ(picture.indices[place + 1], 15);
  EXPECT_EQ(picture.rgb[3 * place], 0x33);
  EXPECT_EQ(picture.rgb[3 * (place + 1)], 255);
  EXPECT_EQ(panel.capabilities().fixed_palette.size(), 48U);
}

TEST(SimPanel, BitOrderSaysWhichEndIsLeft) {
  for (const BitOrder order : {BitOrder::msb_first, BitOrder::lsb_first}) {
    VirtualClock clock;
    Panel panel(paletted(16, 1, 1, 1, order), clock);
    panel.buffer(0)[1] = 0x80;
    const hal::sim::Picture picture = panel.displayed();
    EXPECT_EQ(std::ranges::count(picture.indices, 1), 1);
    EXPECT_EQ(picture.indices[order == BitOrder::msb_first ? 8 : 15], 1);
  }
}

TEST(Catalog, NamesAreUniqueAndEveryPanelWorks) {
  std::set<std::string> names;
  for (const PanelSpec& spec : catalog()) {
    SCOPED_TRACE(spec.name);
    EXPECT_TRUE(names.insert(spec.name).second);
    EXPECT_FALSE(spec.description.empty());
    VirtualClock clock;
    Panel panel(spec, clock);
    const hal::Capabilities& c = panel.capabilities();
    EXPECT_EQ(c.palette_entries == 0, !c.fixed_palette.empty());
    EXPECT_EQ(c.palette_entries == 0 ? static_cast<int>(c.fixed_palette.size() / 3U) : c.palette_entries,
              1 << c.bits_per_pixel);
    EXPECT_GT(spec.total_lines, c.height);
    EXPECT_EQ(panel.displayed().indices.size(), static_cast<std::size_t>(c.width * c.height));
  }
  for (const char* const name : {"clcd", "oled", "ssd1306", "ssd0303", "vga"})
    EXPECT_TRUE(find_panel(name)) << name;
}

TEST(Catalog, FormatsAreReadExactly) {
  const auto panel = find_panel("320x200x4");
  ASSERT_TRUE(panel);
  EXPECT_EQ(panel->capabilities.width, 320);
  EXPECT_EQ(panel->capabilities.height, 200);
  EXPECT_EQ(panel->capabilities.bits_per_pixel, 4);
  EXPECT_EQ(panel->capabilities.palette_entries, 16);
  EXPECT_EQ(panel->capabilities.buffers, 2);
  for (const char* const bad :
       {"", "x", "320", "320x200", "320x200x3", "320x200x16", "0x200x8", "320x0x8", "-1x5x8", "320x200x8x",
        "320x200x8 ", " 320x200x8", "320X200X8", "99999x5x8", "999999999999x5x8", "CLCD", "clcd "})
    EXPECT_FALSE(find_panel(bad)) << '"' << bad << '"';
}

}  // namespace
