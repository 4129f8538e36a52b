// SPDX-License-Identifier: MIT
//
// Screens on devices that fail or whose VBLANK comes at the worst moment.
#include <hal/mock/doubles.hpp>
#include <hal/mock/strict_panel.hpp>
#include <intaglio/present/bands.hpp>
#include <intaglio/present/frame_writer.hpp>
#include <intaglio/present/swap_chain.hpp>

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

namespace {

using hal::mock::MockPanel;
using hal::mock::StrictPanel;
using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::image::Indexed8;
using intaglio::image::Surface;
using intaglio::linear::Rect;
using intaglio::present::BandWriter;
using intaglio::present::FrameWriter;
using intaglio::present::SwapChain;
using testing::_;
using testing::NiceMock;
using testing::Return;

const Status device(Error::device, Argument::panel);
constexpr hal::Status timeout(hal::Error::timeout, hal::Part::panel);

/// A scan-out panel of 4x2 pixels whose VBLANKs the test makes.
class ScannedPanel : public testing::Test {
 protected:
  ScannedPanel() {
    ON_CALL(panel_, do_buffer(_)).WillByDefault(Return(std::span(memory_)));
    ON_CALL(panel_, do_buffer_stride()).WillByDefault(Return(4));
  }
  std::array<std::uint8_t, 8> memory_{};
  NiceMock<MockPanel> panel_{hal::mock::scan_out_panel(4, 2, 8)};
};

TEST_F(ScannedPanel, AVblankThatDoesntComeIsADeviceError) {
  SwapChain<Indexed8> chain(panel_);
  ASSERT_TRUE(chain.present(chain.begin().value()).ok());
  ON_CALL(panel_, do_show_pending()).WillByDefault(Return(true));
  ON_CALL(panel_, do_wait_for_vblank()).WillByDefault(Return(timeout));
  EXPECT_EQ(chain.begin().status(), device);
  EXPECT_EQ(chain.wait_until_shown(), device);
  EXPECT_EQ(chain.try_begin().status(), Status(Error::busy, Argument::frame));
}

TEST_F(ScannedPanel, AFrameThatCouldntBeShownIsGoneAndTheNextCanBegin) {
  SwapChain<Indexed8> chain(panel_);
  EXPECT_CALL(panel_, do_show(1, _)).WillOnce(Return(hal::Status(hal::Error::bus, hal::Part::bus)));
  auto begun = chain.begin();
  EXPECT_EQ(chain.present(std::move(begun).value()), device);
  EXPECT_TRUE(begun.value().empty());  // NOLINT(bugprone-use-after-move): that is the test.
  // It was never on display, so its buffer is the one to draw on.
  EXPECT_CALL(panel_, do_show(1, _));
  EXPECT_TRUE(chain.present(chain.begin().value()).ok());
}

TEST_F(ScannedPanel, BusyDeviceStaysBusy) {
  SwapChain<Indexed8> chain(panel_);
  EXPECT_CALL(panel_, do_show(_, _)).WillOnce(Return(hal::Status(hal::Error::busy, hal::Part::buffer)));
  EXPECT_EQ(chain.present(chain.begin().value()), Status(Error::busy, Argument::panel));
}

TEST_F(ScannedPanel, AVblankBetweenTwoQuestionsIsntCountedTwice) {
  // Frame 1 is asked for in VBLANK period 5; the VBLANK comes between asking for the count and asking whether
  // the request still waits, so it appeared at 6. Frame 2 is asked for in period 6 and appears at 7: in time.
  // Frame 3 is asked for in period 8 and appears at 9: one too late.
  std::uint32_t count = 5;
  bool pending = false;
  bool vblank_after_next_count = false;
  ON_CALL(panel_, do_vblank_count()).WillByDefault([&] {
    const std::uint32_t answer = count;
    if (std::exchange(vblank_after_next_count, false)) {
      ++count;
      pending = false;
    }
    return answer;
  });
  ON_CALL(panel_, do_show_pending()).WillByDefault([&] { return pending; });
  ON_CALL(panel_, do_wait_for_vblank()).WillByDefault([&] {
    ++count;
    pending = false;
    return hal::Status{};
  });
  SwapChain<Indexed8> chain(panel_);
  EXPECT_CALL(panel_, do_show(_, _))
      .WillOnce([&](int, auto) {
        pending = true;
        vblank_after_next_count = true;
        return hal::Status{};
      })
      .WillRepeatedly([&](int, auto) {
        pending = true;
        return hal::Status{};
      });
  ASSERT_TRUE(chain.present(chain.begin().value()).ok());
  EXPECT_EQ(count, 6U);
  ASSERT_TRUE(chain.present(chain.begin().value()).ok());
  EXPECT_EQ(chain.missed_deadlines(), 0U);
  auto third = chain.begin();
  EXPECT_EQ(count, 7U);
  count = 8;
  ASSERT_TRUE(chain.present(std::move(third).value()).ok());
  EXPECT_EQ(chain.missed_deadlines(), 1U);
}

TEST_F(ScannedPanel, CountsThatWrapKeepTheRhythm) {
  std::uint32_t count = 0xFFFF'FFFFU;
  ON_CALL(panel_, do_vblank_count()).WillByDefault([&] { return count; });
  ON_CALL(panel_, do_wait_for_vblank()).WillByDefault([&] {
    ++count;
    return hal::Status{};
  });
  SwapChain<Indexed8> chain(panel_, 3);
  for (int n = 0; n < 4; ++n) ASSERT_TRUE(chain.present(chain.begin().value()).ok());
  EXPECT_EQ(chain.missed_deadlines(), 0U);
}

TEST_F(ScannedPanel, BufferOfADriverThatIsTooSmallIsReported) {
  ON_CALL(panel_, do_buffer(_)).WillByDefault(Return(std::span(memory_).first(7)));
  EXPECT_EQ(SwapChain<Indexed8>(panel_).status(), Status(Error::too_small, Argument::buffer, 8));
  ON_CALL(panel_, do_buffer_stride()).WillByDefault(Return(3));
  EXPECT_EQ(SwapChain<Indexed8>(panel_).status(), Status(Error::too_small, Argument::stride, 4));
}

TEST(FrameWriterFaults, WhatCouldntBeSentGoesOutWithTheNextFrame) {
  StrictPanel panel(hal::mock::write_panel(6, 2, 8), {.drawing_twice = true});
  std::vector<std::uint8_t> memory(12);
  FrameWriter<Indexed8> writer(panel, memory);
  ASSERT_TRUE(writer.present(writer.begin().value()).ok());
  memory[0] = 1;
  memory[5] = 2;
  const std::array<Rect, 2> corners{Rect{0, 0, 1, 1}, Rect{5, 0, 1, 1}};
  panel.fail_next({hal::Error::bus, hal::Part::bus});
  EXPECT_EQ(writer.present(writer.begin().value(), {}, corners), device);
  panel.expect_picture({"......", "......"});
  memory[11] = 3;
  const std::array<Rect, 1> last{Rect{5, 1, 1, 1}};
  ASSERT_TRUE(writer.present(writer.begin().value(), {}, last).ok());
  panel.expect_picture({"#....2", ".....3"});
}

TEST(FrameWriterFaults, PaletteThatCouldntBeLoadedIsADeviceError) {
  StrictPanel panel(hal::mock::write_panel(2, 1, 8));
  std::vector<std::uint8_t> memory(2);
  FrameWriter<Indexed8> writer(panel, memory);
  const std::array<std::uint8_t, 3> colour{1, 2, 3};
  panel.fail_next({hal::Error::bus, hal::Part::bus});
  EXPECT_EQ(writer.present(writer.begin().value(), colour), device);
  EXPECT_EQ(panel.palette()[0], 0);
}

TEST(FrameWriter, EveryPixelIsSentOnceEvenIfDirtyRectanglesOverlap) {
  StrictPanel panel(hal::mock::write_panel(8, 4, 8));
  std::vector<std::uint8_t> memory(32);
  FrameWriter<Indexed8> writer(panel, memory);
  ASSERT_TRUE(writer.present(writer.begin().value()).ok());
  panel.forget_writes();
  const std::array<Rect, 3> dirty{Rect{0, 0, 3, 2}, Rect{2, 1, 3, 2}, Rect{7, 3, 9, 9}};
  ASSERT_TRUE(writer.present(writer.begin().value(), {}, dirty).ok());
  panel.expect_writes({"#####...",  //
                       "#####...",  //
                       "#####...",  //
                       ".......#"});
}

TEST(BandWriterFaults, ABusFaultEndsTheFrame) {
  NiceMock<MockPanel> panel(hal::mock::write_panel(4, 4, 8));
  std::vector<std::uint8_t> memory(4);
  BandWriter<Indexed8> bands(panel, memory);
  EXPECT_CALL(panel, do_write(_, _, _))
      .WillOnce(Return(hal::Status{}))
      .WillOnce(Return(hal::Status(hal::Error::bus, hal::Part::bus)));
  EXPECT_EQ(bands.present([](const Surface<Indexed8>&) { return Status{}; }), device);
}

}  // namespace
