// SPDX-License-Identifier: MIT
//
// The hidapi of the tests: a USB bus that isn't there, with whatever models plugged in.
#pragma once

#include <hal/hid/host/report_port.hpp>

#include <climits>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace fake_hidapi {

struct Device {
  std::string path;
  std::uint16_t vendor = 0;
  std::uint16_t product_number = 0;
  std::wstring serial{};
  std::wstring product{};
  std::uint16_t usage_page = 0xFF00;
  std::uint16_t usage = 1;
  /// Its reports begin with a number; otherwise the first byte that is written is 0 and isn't sent.
  bool numbered = false;
  hal::hid::ReportPort* model = nullptr;
  /// This user may not open it.
  bool locked = false;
};

struct Bus {
  std::vector<Device> devices;
  /// Reports that are written before the cable of the device that they are for is pulled.
  int writes_left = INT_MAX;
  /// Called each time that somebody looks for devices.
  std::function<void()> on_look = [] {};
  /// Handles that are open.
  int open = 0;

  void unplug(const std::string& path);
};

Bus& bus();
void reset();

}  // namespace fake_hidapi
