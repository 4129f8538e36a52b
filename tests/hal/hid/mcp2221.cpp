// SPDX-License-Identifier: MIT
//
// A bridge from USB to I2C with a display on it: the bridge as its data sheet describes it, the display as
// its own does.
#include <hal/hid/host/mcp2221.hpp>
#include <hal/mock/strict_ssd1306.hpp>
#include <hal/panels/command_port.hpp>
#include <hal/panels/ssd1306.hpp>
#include <hal/sim/virtual_clock.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <random>
#include <vector>

namespace {

using hal::Error;
using hal::Nanoseconds;
using hal::hid::Mcp2221I2c;
using Bytes = std::vector<std::uint8_t>;

/// The bridge. Its engine needs 25 us a byte; what is written meanwhile is refused.
class Bridge final : public hal::hid::ReportPort {
 public:
  Bridge(hal::sim::VirtualClock& clock, hal::I2cBus& bus, std::uint8_t address)
      : clock_(&clock), bus_(&bus), address_(address) {}

  std::vector<Bytes> transactions;
  int refused = 0;
  int cancelled = 0;
  bool speed_set = false;
  std::uint8_t divider = 0;
  /// Answers of the device that were never asked for come first.
  int stale = 0;
  bool deaf = false;
  /// The bus hangs: the engine never comes to rest.
  bool hung = false;

 private:
  hal::Status do_send(std::span<const std::uint8_t> report) noexcept override {
    EXPECT_EQ(report.size(), 64U);
    clock_->advance(1'000'000 / 8);
    run();
    Bytes answer(64);
    answer[0] = report[0];
    if (report[0] == 0x10) {
      status(report, answer);
    } else if (report[0] == 0x90) {
      write(report, answer);
    } else {
      ADD_FAILURE() << "a command that the bridge doesn't know";
      answer[1] = 1;
    }
    if (deaf) return {};
    for (; stale > 0; --stale) answers_.push_back(Bytes(64, 0x61));
    answers_.push_back(answer);
    return {};
  }

  void status(std::span<const std::uint8_t> report, Bytes& answer) {
    if (report[2] == 0x10) {
      ++cancelled;
      answer[2] = state_ == 0 ? 0x11 : 0x10;
      state_ = 0;
      hung = false;
      refused_address_ = false;
      pending_.clear();
    }
    if (report[3] == 0x20) {
      speed_set = state_ == 0;
      answer[3] = speed_set ? 0x20 : 0x21;
      divider = report[4];
    }
    answer[8] = state_;
    if (refused_address_) answer[20] = 0x40;
  }

  void write(std::span<const std::uint8_t> report, Bytes& answer) {
    const std::size_t all = static_cast<std::size_t>(report[1] | report[2] << 8);
    const bool first = pending_.empty();
    if (state_ != 0 && (busy() || first)) {
      ++refused;
      answer[1] = 1;
      answer[2] = state_;
      return;
    }
    if (first) wanted_ = all;
    EXPECT_EQ(all, wanted_) << "the length changed in mid-transfer";
    EXPECT_EQ(report[3] & 1, 0);
    target_ = static_cast<std::uint8_t>(report[3] >> 1);
    const std::size_t count = std::min<std::size_t>(60, wanted_ - pending_.size());
    pending_.insert(pending_.end(), report.begin() + 4,
                    report.begin() + 4 + static_cast<std::ptrdiff_t>(count));
    state_ = 0x41;
    ready_at_ = clock_->now() + count * 25'000U;
    answer[2] = state_;
  }

  [[nodiscard]] bool busy() const { return hung || clock_->now() < ready_at_; }

  void run() {
    if (state_ != 0x41 || busy()) return;
    if (target_ != address_) {
      state_ = 0x25;
      refused_address_ = true;
      return;
    }
    if (pending_.size() < wanted_) return;  // 0x41: it waits for more
    transactions.push_back(pending_);
    bus_->write(target_, std::span(pending_).first(1), std::span(pending_).subspan(1)).ignore();
    pending_.clear();
    state_ = 0;
  }

  hal::hid::Received do_receive(std::span<std::uint8_t> report, Nanoseconds patience) noexcept override {
    if (answers_.empty()) {
      clock_->advance(patience);
      return {{Error::timeout, hal::Part::bus}, 0};
    }
    std::copy(answers_.front().begin(), answers_.front().end(), report.begin());
    answers_.pop_front();
    return {{}, 64};
  }
  hal::Status do_reopen() noexcept override { return {}; }

  hal::sim::VirtualClock* clock_;
  hal::I2cBus* bus_;
  std::uint8_t address_;
  std::deque<Bytes> answers_;
  Bytes pending_;
  std::size_t wanted_ = 0;
  std::uint8_t target_ = 0;
  std::uint8_t state_ = 0;
  bool refused_address_ = false;
  Nanoseconds ready_at_ = 0;
};

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

}  // namespace
