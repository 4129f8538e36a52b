// SPDX-License-Identifier: MIT
//
// A keyboard's display, modelled from what the device does with a report, not from the driver.
#pragma once

#include <hal/hid/host/report_port.hpp>
#include <tests/hal/hid/cable.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

namespace tests::hid {

using Bytes = std::vector<std::uint8_t>;

/// Shows the reports that it is sent; a test presses its keys.
class Keyboard final : public hal::hid::ReportPort {
 public:
  std::deque<Bytes> said;
  Cable cable;
  int reports = 0;
  Bytes glass = Bytes(992, 0xAA);

  /// 1 where a pixel is dark: byte 32 + x + 160 * (y / 8), bit y % 8.
  [[nodiscard]] int pixel(int x, int y) const {
    return glass[static_cast<std::size_t>(32 + x + 160 * (y / 8))] >> (y % 8) & 1;
  }

 private:
  hal::Status do_send(std::span<const std::uint8_t> report) noexcept override {
    if (!cable.carries()) return {hal::Error::disconnected, hal::Part::panel};
    ++reports;
    EXPECT_EQ(report.size(), 992U);
    EXPECT_EQ(report[0], 3);
    for (std::size_t i = 1; i < 32; ++i) EXPECT_EQ(report[i], 0);
    glass.assign(report.begin(), report.end());
    return {};
  }
  hal::hid::Received do_receive(std::span<std::uint8_t> report, hal::Nanoseconds) noexcept override {
    if (!cable.plugged()) return {{hal::Error::disconnected, hal::Part::panel}, 0};
    if (said.empty()) return {{hal::Error::timeout, hal::Part::bus}, 0};
    const Bytes bytes = said.front();
    said.pop_front();
    std::copy_n(bytes.begin(), std::min(bytes.size(), report.size()), report.begin());
    return {{}, std::min(bytes.size(), report.size())};
  }
  hal::Status do_look() noexcept override { return cable.status(); }
  hal::Status do_reopen() noexcept override { return cable.look(); }
};

}  // namespace tests::hid
