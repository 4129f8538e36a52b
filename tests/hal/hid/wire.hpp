// SPDX-License-Identifier: MIT
//
// A USB cable in memory, with a clock that a test moves: the host's port at one end, a device at the other,
// and everything between them that can go wrong.
//
// Rule: reports to the device wait in a queue of 32, as in Linux's uhid, and are dropped silently when it is
// full; those to the host in one of 64, as in hidraw. A report takes 20 us, and time passes only on the wire
// and while the host waits.
#pragma once

#include <hal/hid/device/device.hpp>
#include <hal/hid/host/link.hpp>
#include <hal/hid/host/panel.hpp>
#include <hal/sim/panel.hpp>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

namespace tests::hid {

using Bytes = std::vector<std::uint8_t>;

enum class Direction : std::uint8_t { to_device, to_host };

/// What becomes of a report on the wire.
enum class Fate : std::uint8_t { arrives, lost, doubled, late, garbled };

class Wire final : public hal::hid::ReportPort {
 public:
  Wire(hal::sim::VirtualClock& clock, hal::hid::Device& device) : clock_(&clock), device_(&device) {}

  /// Decides what becomes of report number n (from 0 on) of a direction; none: all arrive.
  std::function<Fate(Direction, std::uint64_t)> fate;
  /// Called with each report that arrives at the device.
  std::function<void(const Bytes&)> witness;
  /// Called with each report that leaves the device.
  std::function<void(const Bytes&)> answers;
  /// Changes a report that leaves the device.
  std::function<void(Bytes&)> forge;
  /// How long a report takes.
  hal::Nanoseconds report_time = 20'000;
  /// The device does nothing until this time.
  hal::Nanoseconds stalled_until = 0;
  /// The cable is pulled when so many reports have been sent, and plugged in again after a while.
  std::uint64_t unplug_after = ~std::uint64_t{0};
  hal::Nanoseconds unplugged_for = 30'000'000;

  [[nodiscard]] std::uint64_t sent() const { return counts_[0]; }
  /// Most reports that ever waited for the device.
  [[nodiscard]] std::size_t deepest() const { return deepest_; }
  [[nodiscard]] std::uint64_t overflowed() const { return overflowed_; }
  [[nodiscard]] int unplugs() const { return unplugs_; }

  /// Pulls the cable now.
  void pull() { unplug(); }
  /// Lets time pass without the host doing anything.
  void idle(hal::Nanoseconds time) {
    const hal::Nanoseconds until = clock_->now() + time;
    while (clock_->now() < until) step();
  }

 private:
  static constexpr std::size_t device_queue = 32;
  static constexpr std::size_t host_queue = 64;

  hal::Status do_send(std::span<const std::uint8_t> report) noexcept override {
    if (!plugged_) return {hal::Error::disconnected, hal::Part::panel};
    if (counts_[0] >= unplug_after) {
      unplug();
      return {hal::Error::disconnected, hal::Part::panel};
    }
    carry(Direction::to_device, Bytes(report.begin(), report.end()));
    step();
    return {};
  }

  hal::hid::Received do_receive(std::span<std::uint8_t> report, hal::Nanoseconds patience) noexcept override {
    const hal::Nanoseconds until = clock_->now() + patience;
    for (;;) {
      if (!plugged_) return {{hal::Error::disconnected, hal::Part::panel}, 0};
      serve();
      if (!in_.empty()) {
        const Bytes bytes = in_.front();
        in_.pop_front();
        const std::size_t size = std::min(bytes.size(), report.size());
        std::copy_n(bytes.begin(), size, report.begin());
        return {{}, size};
      }
      if (clock_->now() >= until) return {{hal::Error::timeout, hal::Part::bus}, 0};
      step();
    }
  }

  hal::Status do_reopen() noexcept override {
    if (!plugged_ && clock_->now() >= plugged_again_) plugged_ = true;
    if (!plugged_) return {hal::Error::disconnected, hal::Part::panel};
    return {};
  }

  void unplug() {
    ++unplugs_;
    plugged_ = false;
    plugged_again_ = clock_->now() + unplugged_for;
    unplug_after = ~std::uint64_t{0};
    out_.clear();
    in_.clear();
    late_[0].reset();
    late_[1].reset();
    device_->unplugged();
  }

  void step() {
    clock_->advance(report_time);
    serve();
  }

  void serve() {
    if (clock_->now() < stalled_until) return;
    device_->poll();
    while (device_->ready() && !out_.empty()) {
      if (witness) witness(out_.front());
      device_->receive(out_.front());
      out_.pop_front();
      device_->poll();
    }
    Bytes report(device_->report_bytes());
    while (plugged_ && device_->next(report) != 0) {
      if (answers) answers(report);
      if (forge) forge(report);
      carry(Direction::to_host, report);
    }
  }

  void carry(Direction direction, const Bytes& report) {
    const auto way = static_cast<std::size_t>(direction);
    const Fate f = fate ? fate(direction, counts_[way]) : Fate::arrives;
    ++counts_[way];
    Bytes copy = report;
    switch (f) {
      case Fate::lost:
        break;
      case Fate::late:
        if (late_[way]) put(direction, *late_[way]);
        late_[way] = copy;
        return;
      case Fate::doubled:
        put(direction, copy);
        put(direction, copy);
        break;
      case Fate::garbled:
        copy[counts_[way] * 7U % copy.size()] ^= static_cast<std::uint8_t>(1U << counts_[way] % 8U);
        put(direction, copy);
        break;
      case Fate::arrives:
        put(direction, copy);
        break;
    }
    if (late_[way]) {
      put(direction, *late_[way]);
      late_[way].reset();
    }
  }

  void put(Direction direction, const Bytes& report) {
    auto& queue = direction == Direction::to_device ? out_ : in_;
    if (queue.size() >= (direction == Direction::to_device ? device_queue : host_queue)) {
      ++overflowed_;
      return;
    }
    queue.push_back(report);
    if (direction == Direction::to_device) deepest_ = std::max(deepest_, queue.size());
  }

  hal::sim::VirtualClock* clock_;
  hal::hid::Device* device_;
  std::deque<Bytes> out_;
  std::deque<Bytes> in_;
  std::optional<Bytes> late_[2];
  std::uint64_t counts_[2] = {0, 0};
  std::size_t deepest_ = 0;
  std::uint64_t overflowed_ = 0;
  bool plugged_ = true;
  int unplugs_ = 0;
  hal::Nanoseconds plugged_again_ = 0;
};

}  // namespace tests::hid
