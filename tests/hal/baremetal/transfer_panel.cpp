// SPDX-License-Identifier: MIT
#include <hal/baremetal/transfer_panel.hpp>
#include <tests/hal/baremetal/fake_core.hpp>

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace {

using hal::Panel;
using hal::Status;
using hal::baremetal::FrameTransfer;
using hal::baremetal::TransferPanel;

class Wire final : public FrameTransfer {
 public:
  std::vector<std::uint8_t> pixels;
  std::vector<std::uint8_t> colours;
  Status answer;

 private:
  Status do_begin(std::span<const std::uint8_t> p, std::span<const std::uint8_t> c) noexcept override {
    pixels.assign(p.begin(), p.end());
    colours.assign(c.begin(), c.end());
    return answer;
  }
};

class Transfers : public testing::Test {
 public:
  ~Transfers() override { fake_core::on_sleep = nullptr; }

  Wire wire;
  std::array<std::uint8_t, 12> memory{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  TransferPanel<4> panel{{.width = 3, .height = 2, .palette_entries = 4}, wire, memory, 2};
};

TEST_F(Transfers, AFrameIsSentAtTheVblankAndItsBufferIsTakenUntilItIsOut) {
  const std::array<std::uint8_t, 6> colours{1, 2, 3, 250, 251, 252};
  EXPECT_EQ(panel.on_display(), Panel::nothing);
  ASSERT_TRUE(panel.show(1, colours).ok());
  EXPECT_TRUE(panel.show_pending());
  EXPECT_TRUE(wire.pixels.empty());
  panel.on_vblank();
  EXPECT_EQ(wire.pixels, (std::vector<std::uint8_t>{7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(wire.colours, (std::vector<std::uint8_t>(colours.begin(), colours.end())));
  EXPECT_FALSE(panel.show_pending());
  EXPECT_EQ(panel.on_display(), 1);
  panel.on_sent();
  EXPECT_EQ(panel.on_display(), Panel::nothing);
  EXPECT_EQ(panel.failed(), 0U);
}

TEST_F(Transfers, TheNextFrameWaitsForTheOneThatIsBeingSent) {
  ASSERT_TRUE(panel.show(1, {}).ok());
  panel.on_vblank();
  ASSERT_TRUE(panel.show(0, {}).ok());
  EXPECT_FALSE(panel.show_replaced());
  panel.on_vblank();
  EXPECT_EQ(wire.pixels[0], 7);
  EXPECT_TRUE(panel.show_pending());
  panel.on_sent();
  panel.on_vblank();
  EXPECT_EQ(wire.pixels[0], 1);
  EXPECT_EQ(panel.vblank_count(), 3U);
}

TEST_F(Transfers, ALaterRequestReplacesOneThatWaits) {
  ASSERT_TRUE(panel.show(1, {}).ok());
  ASSERT_TRUE(panel.show(0, {}).ok());
  EXPECT_TRUE(panel.show_replaced());
  panel.on_vblank();
  EXPECT_EQ(wire.pixels[0], 1);
}

TEST_F(Transfers, OneThatFailsIsCountedAndItsBufferFree) {
  wire.answer = {hal::Error::bus, hal::Part::bus};
  ASSERT_TRUE(panel.show(1, {}).ok());
  panel.on_vblank();
  EXPECT_EQ(panel.on_display(), Panel::nothing);
  EXPECT_EQ(panel.failed(), 1U);
  wire.answer = {};
  ASSERT_TRUE(panel.show(1, {}).ok());
  panel.on_vblank();
  EXPECT_EQ(panel.on_display(), 1);
  panel.on_sent(false);
  EXPECT_EQ(panel.failed(), 2U);
}

TEST_F(Transfers, ColoursOfOneThatFailsGoOutWithTheNextOnes) {
  const std::array<std::uint8_t, 9> three{1, 2, 3, 4, 5, 6, 7, 8, 9};
  const std::array<std::uint8_t, 3> one{11, 12, 13};
  wire.answer = {hal::Error::bus, hal::Part::bus};
  ASSERT_TRUE(panel.show(1, three).ok());
  panel.on_vblank();
  ASSERT_TRUE(panel.show(0, one).ok());
  panel.on_vblank();
  wire.answer = {};
  ASSERT_TRUE(panel.show(1, {}).ok());
  panel.on_vblank();
  const std::vector<std::uint8_t> joined{11, 12, 13, 4, 5, 6, 7, 8, 9};
  EXPECT_EQ(wire.colours, joined);
  panel.on_sent(false);
  ASSERT_TRUE(panel.show(1, {}).ok());
  panel.on_vblank();
  EXPECT_EQ(wire.colours, joined) << "broken off";
  panel.on_sent();
  ASSERT_TRUE(panel.show(1, {}).ok());
  panel.on_vblank();
  EXPECT_TRUE(wire.colours.empty()) << "they have arrived";
}

TEST_F(Transfers, WaitingSleepsUntilTheVblank) {
  int sleeps = 0;
  fake_core::on_sleep = [&] {
    EXPECT_TRUE(fake_core::masked());
    if (++sleeps == 2) panel.on_vblank();
  };
  EXPECT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(sleeps, 2);
}

TEST_F(Transfers, TooLittleMemoryOrTooManyColoursAreRefused) {
  TransferPanel<4> small({.width = 3, .height = 2}, wire, std::span(memory).first(11), 2);
  EXPECT_TRUE(small.buffer(1).empty());
  EXPECT_EQ(small.show(1, {}), Status(hal::Error::invalid, hal::Part::buffer));
  TransferPanel<1> pale({.width = 3, .height = 2, .palette_entries = 4}, wire, memory, 2);
  const std::array<std::uint8_t, 6> two{};
  EXPECT_EQ(pale.show(1, two), Status(hal::Error::invalid, hal::Part::palette));
  EXPECT_EQ(panel.write({0, 0, 3, 2}, memory, 3).error(), hal::Error::unsupported);
}

}  // namespace
