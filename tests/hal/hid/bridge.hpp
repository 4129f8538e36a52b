// SPDX-License-Identifier: MIT
//
// A bridge from USB to I2C as its data sheet describes it.
#pragma once

#include <hal/bus.hpp>
#include <hal/hid/host/report_port.hpp>
#include <hal/sim/virtual_clock.hpp>
#include <tests/hal/hid/cable.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

namespace tests::hid {

using Bytes = std::vector<std::uint8_t>;

/// The bridge. Its engine needs 25 us a byte; what is written meanwhile is refused.
class Bridge final : public hal::hid::ReportPort {
 public:
  Bridge(hal::sim::VirtualClock& clock, hal::I2cBus& bus, std::uint8_t at)
      : address(at), clock_(&clock), bus_(&bus) {}

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
  Cable cable;
  /// The display at the other end; another address: none answers.
  std::uint8_t address;

  /// The power was off, and there is another display now.
  void restart(hal::I2cBus& bus) {
    bus_ = &bus;
    answers_.clear();
    pending_.clear();
    state_ = 0;
    refused_address_ = hung = speed_set = false;
  }

 private:
  hal::Status do_send(std::span<const std::uint8_t> report) noexcept override {
    if (!cable.carries()) return {hal::Error::disconnected, hal::Part::panel};
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
    if (target_ != address) {
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

  hal::hid::Received do_receive(std::span<std::uint8_t> report, hal::Nanoseconds patience) noexcept override {
    if (!cable.plugged()) return {{hal::Error::disconnected, hal::Part::panel}, 0};
    if (answers_.empty()) {
      clock_->advance(patience);
      return {{hal::Error::timeout, hal::Part::bus}, 0};
    }
    std::copy(answers_.front().begin(), answers_.front().end(), report.begin());
    answers_.pop_front();
    return {{}, 64};
  }
  hal::Status do_look() noexcept override { return cable.status(); }
  hal::Status do_reopen() noexcept override { return cable.look(); }

  hal::sim::VirtualClock* clock_;
  hal::I2cBus* bus_;
  std::deque<Bytes> answers_;
  Bytes pending_;
  std::size_t wanted_ = 0;
  std::uint8_t target_ = 0;
  std::uint8_t state_ = 0;
  bool refused_address_ = false;
  hal::Nanoseconds ready_at_ = 0;
};

}  // namespace tests::hid
