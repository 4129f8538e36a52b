// SPDX-License-Identifier: MIT
//
// A day of virtual time: what happens once in a million frames happens here. Draw times, colours and faults
// are random; nothing is torn, no update is lost, and the counts are those of the faults that were made. A
// quick run lasts a few minutes of the same day.
#include <hal/sim/panel.hpp>
#include <intaglio/present/bands.hpp>
#include <intaglio/present/swap_chain.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/present/slow_panel.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <utility>

namespace {

using hal::Nanoseconds;
using hal::sim::VirtualClock;
using intaglio::Status;
using intaglio::image::Indexed8;
using intaglio::image::Surface;
using intaglio::present::BandWriter;
using intaglio::present::BeamChaser;
using intaglio::present::BeamTiming;
using intaglio::present::FrameCounts;
using intaglio::present::Late;
using intaglio::present::Order;
using intaglio::present::Pace;
using intaglio::present::SwapChain;

constexpr std::uint64_t refreshes_of_a_day = 24ULL * 3600U * 60U;

std::uint64_t refreshes_wanted() { return oracle::samples<std::uint64_t>(20'000, refreshes_of_a_day); }

/// The byte that stands for a frame.
std::uint8_t mark(std::uint64_t frame) { return static_cast<std::uint8_t>(frame & 255U); }

/// A simulated panel whose requests and waits fail now and then.
class FaultyPanel final : public hal::Panel {
 public:
  FaultyPanel(hal::sim::Panel& panel, std::minstd_rand& random) : panel_(&panel), random_(&random) {}

  bool faulty = true;
  std::uint32_t faults = 0;

 private:
  const hal::Capabilities& do_capabilities() const noexcept override { return panel_->capabilities(); }
  std::span<std::uint8_t> do_buffer(int index) noexcept override { return panel_->buffer(index); }
  int do_buffer_stride() const noexcept override { return panel_->buffer_stride(); }
  hal::Status do_show(int index, std::span<const std::uint8_t> palette) noexcept override {
    if (!faulty || (*random_)() % 500U != 0) return panel_->show(index, palette);
    ++faults;
    return {hal::Error::bus, hal::Part::bus};
  }
  bool do_show_pending() noexcept override { return panel_->show_pending(); }
  bool do_show_replaced() noexcept override { return panel_->show_replaced(); }
  int do_on_display() noexcept override { return panel_->on_display(); }
  hal::Status do_write(const hal::Rect&, std::span<const std::uint8_t>, int) noexcept override { return {}; }
  hal::Status do_load_palette(std::span<const std::uint8_t>) noexcept override { return {}; }
  std::uint32_t do_vblank_count() noexcept override { return panel_->vblank_count(); }
  hal::Status do_wait_for_vblank() noexcept override {
    if (!faulty || (*random_)() % 300U != 0) return panel_->wait_for_vblank();
    ++faults;
    return {hal::Error::timeout, hal::Part::panel};
  }

  hal::sim::Panel* panel_;
  std::minstd_rand* random_;
};

/// One who looks at every line, and keeps his own counts.
class Viewer final : public hal::sim::Observer {
 public:
  explicit Viewer(const Pace& pace) : pace_(pace) {}

  /// Frame `n` is presented, and from now on index 0 has this colour.
  void presented(std::uint64_t n, std::uint8_t colour) {
    colours_[n & 255U] = colour;
    latest_ = n;
  }

  std::uint64_t torn = 0;
  std::uint64_t refreshes = 0;
  std::uint64_t out_of_order = 0;
  std::uint64_t last = 0;  ///< The frame seen last.
  FrameCounts seen{};

 private:
  void on_line(const hal::sim::ScannedLine& line) override {
    if (line.y == 0) value_ = line.pixels[0];
    for (const std::uint8_t pixel : line.pixels) whole_ = whole_ && pixel == value_;
    whole_ = whole_ && (value_ == 0 || line.palette[0] == colours_[value_]);
    if (line.y == 0) first_ = value_ != mark(last);
  }
  void on_vblank(std::uint64_t refresh, Nanoseconds) override {
    ++refreshes;
    torn += whole_ ? 0U : 1U;
    whole_ = true;
    if (!std::exchange(first_, false)) return;
    // The latest frame with that mark; there are fewer than 256 between the one seen and the one presented
    // last.
    const std::uint64_t n = latest_ - static_cast<std::uint8_t>(mark(latest_) - value_);
    if (n <= last) ++out_of_order;
    last = n;
    ++seen.shown;
    const auto gap = static_cast<std::uint32_t>(refresh - at_);
    const auto interval = static_cast<std::uint32_t>(pace_.interval);
    if (seen.shown > 1) {
      if (gap < interval) ++out_of_order;
      seen.repeated += gap - interval;
    }
    at_ = refresh;
  }

  Pace pace_;
  std::array<std::uint8_t, 256> colours_{};
  std::uint64_t latest_ = 0;
  std::uint8_t value_ = 0;
  bool whole_ = true;
  bool first_ = false;
  std::uint64_t at_ = 0;
};

void scan_out_for_a_day(int buffers, const Pace& pace, unsigned seed) {
  SCOPED_TRACE(seed);
  std::minstd_rand random(seed);
  VirtualClock clock;
  hal::sim::Panel panel(hal::sim::paletted(2, 3, 8, buffers), clock);
  FaultyPanel faulty(panel, random);
  Viewer viewer(pace);
  panel.attach(viewer);
  SwapChain<Indexed8> chain(faulty, pace);
  std::uint32_t not_begun = 0;
  std::uint32_t lost = 0;
  std::uint8_t colour = 0;
  std::uint64_t n = 0;
  while (n == 0 || faulty.faulty) {
    // The last frame comes through, so that all counts end with one.
    faulty.faulty = viewer.refreshes < refreshes_wanted();
    auto begun = chain.begin();
    if (!begun.ok()) {
      ++not_begun;
      continue;
    }
    ++n;
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 2; ++x) begun.value().surface().set(x, y, mark(n));
    const Nanoseconds most = panel.frame_time() * (random() % 100U == 0 ? 5U : 1U);
    clock.advance(random() % most);
    const std::array<std::uint8_t, 3> palette{static_cast<std::uint8_t>(random()), 0, 0};
    const bool recoloured = random() % 3U == 0;
    if (recoloured) colour = palette[0];
    viewer.presented(n, colour);
    const auto given = std::span<const std::uint8_t>(palette).first(recoloured ? 3 : 0);
    if (!chain.present(std::move(begun).value(), given).ok()) ++lost;
  }
  ASSERT_TRUE(chain.wait_until_shown().ok());
  clock.advance(2U * panel.frame_time());
  panel.detach(viewer);
  const FrameCounts counts = chain.counts();
  EXPECT_EQ(viewer.torn, 0U);
  EXPECT_EQ(viewer.out_of_order, 0U);
  EXPECT_EQ(not_begun + lost, faulty.faults);
  EXPECT_GT(lost, 10U);
  EXPECT_EQ(counts.shown, viewer.seen.shown);
  EXPECT_EQ(counts.shown + counts.dropped, n);
  if (pace.late == Late::show && pace.order == Order::every) {
    EXPECT_EQ(counts.dropped, lost) << "only what the device lost";
  }
  EXPECT_EQ(counts.repeated, viewer.seen.repeated);
  EXPECT_GT(counts.repeated, 10U);
}

TEST(ADay, IsWatchedByOneWhoSeesAnEarlySwap) {
  VirtualClock clock;
  hal::sim::PanelSpec spec = hal::sim::paletted(2, 3, 8);
  spec.latch = hal::sim::Latch::at_once;
  hal::sim::Panel panel(spec, clock);
  Viewer viewer(1);
  panel.attach(viewer);
  for (std::uint8_t n = 1; n <= 20; ++n) {
    viewer.presented(n, 0);
    std::ranges::fill(panel.buffer(n % 2), n);
    clock.advance(panel.line_time());
    ASSERT_TRUE(panel.show(n % 2, {}).ok());
  }
  panel.detach(viewer);
  EXPECT_GT(viewer.torn, 1U);
}

TEST(ADay, OfTwoBuffersIsWholeAndCounted) { scan_out_for_a_day(2, 1, 60'001); }
TEST(ADay, OfTwoBuffersDroppingLateFramesIsWholeAndCounted) {
  scan_out_for_a_day(2, Pace(2, Late::drop), 60'002);
}
TEST(ADay, OfTheLatestOfThreeBuffersIsWholeAndCounted) {
  scan_out_for_a_day(3, Pace(1, Late::show, Order::latest), 60'003);
}

/// A panel whose signal drops out, whose bus fails and whose program is slow now and then.
void chase_for_a_day(hal::ScanDirection scan, std::size_t rows, const Pace& pace, unsigned seed) {
  SCOPED_TRACE(seed);
  constexpr int side = 4;
  std::minstd_rand random(seed);
  VirtualClock clock;
  // 20 ms of bus a picture: slower than the beam.
  const BeamTiming timing{.refresh = 16'666'667,
                          .first_line = 1'000'000,
                          .scan_line = 3'900'000,
                          .bus_line = 4'900'000,
                          .bus_band = 100'000,
                          .draw_line = 50'000,
                          .margin = 20'000};
  slow::SlowPanel panel(clock, side, side, scan, timing);
  panel.silent.assign(997, false);
  for (int i = 0; i < 100; ++i) panel.silent[random() % panel.silent.size()] = true;
  panel.signal_delay = 15'000;
  BeamChaser chaser(clock, panel, timing);
  std::array<std::uint8_t, 2 * side> memory{};
  BandWriter<Indexed8> writer(panel, std::span(memory).first(rows * side), chaser, pace);
  ASSERT_TRUE(writer.status().ok());
  ASSERT_TRUE(chaser.tear_free());
  std::uint32_t faults = 0;
  std::uint64_t lost_updates = 0;
  std::uint64_t n = 0;
  std::uint8_t colour = 0;
  while (panel.refreshes < refreshes_wanted()) {
    ++n;
    panel.lost[mark(n)] = false;
    if (random() % 100U == 0) clock.advance(random() % (5U * timing.refresh));
    const auto draw = [n](const Surface<Indexed8>& band) {
      const auto b = band.bounds();
      for (int y = b.y; y < b.bottom(); ++y)
        for (int x = b.x; x < b.right(); ++x) band.set(x, y, mark(n));
      return Status{};
    };
    const std::array<std::uint8_t, 3> palette{static_cast<std::uint8_t>(random()), 0, 0};
    const bool recoloured = random() % 3U == 0;
    if (recoloured) colour = palette[0];
    const bool fault = random() % 500U == 0;
    panel.writes_until_fault = fault ? static_cast<int>(random() % (side / rows)) : -1;
    const std::uint32_t shown = writer.counts().shown;
    const Status s = writer.present(draw, std::span<const std::uint8_t>(palette).first(recoloured ? 3 : 0));
    if (!s.ok()) {
      ++faults;
      panel.lost[mark(n)] = true;
    }
    if (writer.counts().shown == shown) continue;
    for (const std::uint16_t pixel : panel.glass) lost_updates += pixel != (mark(n) | colour << 8U) ? 1U : 0U;
  }
  const FrameCounts counts = writer.counts();
  EXPECT_EQ(panel.torn, 0U);
  EXPECT_EQ(chaser.torn(), 0U);
  EXPECT_EQ(lost_updates, 0U);
  EXPECT_GT(faults, 10U);
  EXPECT_GT(panel.excused, 0U) << "a picture that a fault broke off is seen";
  EXPECT_EQ(counts.shown + counts.dropped, n);
  if (pace.late == Late::show) {
    EXPECT_EQ(counts.dropped, faults);
  }
  EXPECT_GT(counts.late, 10U);
}

TEST(ADay, BehindTheBeamIsWholeAndCounted) { chase_for_a_day(hal::ScanDirection::down, 2, 2, 60'004); }
TEST(ADay, BehindARisingBeamDroppingLateFramesIsWholeAndCounted) {
  chase_for_a_day(hal::ScanDirection::up, 1, Pace(2, Late::drop), 60'005);
}

}  // namespace
