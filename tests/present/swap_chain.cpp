// SPDX-License-Identifier: MIT
#include <hal/sim/panel.hpp>
#include <hal/sim/tearing.hpp>
#include <intaglio/present/swap_chain.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <utility>

namespace {

using hal::sim::Latch;
using hal::sim::paletted;
using hal::sim::PanelSpec;
using hal::sim::Tear;
using hal::sim::TearingDetector;
using hal::sim::VirtualClock;
using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::image::Indexed1;
using intaglio::image::Indexed4;
using intaglio::image::Indexed4Lsb;
using intaglio::image::Indexed8;
using intaglio::image::Surface;
using intaglio::present::SwapChain;

template <class F>
Status status_on(const PanelSpec& spec, int interval = 1) {
  VirtualClock clock;
  hal::sim::Panel panel(spec, clock);
  return SwapChain<F>(panel, interval).status();
}

TEST(SwapChain, PanelOfAnotherFormatIsMismatched) {
  const Status mismatched(Error::mismatched, Argument::panel);
  EXPECT_EQ(status_on<Indexed4>(paletted(16, 8, 8)), mismatched);
  EXPECT_EQ(status_on<Indexed8>(paletted(16, 8, 1)), mismatched);
  EXPECT_EQ(status_on<Indexed4>(paletted(16, 8, 4, 2, hal::BitOrder::lsb_first)), mismatched);
  EXPECT_EQ(status_on<Indexed4Lsb>(paletted(16, 8, 4, 2, hal::BitOrder::msb_first)), mismatched);
  EXPECT_TRUE(status_on<Indexed4Lsb>(paletted(16, 8, 4, 2, hal::BitOrder::lsb_first)).ok());
  EXPECT_TRUE(status_on<Indexed8>(paletted(16, 8, 8, 2, hal::BitOrder::lsb_first)).ok())
      << "no order in 8 bits";
}

TEST(SwapChain, WritePanelIsUnsupported) {
  EXPECT_EQ(status_on<Indexed4>(*hal::sim::find_panel("oled")), Status(Error::unsupported, Argument::panel));
}

TEST(SwapChain, IntervalBelowOneIsOutOfRange) {
  EXPECT_EQ(status_on<Indexed8>(paletted(16, 8, 8), 0), Status(Error::out_of_range, Argument::count));
}

TEST(SwapChain, BadChainLendsNoFrame) {
  VirtualClock clock;
  hal::sim::Panel panel(paletted(16, 8, 8), clock);
  SwapChain<Indexed4> chain(panel);
  EXPECT_EQ(chain.begin().status(), Status(Error::mismatched, Argument::panel));
}

/// Fills rows with a value that differs from frame to frame and from row to row, letting time pass between.
void draw_rows(const Surface<Indexed8>& surface, std::uint32_t frame, VirtualClock& clock,
               hal::Nanoseconds row_time) {
  for (int y = 0; y < surface.bounds().height; ++y) {
    for (int x = 0; x < surface.bounds().width; ++x)
      surface.set(x, y, (frame * 7U + static_cast<unsigned>(y)) & 255U);
    if (row_time > 0) clock.advance(row_time);
  }
}

std::array<std::uint8_t, 6> palette_of(std::uint32_t frame) {
  return {static_cast<std::uint8_t>(frame), static_cast<std::uint8_t>(frame >> 8U), 0, 1, 2, 3};
}

/// Presents frames whose drawing takes up to three refreshes each, pauses included.
void present_random_frames(hal::sim::Panel& panel, VirtualClock& clock, std::uint32_t frames, unsigned seed) {
  SwapChain<Indexed8> chain(panel);
  std::mt19937 random(seed);
  const auto height = static_cast<hal::Nanoseconds>(panel.capabilities().height);
  for (std::uint32_t n = 1; n <= frames; ++n) {
    auto begun = chain.begin();
    ASSERT_TRUE(begun.ok());
    const hal::Nanoseconds draw_time = random() % (3U * panel.frame_time());
    draw_rows(begun.value().surface(), n, clock, draw_time / height);
    ASSERT_TRUE(chain.present(std::move(begun).value(), palette_of(n)).ok());
    if (random() % 2U == 0) clock.advance(random() % panel.frame_time());
  }
  ASSERT_TRUE(chain.wait_until_shown().ok());
  clock.advance(panel.frame_time());
}

TEST(Tearing, TenThousandDoubleBufferedFramesOfRandomDrawTimesAreWhole) {
  constexpr unsigned seed = 20'001;
  SCOPED_TRACE(seed);
  VirtualClock clock;
  hal::sim::Panel panel(paletted(24, 32, 8), clock);
  TearingDetector detector(panel);
  present_random_frames(panel, clock, 10'000, seed);
  EXPECT_EQ(detector.torn_refreshes(), 0U) << to_text(detector.tears().front());
  EXPECT_GE(detector.refreshes(), 10'000U);
}

TEST(Tearing, ThreeBuffersAreWholeToo) {
  VirtualClock clock;
  hal::sim::Panel panel(paletted(24, 32, 8, 3), clock);
  TearingDetector detector(panel);
  present_random_frames(panel, clock, 1'000, 20'002);
  EXPECT_EQ(detector.torn_refreshes(), 0U);
}

TEST(Tearing, SwapBeforeVblankIsCaughtWithItsLineAndFrames) {
  VirtualClock clock;
  PanelSpec spec = paletted(24, 32, 8);
  spec.latch = Latch::at_once;
  hal::sim::Panel panel(spec, clock);
  TearingDetector detector(panel);
  SwapChain<Indexed8> chain(panel);
  // The first two frames are swapped in VBLANK, which is harmless; the third while the beam is in line 10.
  for (std::uint32_t n = 1; n <= 3; ++n) {
    auto begun = chain.begin();
    ASSERT_TRUE(begun.ok());
    draw_rows(begun.value().surface(), n, clock, 0);
    ASSERT_TRUE(panel.wait_for_vblank().ok());
    const hal::Nanoseconds blanking = panel.frame_time() - 32U * panel.line_time();
    if (n == 3) clock.advance(blanking + 10U * panel.line_time() + 1U);
    ASSERT_TRUE(chain.present(std::move(begun).value()).ok());
  }
  clock.advance(2U * panel.frame_time());
  ASSERT_EQ(detector.tears().size(), 1U);
  EXPECT_EQ(detector.tears()[0], (Tear{3, 11, 2, 3, Tear::Kind::frames}));
  EXPECT_EQ(to_text(detector.tears()[0]), "refresh 3, line 11: frame 2 above, frame 3 below");
}

TEST(Tearing, EarlySwapsOfRandomFramesAreMostlyCaught) {
  VirtualClock clock;
  PanelSpec spec = paletted(24, 32, 8);
  spec.latch = Latch::at_once;
  hal::sim::Panel panel(spec, clock);
  TearingDetector detector(panel);
  present_random_frames(panel, clock, 1'000, 20'003);
  // 32 of 36 lines are visible, so most swaps fall into a picture, some two into the same.
  EXPECT_GT(detector.torn_refreshes(), 700U);
}

TEST(Tearing, DrawingOnTheOnlyBufferWhileItIsScannedIsCaught) {
  VirtualClock clock;
  hal::sim::Panel panel(paletted(24, 32, 8, 1), clock);
  TearingDetector detector(panel);
  SwapChain<Indexed8> chain(panel);
  auto begun = chain.begin();
  ASSERT_TRUE(begun.ok());
  // Half as fast as the beam: begun in VBLANK, overtaken soon.
  draw_rows(begun.value().surface(), 1, clock, 2U * panel.line_time());
  ASSERT_TRUE(chain.present(std::move(begun).value()).ok());
  clock.advance(3U * panel.frame_time());
  ASSERT_FALSE(detector.tears().empty());
  EXPECT_EQ(detector.tears()[0].above, 1U);
  EXPECT_EQ(detector.tears()[0].below, 0U);
}

TEST(Tearing, OneBufferDrawnAheadOfTheBeamIsWhole) {
  VirtualClock clock;
  hal::sim::Panel panel(paletted(24, 32, 8, 1), clock);
  TearingDetector detector(panel);
  SwapChain<Indexed8> chain(panel);
  for (std::uint32_t n = 1; n < 50; ++n) {
    auto begun = chain.begin();
    ASSERT_TRUE(begun.ok());
    draw_rows(begun.value().surface(), n, clock, panel.line_time() / 2U);
    ASSERT_TRUE(chain.present(std::move(begun).value()).ok());
  }
  clock.advance(2U * panel.frame_time());
  EXPECT_EQ(detector.torn_refreshes(), 0U);
  EXPECT_GE(detector.refreshes(), 50U);
}

TEST(Tearing, DrawingOnAFrameAlreadyPresentedIsCaught) {
  VirtualClock clock;
  hal::sim::Panel panel(paletted(24, 32, 8), clock);
  TearingDetector detector(panel);
  SwapChain<Indexed8> chain(panel);
  auto begun = chain.begin();
  const Surface<Indexed8> kept = begun.value().surface();
  draw_rows(kept, 1, clock, 0);
  ASSERT_TRUE(chain.present(std::move(begun).value()).ok());
  kept.set(3, 20, 255);
  clock.advance(2U * panel.frame_time());
  ASSERT_GE(detector.tears().size(), 2U);
  EXPECT_EQ(detector.tears()[0], (Tear{1, 20, 1, std::nullopt, Tear::Kind::drawing}));
  EXPECT_EQ(detector.tears()[1], (Tear{1, 21, std::nullopt, 1, Tear::Kind::drawing}));
}

TEST(Tearing, PaletteLoadedInMidPictureIsCaught) {
  VirtualClock clock;
  hal::sim::Panel panel(paletted(24, 32, 8), clock);
  TearingDetector detector(panel);
  clock.advance(5U * panel.line_time());  // Lines 0 to 5 have been scanned.
  ASSERT_TRUE(panel.load_palette(palette_of(77)).ok());
  clock.advance(2U * panel.frame_time());
  ASSERT_EQ(detector.tears().size(), 1U);
  EXPECT_EQ(detector.tears()[0], (Tear{0, 6, 0, 0, Tear::Kind::palette}));
}

TEST(Tearing, PaletteLoadedInVblankIsWhole) {
  VirtualClock clock;
  hal::sim::Panel panel(paletted(24, 32, 8), clock);
  TearingDetector detector(panel);
  for (std::uint32_t n = 0; n < 10; ++n) {
    ASSERT_TRUE(panel.wait_for_vblank().ok());
    ASSERT_TRUE(panel.load_palette(palette_of(n)).ok());
  }
  clock.advance(panel.frame_time());
  EXPECT_EQ(detector.torn_refreshes(), 0U);
}

TEST(SwapChain, BufferAndPaletteChangeTogetherAndOnlyAtVblank) {
  VirtualClock clock;
  hal::sim::Panel panel(paletted(4, 32, 8), clock);
  SwapChain<Indexed8> chain(panel);
  const hal::sim::Picture before = panel.displayed();
  auto begun = chain.begin();
  draw_rows(begun.value().surface(), 0, clock, 0);
  const std::array<std::uint8_t, 6> colours{10, 20, 30, 40, 50, 60};
  ASSERT_TRUE(chain.present(std::move(begun).value(), colours).ok());
  // Up to the last nanosecond before VBLANK everything is old, from then on everything new.
  clock.wait_until(32U * panel.line_time() - 1U);
  EXPECT_EQ(panel.displayed(), before);
  EXPECT_TRUE(panel.show_pending());
  clock.advance(1);
  EXPECT_FALSE(panel.show_pending());
  const hal::sim::Picture after = panel.displayed();
  EXPECT_EQ(after.indices[0], 0);
  EXPECT_EQ(after.indices[4], 1);
  EXPECT_EQ(after.rgb[0], 10);
  EXPECT_EQ(after.rgb[3 * 4 + 2], 60);
}

TEST(SwapChain, EmptyPaletteKeepsTheColours) {
  VirtualClock clock;
  hal::sim::Panel panel(paletted(4, 4, 8), clock);
  SwapChain<Indexed8> chain(panel);
  for (const bool with_palette : {true, false}) {
    auto begun = chain.begin();
    const std::array<std::uint8_t, 3> colour{9, 8, 7};
    const std::span<const std::uint8_t> palette =
        with_palette ? std::span<const std::uint8_t>(colour) : std::span<const std::uint8_t>{};
    ASSERT_TRUE(chain.present(std::move(begun).value(), palette).ok());
    ASSERT_TRUE(chain.wait_until_shown().ok());
    EXPECT_EQ(panel.displayed().rgb[1], 8);
  }
}

TEST(SwapChain, TryBeginSaysBusyUntilTheSwapHasHappened) {
  VirtualClock clock;
  hal::sim::Panel panel(paletted(4, 4, 8), clock);
  SwapChain<Indexed8> chain(panel);
  auto begun = chain.try_begin();
  ASSERT_TRUE(begun.ok());
  ASSERT_TRUE(chain.present(std::move(begun).value()).ok());
  EXPECT_EQ(chain.try_begin().status(), Status(Error::busy, Argument::frame));
  clock.advance(panel.frame_time());
  EXPECT_TRUE(chain.try_begin().ok());
}

/// Frames that take `vblanks[n]` VBLANK periods each; the deadlines missed.
std::uint32_t missed_with(int interval, std::span<const std::uint32_t> vblanks, int buffers = 2) {
  VirtualClock clock;
  hal::sim::Panel panel(paletted(4, 16, 8, buffers), clock);
  SwapChain<Indexed8> chain(panel, interval);
  std::uint32_t last = 0;
  bool first = true;
  for (const std::uint32_t count : vblanks) {
    auto begun = chain.begin();
    EXPECT_TRUE(begun.ok());
    // Drawing begins at a VBLANK and takes a little less than `count` periods.
    clock.advance(count * panel.frame_time() - panel.line_time());
    EXPECT_TRUE(chain.present(std::move(begun).value()).ok());
    EXPECT_TRUE(chain.wait_until_shown().ok());
    const std::uint32_t now = panel.vblank_count();
    const std::uint32_t expected = std::max(count, static_cast<std::uint32_t>(interval));
    if (!first) {
      EXPECT_EQ(now - last, expected);
    }
    first = false;
    last = now;
  }
  return chain.missed_deadlines();
}

TEST(SwapChain, MissedDeadlinesAreCountedExactly) {
  const std::array<std::uint32_t, 8> vblanks{3, 1, 1, 2, 1, 4, 1, 2};
  EXPECT_EQ(missed_with(1, vblanks), 3U) << "the first frame has no deadline";
  EXPECT_EQ(missed_with(2, vblanks), 1U);
  EXPECT_EQ(missed_with(4, vblanks), 0U);
  EXPECT_EQ(missed_with(1, vblanks, 1), 3U);
  EXPECT_EQ(missed_with(1, vblanks, 3), 3U);
}

TEST(SwapChain, AFastProgramMissesNothingAndShowsEveryFrameForAnInterval) {
  for (const int buffers : {1, 2, 3}) {
    for (const int interval : {1, 2, 5}) {
      VirtualClock clock;
      hal::sim::Panel panel(paletted(4, 16, 8, buffers), clock);
      SwapChain<Indexed8> chain(panel, interval);
      for (int n = 0; n < 100; ++n) {
        auto begun = chain.begin();
        ASSERT_TRUE(begun.ok());
        ASSERT_TRUE(chain.present(std::move(begun).value()).ok());
      }
      ASSERT_TRUE(chain.wait_until_shown().ok());
      // Drawing on an only buffer begins at a VBLANK.
      const unsigned first = buffers == 1 ? 2 : 1;
      EXPECT_EQ(panel.vblank_count(), first + 99U * static_cast<unsigned>(interval)) << buffers << " buffers";
      EXPECT_EQ(chain.missed_deadlines(), 0U);
    }
  }
}

TEST(SwapChain, PaddedRowsAreUsedAsTheyAre) {
  VirtualClock clock;
  PanelSpec spec = paletted(13, 5, 1);
  spec.row_padding = 3;
  hal::sim::Panel panel(spec, clock);
  SwapChain<Indexed1> chain(panel);
  auto begun = chain.begin();
  ASSERT_TRUE(begun.ok());
  for (int y = 0; y < 5; ++y) begun.value().surface().set(12 - y, y, 1);
  ASSERT_TRUE(chain.present(std::move(begun).value()).ok());
  ASSERT_TRUE(chain.wait_until_shown().ok());
  const hal::sim::Picture picture = panel.displayed();
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 13; ++x)
      EXPECT_EQ(picture.indices[static_cast<std::size_t>(y * 13 + x)], x == 12 - y ? 1 : 0) << x << ' ' << y;
}

}  // namespace
