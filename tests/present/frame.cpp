// SPDX-License-Identifier: MIT
#include <hal/sim/panel.hpp>
#include <intaglio/image/clear.hpp>
#include <intaglio/present/frame_writer.hpp>
#include <intaglio/present/swap_chain.hpp>

#include <gtest/gtest.h>

#include <array>
#include <type_traits>
#include <utility>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::image::Indexed8;
using intaglio::present::Frame;
using intaglio::present::SwapChain;

static_assert(!std::is_copy_constructible_v<Frame<Indexed8>>);
static_assert(!std::is_copy_assignable_v<Frame<Indexed8>>);
static_assert(std::is_nothrow_move_constructible_v<Frame<Indexed8>>);
static_assert(std::is_nothrow_move_assignable_v<Frame<Indexed8>>);
// A frame that the caller keeps can't be presented: it must be given away.
template <class Chain>
concept PresentsKept = requires(Chain& chain, Frame<Indexed8>& kept) {
  chain.present(kept);
};
template <class Chain>
concept PresentsGiven = requires(Chain& chain, Frame<Indexed8>& kept) {
  chain.present(std::move(kept));
};
static_assert(!PresentsKept<SwapChain<Indexed8>>);
static_assert(PresentsGiven<SwapChain<Indexed8>>);

class FrameTest : public testing::Test {
 protected:
  hal::sim::VirtualClock clock_;
  hal::sim::Panel panel_{hal::sim::paletted(16, 8, 8), clock_};
  SwapChain<Indexed8> chain_{panel_};
};

TEST_F(FrameTest, DefaultFrameIsEmptyAndCantBePresented) {
  Frame<Indexed8> frame;
  EXPECT_TRUE(frame.empty());
  EXPECT_TRUE(frame.surface().empty());
  EXPECT_EQ(chain_.present(std::move(frame)), Status(Error::empty, Argument::frame));
}

TEST_F(FrameTest, AfterPresentingTheSurfaceIsEmptyAndDrawsNothing) {
  auto begun = chain_.begin();
  ASSERT_TRUE(begun.ok());
  Frame<Indexed8> frame = std::move(begun).value();
  ASSERT_TRUE(intaglio::image::clear(frame.surface(), 7).ok());
  ASSERT_TRUE(chain_.present(std::move(frame)).ok());
  EXPECT_TRUE(frame.surface().empty());  // NOLINT(bugprone-use-after-move): that is the test.
  EXPECT_TRUE(frame.empty());
  intaglio::image::clear(frame.surface(), 9).ignore();
  for (int i = 0; i < 2; ++i)
    for (const std::uint8_t byte : panel_.buffer(i)) ASSERT_NE(byte, 9);
}

TEST_F(FrameTest, PresentingTwiceIsAnError) {
  auto begun = chain_.begin();
  Frame<Indexed8> frame = std::move(begun).value();
  ASSERT_TRUE(chain_.present(std::move(frame)).ok());
  // NOLINTNEXTLINE(bugprone-use-after-move): that is the test.
  EXPECT_EQ(chain_.present(std::move(frame)), Status(Error::empty, Argument::frame));
}

TEST_F(FrameTest, OnlyOneFrameIsInWork) {
  auto first = chain_.begin();
  ASSERT_TRUE(first.ok());
  EXPECT_EQ(chain_.begin().status(), Status(Error::busy, Argument::frame));
  EXPECT_EQ(chain_.try_begin().status(), Status(Error::busy, Argument::frame));
}

TEST_F(FrameTest, DroppedFrameGoesBackToItsScreen) {
  std::uint8_t* buffer = nullptr;
  {
    auto dropped = chain_.begin();
    buffer = dropped.value().surface().byte_at(0, 0);
  }
  auto next = chain_.begin();
  ASSERT_TRUE(next.ok());
  EXPECT_EQ(next.value().surface().byte_at(0, 0), buffer);
}

TEST_F(FrameTest, MovingAFrameOverAnotherDropsTheOther) {
  hal::sim::Panel other_panel(hal::sim::paletted(4, 4, 8), clock_);
  SwapChain<Indexed8> other(other_panel);
  auto mine = chain_.begin();
  auto theirs = other.begin();
  theirs.value() = std::move(mine).value();
  EXPECT_EQ(theirs.value().surface().size().width, 16);
  EXPECT_TRUE(other.begin().ok());
  EXPECT_FALSE(chain_.begin().ok());
}

TEST_F(FrameTest, FrameOfAnotherScreenIsRefusedAndKept) {
  hal::sim::Panel other_panel(hal::sim::paletted(16, 8, 8), clock_);
  SwapChain<Indexed8> other(other_panel);
  auto theirs = other.begin();
  EXPECT_EQ(chain_.present(std::move(theirs).value()), Status(Error::mismatched, Argument::frame));
  EXPECT_TRUE(other.present(std::move(theirs).value()).ok());  // NOLINT(bugprone-use-after-move)
}

TEST_F(FrameTest, BadPaletteIsRefusedAndTheFrameKept) {
  auto begun = chain_.begin();
  Frame<Indexed8> frame = std::move(begun).value();
  const std::array<std::uint8_t, 4> not_whole_entries{};
  const std::array<std::uint8_t, 257 * 3> too_long{};
  EXPECT_EQ(chain_.present(std::move(frame), not_whole_entries), Status(Error::malformed, Argument::palette));
  // NOLINTNEXTLINE(bugprone-use-after-move): a refused frame is still the caller's.
  EXPECT_EQ(chain_.present(std::move(frame), too_long), Status(Error::too_large, Argument::palette, 768));
  EXPECT_FALSE(frame.empty());                         // NOLINT(bugprone-use-after-move)
  EXPECT_TRUE(chain_.present(std::move(frame)).ok());  // NOLINT(bugprone-use-after-move)
}

}  // namespace
