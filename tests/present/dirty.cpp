// SPDX-License-Identifier: MIT
#include <hal/sim/panel.hpp>
#include <intaglio/present/frame_writer.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace {

using hal::sim::PanelSpec;
using hal::sim::VirtualClock;
using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::image::Indexed1;
using intaglio::image::Indexed2Lsb;
using intaglio::image::Indexed4;
using intaglio::image::Indexed8;
using intaglio::linear::Rect;
using intaglio::present::DirtyList;
using intaglio::present::FrameWriter;

PanelSpec write_panel(int width, int height, int bits, int x_alignment, int y_alignment,
                      hal::BitOrder order = hal::BitOrder::msb_first) {
  PanelSpec spec = hal::sim::paletted(width, height, bits, 0, order);
  spec.capabilities.x_alignment = x_alignment;
  spec.capabilities.y_alignment = y_alignment;
  return spec;
}

/// By the definition, pixel by pixel: the mask of the pixels of `r` inside width x height.
void mark(std::vector<int>& mask, const Rect& r, int width, int height) {
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (x >= r.x && x - r.x < r.width && y >= r.y && y - r.y < r.height)
        ++mask[static_cast<std::size_t>(y * width + x)];
}

TEST(DirtyList, CoversEveryRectangleWithoutOverlapInsideAndAligned) {
  constexpr unsigned seed = 30'001;
  std::mt19937 random(seed);
  const auto between = [&random](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  for (int round = 0; round < 3'000; ++round) {
    const int width = between(1, 60);
    const int height = between(1, 40);
    const int xa = between(1, 9);
    const int ya = between(1, 9);
    DirtyList list({width, height}, xa, ya);
    const auto pixels = static_cast<std::size_t>(width * height);
    std::vector<int> wanted(pixels);
    const int rects = between(1, 20);
    for (int i = 0; i < rects; ++i) {
      const Rect r{between(-10, width + 5), between(-10, height + 5), between(-2, 15), between(-2, 15)};
      ASSERT_TRUE(list.add(r).ok());
      mark(wanted, r, width, height);
    }
    std::vector<int> got(pixels);
    ASSERT_LE(list.rects().size(), 8U);
    for (const Rect& r : list.rects()) {
      ASSERT_TRUE(r.x >= 0 && r.y >= 0 && r.width > 0 && r.height > 0 && r.x + r.width <= width &&
                  r.y + r.height <= height);
      ASSERT_TRUE(r.x % xa == 0 && ((r.x + r.width) % xa == 0 || r.x + r.width == width));
      ASSERT_TRUE(r.y % ya == 0 && ((r.y + r.height) % ya == 0 || r.y + r.height == height));
      mark(got, r, width, height);
    }
    bool lost = false;
    bool twice = false;
    for (std::size_t i = 0; i < pixels; ++i) {
      lost = lost || (wanted[i] > 0 && got[i] == 0);
      twice = twice || got[i] > 1;
    }
    ASSERT_FALSE(lost) << "seed " << seed << " round " << round;
    ASSERT_FALSE(twice) << "seed " << seed << " round " << round;
  }
}

TEST(DirtyList, FarApartRectanglesStayApartAndNeighboursJoin) {
  DirtyList list({100, 100}, 1, 1);
  list.add({0, 0, 10, 10}).ignore();
  list.add({50, 50, 10, 10}).ignore();
  EXPECT_EQ(list.rects().size(), 2U);
  list.add({10, 0, 5, 10}).ignore();
  ASSERT_EQ(list.rects().size(), 2U);
  EXPECT_EQ(list.rects()[1], (Rect{0, 0, 15, 10}));
}

TEST(DirtyList, RectangleOutsideTheDomainIsAnErrorAndAddsNothing) {
  constexpr int most = std::numeric_limits<int>::max();
  constexpr int least = std::numeric_limits<int>::min();
  DirtyList list({100, 100}, 4, 4);
  const Status bad(Error::out_of_domain, Argument::rectangle);
  EXPECT_EQ(list.add({most, 0, 1, 1}), bad);
  EXPECT_EQ(list.add({0, least, 1, 1}), bad);
  EXPECT_EQ(list.add({0, 0, most, most}), bad);
  EXPECT_EQ(list.add({0, 0, least, 1}), bad);
  EXPECT_TRUE(list.rects().empty());
  EXPECT_TRUE(list.add({-1'000'000, -1'000'000, 2'000'000, 2'000'000}).ok());
  EXPECT_EQ(list.rects()[0], (Rect{0, 0, 100, 100}));
}

/// Draws random rectangles, presents just those, and compares panel and buffer.
template <class F>
void dirty_equals_full(const PanelSpec& spec, unsigned seed) {
  SCOPED_TRACE(spec.name);
  VirtualClock clock;
  hal::sim::Panel panel(spec, clock);
  const auto [width, height] = std::pair(spec.capabilities.width, spec.capabilities.height);
  std::vector<std::uint8_t> memory(static_cast<std::size_t>(FrameWriter<F>::memory_for({width, height})));
  FrameWriter<F> writer(panel, memory);
  ASSERT_TRUE(writer.status().ok());
  std::mt19937 random(seed);
  const auto below = [&random](int limit) {
    return static_cast<int>(random() % static_cast<unsigned>(limit));
  };
  for (int frame = 0; frame < 200; ++frame) {
    auto begun = writer.begin();
    ASSERT_TRUE(begun.ok());
    const auto surface = begun.value().surface();
    std::vector<Rect> dirty;
    for (int i = below(12); i > 0; --i) {
      const Rect r{below(width), below(height), 1 + below(12), 1 + below(12)};
      dirty.push_back(r);
      for (int y = r.y; y < std::min(r.y + r.height, height); ++y)
        for (int x = r.x; x < std::min(r.x + r.width, width); ++x) surface.set(x, y, random() & F::max_index);
    }
    ASSERT_TRUE(writer.present(std::move(begun).value(), {}, dirty).ok());
    const hal::sim::Picture shown = panel.displayed();
    bool equal = true;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        equal = equal && shown.indices[static_cast<std::size_t>(y * width + x)] == surface.get(x, y);
    ASSERT_TRUE(equal) << "seed " << seed << " frame " << frame;
  }
}

// A misaligned rectangle or one outside would be refused by the panel, and `present` would fail.
TEST(FrameWriter, DirtyRectanglesGiveTheSamePictureAsWholeFrames) {
  dirty_equals_full<Indexed8>(write_panel(61, 37, 8, 1, 1), 30'010);
  dirty_equals_full<Indexed8>(write_panel(64, 40, 8, 4, 2), 30'011);
  dirty_equals_full<Indexed4>(write_panel(128, 64, 4, 2, 1), 30'012);
  dirty_equals_full<Indexed4>(write_panel(33, 17, 4, 3, 5), 30'013);
  dirty_equals_full<Indexed1>(write_panel(128, 64, 1, 1, 8), 30'014);
  dirty_equals_full<Indexed1>(write_panel(95, 15, 1, 8, 8), 30'015);
  dirty_equals_full<Indexed2Lsb>(write_panel(45, 20, 2, 1, 1, hal::BitOrder::lsb_first), 30'016);
}

TEST(FrameWriter, FirstFrameIsSentWholeWhateverIsDirty) {
  VirtualClock clock;
  hal::sim::Panel panel(write_panel(8, 8, 8, 1, 1), clock);
  std::vector<std::uint8_t> memory(64, 5);
  FrameWriter<Indexed8> writer(panel, memory);
  ASSERT_TRUE(writer.present(writer.begin().value(), {}, std::span<const Rect>{}).ok());
  EXPECT_EQ(panel.displayed().indices, memory);
  // From then on only what is said to be dirty.
  memory.assign(64, 6);
  const Rect one{3, 2, 1, 1};
  ASSERT_TRUE(writer.present(writer.begin().value(), {}, std::span(&one, 1)).ok());
  EXPECT_EQ(std::ranges::count(panel.displayed().indices, 6), 1);
  EXPECT_EQ(panel.displayed().indices[2 * 8 + 3], 6);
}

TEST(FrameWriter, BadRectangleIsRefusedBeforeAnythingIsSent) {
  VirtualClock clock;
  hal::sim::Panel panel(write_panel(8, 8, 8, 1, 1), clock);
  std::vector<std::uint8_t> memory(64, 5);
  FrameWriter<Indexed8> writer(panel, memory);
  auto begun = writer.begin();
  const std::vector<Rect> rects{{0, 0, 2, 2}, {2'000'000, 0, 1, 1}};
  EXPECT_EQ(writer.present(std::move(begun).value(), {}, rects),
            Status(Error::out_of_domain, Argument::rectangle));
  EXPECT_EQ(std::ranges::count(panel.displayed().indices, 5), 0);
  EXPECT_FALSE(begun.value().empty());  // NOLINT(bugprone-use-after-move): a refused frame is kept.
}

TEST(FrameWriter, PaletteGoesOutWithTheFrame) {
  VirtualClock clock;
  hal::sim::Panel panel(write_panel(2, 1, 8, 1, 1), clock);
  std::vector<std::uint8_t> memory{1, 0};
  FrameWriter<Indexed8> writer(panel, memory);
  const std::vector<std::uint8_t> palette{1, 2, 3, 4, 5, 6};
  ASSERT_TRUE(writer.present(writer.begin().value(), palette).ok());
  EXPECT_EQ(panel.displayed().rgb, (std::vector<std::uint8_t>{4, 5, 6, 1, 2, 3}));
}

TEST(FrameWriter, FixedColoursTakeNoPalette) {
  VirtualClock clock;
  hal::sim::Panel panel(*hal::sim::find_panel("oled"), clock);
  std::vector<std::uint8_t> memory(4096);
  FrameWriter<Indexed4> writer(panel, memory);
  const std::vector<std::uint8_t> palette{1, 2, 3};
  auto begun = writer.begin();
  EXPECT_EQ(writer.present(std::move(begun).value(), palette), Status(Error::unsupported, Argument::palette));
}

TEST(FrameWriter, MemoryTooSmallSaysHowMuchIsNeeded) {
  VirtualClock clock;
  hal::sim::Panel panel(*hal::sim::find_panel("oled"), clock);
  std::vector<std::uint8_t> memory(4095);
  EXPECT_EQ(FrameWriter<Indexed4>(panel, memory).status(), Status(Error::too_small, Argument::buffer, 4096));
  EXPECT_EQ(FrameWriter<Indexed8>(panel, memory).status(), Status(Error::mismatched, Argument::panel));
  hal::sim::Panel scan_out(hal::sim::paletted(4, 4, 8), clock);
  EXPECT_EQ(FrameWriter<Indexed8>(scan_out, memory).status(), Status(Error::unsupported, Argument::panel));
}

TEST(FrameWriter, OneFrameAnIntervalAndLateOnesAreCounted) {
  VirtualClock clock;
  hal::sim::Panel panel(write_panel(8, 8, 8, 1, 1), clock);
  std::vector<std::uint8_t> memory(64);
  FrameWriter<Indexed8> writer(panel, memory, 2);
  for (const unsigned vblanks : {0U, 0U, 1U, 5U, 0U, 3U}) {
    clock.advance(vblanks * panel.frame_time());
    ASSERT_TRUE(writer.present(writer.begin().value()).ok());
  }
  EXPECT_EQ(writer.missed_deadlines(), 2U);
  EXPECT_EQ(panel.vblank_count(), 2U + 2U + 5U + 2U + 3U);
}

}  // namespace
