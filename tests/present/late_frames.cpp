// SPDX-License-Identifier: MIT
//
// Frames that come too late or too soon: what is shown, what is dropped, and that all of it is counted.
#include <hal/mock/strict_panel.hpp>
#include <hal/sim/panel.hpp>
#include <hal/sim/tearing.hpp>
#include <intaglio/present/bands.hpp>
#include <intaglio/present/frame_writer.hpp>
#include <tests/present/scan_out.hpp>

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <utility>
#include <vector>

namespace {

using hal::sim::paletted;
using hal::sim::PanelSpec;
using hal::sim::VirtualClock;
using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::image::Indexed8;
using intaglio::image::Surface;
using intaglio::present::BandWriter;
using intaglio::present::FrameCounts;
using intaglio::present::FrameWriter;
using intaglio::present::Late;
using intaglio::present::Order;
using intaglio::present::Pace;
using intaglio::present::Pacer;
using intaglio::present::SwapChain;

using Palette = std::array<std::uint8_t, 3>;

/// The frame on display, and how red index 0 is.
std::pair<int, int> seen(const hal::sim::Panel& panel) {
  const hal::sim::Picture picture = panel.displayed();
  return {picture.indices[0], picture.rgb[3]};
}

/// A chain whose frames show their number on the left and index 0 on the right.
class Chain : public scan_out::Stage<> {
 public:
  explicit Chain(const Pace& pace, int buffers = 2) : Stage(paletted(2, 8, 8, buffers), pace) {}

