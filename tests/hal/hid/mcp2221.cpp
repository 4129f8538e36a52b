// SPDX-License-Identifier: MIT
//
// A bridge from USB to I2C with a display on it: the bridge as its data sheet describes it, the display as
// its own does.
#include <hal/hid/host/mcp2221.hpp>
#include <hal/mock/strict_ssd1306.hpp>
#include <hal/panels/command_port.hpp>
#include <hal/panels/ssd1306.hpp>
#include <tests/hal/hid/bridge.hpp>

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace {

using hal::Error;
using hal::hid::Mcp2221I2c;
using tests::hid::Bridge;
using tests::hid::Bytes;

/// Keeps what it is given.
class Recorder final : public hal::I2cBus {
 private:
  hal::Status do_write(std::uint8_t, std::span<const std::uint8_t>,
                       std::span<const std::uint8_t>) noexcept override {
    return {};
  }
};

TEST(Mcp2221, ShowsAPictureOnAnSsd1306) {
  hal::sim::VirtualClock clock;
  hal::mock::StrictSsd1306 display(128, 64);
  Bridge bridge(clock, display.i2c(), 0x3C);
  Mcp2221I2c bus(bridge, clock);
  ASSERT_TRUE(bus.start().ok());
  hal::panels::I2cPort port(bus, 0x3C);
  hal::panels::Ssd1306 panel(port);
  ASSERT_TRUE(panel.start().ok());
  std::mt19937 random(11);
  Bytes picture(16U * 64U);
  for (auto& byte : picture) byte = static_cast<std::uint8_t>(random());
  ASSERT_TRUE(panel.write({0, 0, 128, 64}, picture, 16).ok());
  int wrong = 0;
  const auto shown = display.displayed();
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 128; ++x)
      wrong += shown.at(x, y) != (picture[static_cast<std::size_t>(y * 16 + x / 8)] >> (7 - x % 8) & 1);
  EXPECT_EQ(wrong, 0);
  display.expect_idle();
}

TEST(Mcp2221, CutsTransfersIntoPiecesOfSixty) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{59}, std::size_t{60},
                                 std::size_t{120}, std::size_t{700}}) {
    hal::sim::VirtualClock clock;
    Recorder nothing;
    Bridge bridge(clock, nothing, 0x3D);
    Mcp2221I2c bus(bridge, clock);
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i * 5U);
    const Bytes prefix{0x40};
    bridge.stale = 2;
    ASSERT_TRUE(bus.write(0x3D, prefix, bytes).ok()) << size;
    bytes.insert(bytes.begin(), 0x40);
    ASSERT_EQ(bridge.transactions.size(), 1U);
    EXPECT_EQ(bridge.transactions[0], bytes);
    EXPECT_EQ(bridge.refused > 0, size >= 60) << "the engine is busy after a whole piece";
    EXPECT_EQ(bridge.cancelled, 0);
  }
}

TEST(Mcp2221, SetsTheSpeed) {
  hal::sim::VirtualClock clock;
  Recorder nothing;
  Bridge bridge(clock, nothing, 0x3C);
  Mcp2221I2c bus(bridge, clock);
  ASSERT_TRUE(bus.start(400'000).ok());
  EXPECT_EQ(bridge.divider, 27);
  ASSERT_TRUE(bus.start(100'000).ok());
  EXPECT_EQ(bridge.divider, 117);
  EXPECT_EQ(bus.start(1'000).error(), Error::invalid);
  EXPECT_EQ(bus.start(1'000'000).error(), Error::invalid);
}

TEST(Mcp2221, TellsWhenNothingIsThereAndFreesTheBus) {
  hal::sim::VirtualClock clock;
  Recorder nothing;
  Bridge bridge(clock, nothing, 0x3C);
  Mcp2221I2c bus(bridge, clock);
  for (const std::size_t size : {std::size_t{3}, std::size_t{200}}) {
    EXPECT_EQ(bus.write(0x3D, {}, Bytes(size, 1)).error(), Error::bus);
    EXPECT_TRUE(bus.write(0x3C, {}, Bytes(size, 1)).ok()) << "the next transfer finds a free bus";
  }
  EXPECT_EQ(bridge.cancelled, 2);
}

TEST(Mcp2221, GivesUpABusThatHangsAndABridgeThatSaysNothing) {
  hal::sim::VirtualClock clock;
  Recorder nothing;
  Bridge bridge(clock, nothing, 0x3C);
  Mcp2221I2c bus(bridge, clock);
  bridge.hung = true;
  EXPECT_EQ(bus.write(0x3C, {}, Bytes(10, 1)).error(), Error::timeout);
  EXPECT_TRUE(bus.write(0x3C, {}, Bytes(10, 1)).ok());
  bridge.deaf = true;
  EXPECT_EQ(bus.write(0x3C, {}, Bytes(10, 1)).error(), Error::timeout);
  EXPECT_EQ(bus.start().error(), Error::timeout);
}

/// A clock that leaps by a minute at each question.
class LeapingClock final : public hal::Clock {
 private:
  hal::Nanoseconds do_now() noexcept override { return now_ += 60'000'000'000; }
  void do_wait_until(hal::Nanoseconds) noexcept override {}
  hal::Nanoseconds now_ = 0;
};

TEST(Mcp2221, IsNotGivenUpBecauseTheClockLeaps) {
  hal::sim::VirtualClock clock;
  Recorder nothing;
  Bridge bridge(clock, nothing, 0x3C);
  LeapingClock leaping;
  Mcp2221I2c bus(bridge, leaping);
  bridge.stale = 2;
  ASSERT_TRUE(bus.start().ok());
  ASSERT_TRUE(bus.write(0x3C, {}, Bytes(100, 1)).ok());
}

}  // namespace
