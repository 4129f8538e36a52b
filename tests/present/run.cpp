// SPDX-License-Identifier: MIT
#include <hal/sim/panel.hpp>
#include <hal/sim/tearing.hpp>
#include <intaglio/present/run.hpp>
#include <tests/present/scan_out.hpp>

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

namespace {

using hal::sim::PanelSpec;
using hal::sim::VirtualClock;
using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::image::Indexed8;
using intaglio::image::Surface;
using intaglio::present::BandWriter;
using intaglio::present::FrameWriter;
using intaglio::present::run;
using intaglio::present::ScreenInfo;
using intaglio::present::SwapChain;

/// Every pixel a function of place and frame; the palette changes with the frame.
class Waves {
 public:
  explicit Waves(const ScreenInfo& screen) : loads_palette_(screen.palette_entries > 0) {}
  void update(std::uint32_t frame) {
    frame_ = frame;
    palette_ = {static_cast<std::uint8_t>(frame), 1, 2, 3, 4, 5};
  }
  [[nodiscard]] std::span<const std::uint8_t> palette() const {
    return loads_palette_ ? std::span<const std::uint8_t>(palette_) : std::span<const std::uint8_t>{};
  }
  [[nodiscard]] Status draw(const Surface<Indexed8>& target) const {
    const auto b = target.bounds();
    for (int y = b.y; y < b.bottom(); ++y)
      for (int x = b.x; x < b.right(); ++x)
        target.set(x, y, (static_cast<unsigned>(x * y) + 3U * frame_) & 255U);
    return frame_ == fails_at ? Status(Error::malformed, Argument::source) : Status{};
  }
  std::uint32_t fails_at = 0xFFFF'FFFF;

 private:
  bool loads_palette_;
  std::uint32_t frame_ = 0;
  std::array<std::uint8_t, 6> palette_{};
};

/// The waves on a panel that scans out.
struct Show : scan_out::Stage<> {
  explicit Show(int bits = 8) : Stage(hal::sim::paletted(30, 21, bits)), app(chain.info()) {}
  Waves app;
};

using Digests = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

template <class Screen>
Digests digests_of(Screen& screen, std::uint32_t frames) {
  Digests digests;
  Waves app(screen.info());
  const Status s = run(app, screen, frames, [&digests](std::uint32_t n, std::uint32_t digest) {
    digests.emplace_back(n, digest);
  });
  EXPECT_TRUE(s.ok());
  return digests;
}

TEST(Run, AllKindsOfScreensShowTheSameFrames) {
  VirtualClock clock;
  hal::sim::Panel scan_out(hal::sim::paletted(30, 21, 8), clock);
  hal::sim::Panel written(hal::sim::paletted(30, 21, 8, 0), clock);
  hal::sim::Panel banded(hal::sim::paletted(30, 21, 8, 0), clock);
  std::vector<std::uint8_t> memory(30 * 21);
  std::vector<std::uint8_t> little(30 * 4);
  SwapChain<Indexed8> chain(scan_out);
  FrameWriter<Indexed8> writer(written, memory);
  BandWriter<Indexed8> bands(banded, little);
  const Digests digests = digests_of(chain, 10);
  ASSERT_EQ(digests.size(), 10U);
  EXPECT_EQ(digests[9].first, 9U);
  EXPECT_NE(digests[8].second, digests[9].second);
  EXPECT_EQ(digests_of(writer, 10), digests);
  EXPECT_EQ(digests_of(bands, 10), digests);
  EXPECT_EQ(written.displayed(), scan_out.displayed());
  EXPECT_EQ(banded.displayed(), scan_out.displayed());
}

TEST(Run, TheFrameIsOnDisplayWhenItIsTold) {
  Show show;
  hal::sim::TearingDetector detector(show.panel);
  const Status s = run(show.app, show.chain, 20, [&panel = show.panel](std::uint32_t n) {
    EXPECT_EQ(panel.displayed().indices[0], (3U * n) & 255U);
    EXPECT_EQ(panel.vblank_count(), n + 1U) << "a frame a VBLANK";
  });
  EXPECT_TRUE(s.ok());
  EXPECT_EQ(detector.torn_refreshes(), 0U);
  EXPECT_EQ(show.chain.missed_deadlines(), 0U);
}

TEST(Run, FixedColoursEnterTheDigest) {
  VirtualClock clock;
  PanelSpec spec = hal::sim::paletted(6, 4, 8, 0);
  spec.capabilities.palette_entries = 0;
  spec.fixed_colours.assign(768, 9);
  hal::sim::Panel panel(spec, clock);
  std::vector<std::uint8_t> memory(24);
  FrameWriter<Indexed8> writer(panel, memory);
  const Digests digests = digests_of(writer, 1);
  const intaglio::image::Picture<Indexed8> picture =
      intaglio::image::Picture<Indexed8>::over(memory, {6, 4}).value();
  intaglio::image::FrameDigest expected({6, 4}, spec.fixed_colours);
  expected.add(picture);
  EXPECT_EQ(digests[0].second, expected.value());
}

TEST(Run, EndsWithTheErrorOfTheProgramAndPresentsNothingOfIt) {
  Show show;
  show.app.fails_at = 3;
  std::uint32_t told = 0;
  EXPECT_EQ(run(show.app, show.chain, 10, [&told](std::uint32_t) { ++told; }),
            Status(Error::malformed, Argument::source));
  EXPECT_EQ(told, 3U);
  EXPECT_EQ(show.panel.displayed().indices[0], 6);
  EXPECT_TRUE(show.chain.begin().ok()) << "the frame went back";
}

TEST(Run, FalseEndsTheRun) {
  Show show;
  std::uint32_t told = 0;
  const auto until_four = [&told](std::uint32_t) { return ++told < 4; };
  EXPECT_TRUE(run(show.app, show.chain, 10, until_four).ok());
  EXPECT_EQ(told, 4U);
}

TEST(Run, BadScreenIsAnErrorAtOnce) {
  Show show(4);
  EXPECT_EQ(run(show.app, show.chain, 10), Status(Error::mismatched, Argument::panel));
}

}  // namespace