  /// Draws frame `n` for a time and presents it.
  void frame(int n, hal::Nanoseconds draw_time, std::span<const std::uint8_t> palette = {}) {
    auto begun = chain.begin();
    ASSERT_TRUE(begun.ok());
    for (int y = 0; y < 8; ++y) {
      begun.value().surface().set(0, y, static_cast<unsigned>(n) & 255U);
      begun.value().surface().set(1, y, 0);
    }
    clock.advance(draw_time);
    ASSERT_TRUE(chain.present(std::move(begun).value(), palette).ok());
  }
  hal::Nanoseconds refresh() const { return panel.frame_time(); }
};

TEST(LateFrames, AreShownAndTheRhythmBeginsAnew) {
  Chain c(Pace(2));
  c.frame(1, 0);                 // appears at VBLANK 1
  c.frame(2, 0);                 // 3
  c.frame(3, 3U * c.refresh());  // begun at 3, ready after 6, due at 5: appears at 7
  c.frame(4, 0);                 // 9
  ASSERT_TRUE(c.chain.wait_until_shown().ok());
  EXPECT_EQ(c.panel.vblank_count(), 9U);
  EXPECT_EQ(c.chain.counts(), (FrameCounts{4, 1, 0, 2}));
}

TEST(LateFrames, AreDroppedAndTheRhythmGoesOn) {
  Chain c(Pace(2, Late::drop));
  c.frame(1, 0);                 // appears at VBLANK 1
  c.frame(2, 0);                 // 3
  c.frame(3, 3U * c.refresh());  // ready after 6, due at 5: dropped
  EXPECT_EQ(c.panel.vblank_count(), 6U) << "nothing waits for a dropped frame";
  c.frame(4, 0);  // 7, as if nothing had been
  ASSERT_TRUE(c.chain.wait_until_shown().ok());
  EXPECT_EQ(c.panel.vblank_count(), 7U);
  EXPECT_EQ(seen(c.panel).first, 4);
  EXPECT_EQ(c.chain.counts(), (FrameCounts{3, 0, 1, 2}));
  EXPECT_EQ(c.chain.missed_deadlines(), 1U);
}

TEST(LateFrames, NoTwoInSuccessionAreDropped) {
  Chain c(Pace(1, Late::drop));
  for (int n = 0; n < 21; ++n) c.frame(n, 3U * c.refresh());
  // The first has no deadline, then every other is dropped.
  EXPECT_EQ(c.chain.counts().dropped, 10U);
  EXPECT_EQ(c.chain.counts().shown, 11U);
  EXPECT_EQ(c.chain.counts().late, 10U);
  EXPECT_EQ(c.chain.missed_deadlines(), 20U);
}

TEST(LateFrames, ColoursOfADroppedFrameComeWithTheNext) {
  Chain c(Pace(1, Late::drop));
  const Palette red{255, 0, 0};
  c.frame(1, 0, Palette{1, 1, 1});
  c.frame(2, 2U * c.refresh(), red);
  EXPECT_EQ(c.chain.counts().dropped, 1U);
  ASSERT_TRUE(c.panel.wait_for_vblank().ok());
  EXPECT_EQ(seen(c.panel), std::pair(1, 1)) << "frame 1 keeps its own";
  c.frame(3, 0);
  ASSERT_TRUE(c.chain.wait_until_shown().ok());
  EXPECT_EQ(seen(c.panel), std::pair(3, 255));
}

TEST(LateFrames, ColoursOfAFrameThatTheDeviceLostComeWithTheNext) {
  hal::mock::StrictPanel panel(hal::mock::scan_out_panel(2, 1, 8));
  SwapChain<Indexed8> chain(panel);
  panel.fail_next({hal::Error::bus, hal::Part::bus});
  const std::array<std::uint8_t, 6> two{7, 7, 7, 8, 8, 8};
  EXPECT_EQ(chain.present(chain.begin().value(), two), Status(Error::device, Argument::panel));
  ASSERT_TRUE(chain.present(chain.begin().value(), Palette{9, 9, 9}).ok());
  ASSERT_TRUE(chain.wait_until_shown().ok());
  EXPECT_EQ(panel.palette()[0], 9);
  EXPECT_EQ(panel.palette()[3], 8);
  EXPECT_EQ(chain.counts(), (FrameCounts{1, 0, 1, 0}));
}

TEST(LatestFrame, ReplacesTheOneThatWaits) {
  Chain c(Pace(1, Late::show, Order::latest), 3);
  const Palette blue{0, 0, 255};
  c.frame(1, 0, Palette{10, 0, 0});
  c.frame(2, 0, blue);
  c.frame(3, 0);
  EXPECT_EQ(c.panel.vblank_count(), 0U) << "nothing waits";
  ASSERT_TRUE(c.chain.wait_until_shown().ok());
  EXPECT_EQ(seen(c.panel), std::pair(3, 0)) << "with the colours of frame 2";
  EXPECT_EQ(c.panel.displayed().rgb[5], 255);
  EXPECT_EQ(c.chain.counts(), (FrameCounts{1, 0, 2, 0}));
}

TEST(LatestFrame, OfAFastProgramIsNewAtEveryVblankAndNeverTorn) {
  Chain c(Pace(1, Late::show, Order::latest), 3);
  hal::sim::TearingDetector detector(c.panel);
  std::mt19937 random(40'001);
  std::uint32_t frames = 0;
  for (; frames < 2'000; ++frames)
    c.frame(static_cast<int>(frames), 2U * c.refresh() / 5U + random() % (c.refresh() / 2U));
  ASSERT_TRUE(c.chain.wait_until_shown().ok());
  c.clock.advance(2U * c.refresh());
  EXPECT_EQ(detector.torn_refreshes(), 0U);
  const FrameCounts& n = c.chain.counts();
  EXPECT_EQ(n.shown + n.dropped, frames);
  EXPECT_EQ(n.repeated, 0U);
  EXPECT_EQ(n.shown, c.panel.vblank_count() - 2U) << "but for the two refreshes at the end";
}

TEST(LatestFrame, WithTwoBuffersWaitsLikeEveryFrame) {
  Chain c(Pace(1, Late::show, Order::latest), 2);
  for (int n = 0; n < 5; ++n) c.frame(n, 0);
  EXPECT_EQ(c.panel.vblank_count(), 4U);
  EXPECT_EQ(c.chain.counts(), (FrameCounts{5, 0, 0, 0}));
}

TEST(LatestFrame, HasNoInterval) {
  EXPECT_EQ(Chain(Pace(2, Late::show, Order::latest), 3).chain.status(),
            Status(Error::mismatched, Argument::count));
}

TEST(Counts, BalanceForRandomDrawTimesAndPaces) {
  constexpr unsigned seed = 40'002;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int round = 0; round < 60; ++round) {
    const int interval = 1 + static_cast<int>(random() % 4U);
    const Late late = random() % 2U == 0 ? Late::show : Late::drop;
    const int buffers = 2 + static_cast<int>(random() % 2U);
    Chain c(Pace(interval, late), buffers);
    std::uint32_t first = 0;
    constexpr std::uint32_t frames = 60;
    for (std::uint32_t n = 0; n < frames; ++n) {
      const std::uint32_t shown = c.chain.counts().shown;
      c.frame(static_cast<int>(n), random() % (static_cast<unsigned>(interval) * 3U * c.refresh() / 2U));
      ASSERT_TRUE(c.chain.wait_until_shown().ok());
      if (n == 0) first = c.panel.vblank_count();
      const FrameCounts& k = c.chain.counts();
      ASSERT_EQ(k.shown + k.dropped, n + 1U);
      if (k.shown == shown) continue;
      ASSERT_EQ(seen(c.panel).first, static_cast<int>(n));
      ASSERT_EQ(c.panel.vblank_count() - first,
                static_cast<unsigned>(interval) * (k.shown - 1U) + k.repeated);
    }
  }
}

TEST(Pacing, EveryFractionOfTheRefreshUpToSixty) {
  for (int interval = 1; interval <= 60; ++interval) {
    Chain c{Pace(interval)};
    for (int n = 0; n < 5; ++n) {
      c.frame(n, 0);
      ASSERT_TRUE(c.chain.wait_until_shown().ok());
      ASSERT_EQ(c.panel.vblank_count(), 1U + static_cast<unsigned>(n * interval));
    }
  }
}

PanelSpec write_panel(bool palette_on_write) {
  PanelSpec spec = paletted(2, 2, 8, 0);
  spec.capabilities.palette_on_write = palette_on_write;
  return spec;
}

TEST(WritePanels, ALateFrameThatIsDroppedIsOwedToTheNext) {
  VirtualClock clock;
  hal::sim::Panel panel(write_panel(false), clock);
  std::array<std::uint8_t, 4> memory{1, 1, 1, 1};
  FrameWriter<Indexed8> writer(panel, memory, Pace(1, Late::drop));
  const std::array<intaglio::linear::Rect, 1> left{intaglio::linear::Rect{0, 0, 1, 1}};
  const std::array<intaglio::linear::Rect, 1> right{intaglio::linear::Rect{1, 1, 1, 1}};
  ASSERT_TRUE(writer.present(writer.begin().value()).ok());
  clock.advance(3U * panel.frame_time());
  memory[0] = 2;
  ASSERT_TRUE(writer.present(writer.begin().value(), {}, left).ok());
  EXPECT_EQ(panel.displayed().indices[0], 1) << "dropped";
  memory[3] = 3;
  ASSERT_TRUE(writer.present(writer.begin().value(), {}, right).ok());
  EXPECT_EQ(panel.displayed().indices, (std::vector<std::uint8_t>{2, 1, 1, 3}));
  EXPECT_EQ(writer.counts().dropped, 1U);
  EXPECT_EQ(writer.counts().shown, 2U);
}

TEST(WritePanels, AFrameWhoseColoursWouldShowAtOnceIsNotDropped) {
  VirtualClock clock;
  hal::sim::Panel panel(write_panel(false), clock);
  std::array<std::uint8_t, 4> memory{1, 1, 1, 1};
  FrameWriter<Indexed8> writer(panel, memory, Pace(1, Late::drop));
  ASSERT_TRUE(writer.present(writer.begin().value()).ok());
  clock.advance(3U * panel.frame_time());
  ASSERT_TRUE(writer.present(writer.begin().value(), Palette{9, 9, 9}).ok());
  EXPECT_EQ(writer.counts().late, 1U);
  EXPECT_EQ(writer.counts().dropped, 0U);
  BandWriter<Indexed8> bands(panel, std::span(memory).first(2), Pace(1, Late::drop));
  const auto draw = [](const Surface<Indexed8>&) { return Status{}; };
  ASSERT_TRUE(bands.present(draw).ok());
  clock.advance(3U * panel.frame_time());
  ASSERT_TRUE(bands.present(draw, Palette{8, 8, 8}).ok());
  EXPECT_EQ(bands.counts().late, 1U);
  EXPECT_EQ(bands.counts().dropped, 0U);
}

TEST(WritePanels, AFrameWhoseColoursTheDeviceRefusesIsLostOnce) {
  hal::mock::StrictPanel panel(hal::mock::write_panel(2, 2, 8));
  std::array<std::uint8_t, 4> memory{};
  FrameWriter<Indexed8> writer(panel, memory);
  ASSERT_TRUE(writer.present(writer.begin().value(), Palette{1, 1, 1}).ok());
  panel.fail_next({hal::Error::bus, hal::Part::bus});
  EXPECT_EQ(writer.present(writer.begin().value(), Palette{2, 2, 2}), Status(Error::device, Argument::panel));
  EXPECT_EQ(writer.counts(), (FrameCounts{1, 0, 1, 1}));
  hal::mock::StrictPanel other(hal::mock::write_panel(2, 2, 8));
  BandWriter<Indexed8> bands(other, memory);
  const auto draw = [](const Surface<Indexed8>&) { return Status{}; };
  ASSERT_TRUE(bands.present(draw, Palette{3, 3, 3}).ok());
  other.fail_next({hal::Error::bus, hal::Part::bus});
  EXPECT_EQ(bands.present(draw, Palette{4, 4, 4}), Status(Error::device, Argument::panel));
  EXPECT_EQ(bands.counts(), (FrameCounts{1, 0, 1, 1}));
}

/// A write panel that applies colours to pixels as they arrive: it keeps colours, not indices.
class ColouringPanel final : public hal::Panel {
 public:
  std::array<std::uint8_t, 4> red{};

 private:
  const hal::Capabilities& do_capabilities() const noexcept override { return capabilities_; }
  std::span<std::uint8_t> do_buffer(int) noexcept override { return {}; }
  int do_buffer_stride() const noexcept override { return 0; }
  hal::Status do_show(int, std::span<const std::uint8_t>) noexcept override { return {}; }
  bool do_show_pending() noexcept override { return false; }
  hal::Status do_write(const hal::Rect& r, std::span<const std::uint8_t> pixels,
                       int stride) noexcept override {
    for (int y = 0; y < r.height; ++y)
      for (int x = 0; x < r.width; ++x)
        red[static_cast<std::size_t>((r.y + y) * 2 + r.x + x)] =
            palette_[3U * pixels[static_cast<std::size_t>(y * stride + x)]];
    return {};
  }
  hal::Status do_load_palette(std::span<const std::uint8_t> palette) noexcept override {
    std::copy(palette.begin(), palette.end(), palette_.begin());
    return {};
  }
  std::uint32_t do_vblank_count() noexcept override { return vblank_; }
  hal::Status do_wait_for_vblank() noexcept override {
    ++vblank_;
    return {};
  }

  hal::Capabilities capabilities_{
      .width = 2, .height = 2, .palette_entries = 256, .palette_on_write = true, .buffers = 0};
  std::array<std::uint8_t, 768> palette_{};
  std::uint32_t vblank_ = 0;
};

TEST(WritePanels, NewColoursAreSeenEverywhereWhereTheyAreAppliedOnWriting) {
  ColouringPanel panel;
  std::array<std::uint8_t, 4> memory{};
  FrameWriter<Indexed8> writer(panel, memory);
  ASSERT_TRUE(writer.present(writer.begin().value(), Palette{10, 0, 0}).ok());
  const std::array<intaglio::linear::Rect, 1> corner{intaglio::linear::Rect{0, 0, 1, 1}};
  ASSERT_TRUE(writer.present(writer.begin().value(), Palette{20, 0, 0}, corner).ok());
  EXPECT_EQ(panel.red, (std::array<std::uint8_t, 4>{20, 20, 20, 20}));
  // Without colours only what changed is sent.
  panel.red[3] = 99;
  ASSERT_TRUE(writer.present(writer.begin().value(), {}, corner).ok());
  EXPECT_EQ(panel.red, (std::array<std::uint8_t, 4>{20, 20, 20, 99}));
  std::array<std::uint8_t, 2> row{};
  BandWriter<Indexed8> bands(panel, row);
  ASSERT_TRUE(bands.present([](const Surface<Indexed8>&) { return Status{}; }, Palette{30, 0, 0}).ok());
  EXPECT_EQ(panel.red, (std::array<std::uint8_t, 4>{30, 30, 30, 30}));
}

TEST(WritePanels, ColoursOfADroppedFrameAreThereForTheNext) {
  VirtualClock clock;
  hal::sim::Panel panel(write_panel(true), clock);
  std::array<std::uint8_t, 2> memory{};
  BandWriter<Indexed8> bands(panel, memory, Pace(1, Late::drop));
  int drawn = 0;
  const auto draw = [&drawn](const Surface<Indexed8>&) {
    ++drawn;
    return Status{};
  };
  ASSERT_TRUE(bands.present(draw).ok());
  clock.advance(3U * panel.frame_time());
  ASSERT_TRUE(bands.present(draw, Palette{50, 0, 0}).ok());
  EXPECT_EQ(bands.counts(), (FrameCounts{1, 0, 1, 1}));
  EXPECT_EQ(drawn, 2) << "a dropped frame isn't drawn";
  int watched = 0;
  const auto watch = [&watched](const intaglio::image::Picture<Indexed8>&) { ++watched; };
  ASSERT_TRUE(bands.present(draw, {}, watch).ok());
  EXPECT_EQ(panel.displayed().rgb[0], 50);
  EXPECT_EQ(watched, 2);
}

TEST(Pacer, CountsBeyondTheWrap) {
  Pacer pacer{Pace(2, Late::drop)};
  pacer.appeared(0xFFFF'FFFEU);
  EXPECT_EQ(pacer.not_before_due(0xFFFF'FFFFU), 0U);
  EXPECT_FALSE(pacer.drop(0));
  EXPECT_TRUE(pacer.drop(1));
  pacer.appeared(2);
  EXPECT_EQ(pacer.counts(), (FrameCounts{2, 0, 1, 2}));
  pacer.lost(6);
  EXPECT_EQ(pacer.counts(), (FrameCounts{2, 0, 2, 6}));
  EXPECT_EQ(pacer.not_before_due(7), 8U);
}

}  // namespace
