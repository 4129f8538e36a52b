// SPDX-License-Identifier: MIT
//
// The cable of a device that isn't there: a test says when it is pulled and when it is plugged in again.
#pragma once

#include <hal/status.hpp>

#include <climits>

#include <functional>

namespace tests::hid {

class Cable {
 public:
  static constexpr int never = INT_MAX;
  /// Reports that it carries to the device before it is pulled.
  int reports_left = never;
  /// Looks for the device before it is back.
  int looks_left = 2;
  /// Called when it is back.
  std::function<void()> on_return;
  int pulls = 0;

  void pull() {
    plugged_ = false;
    ++pulls;
    reports_left = never;
  }
  [[nodiscard]] bool plugged() const { return plugged_; }
  [[nodiscard]] hal::Status status() const {
    return plugged_ ? hal::Status{} : hal::Status{hal::Error::disconnected, hal::Part::panel};
  }
  /// A report is on its way.
  bool carries() {
    if (plugged_ && reports_left != never && reports_left-- == 0) pull();
    return plugged_;
  }
  /// The host looks for the device.
  hal::Status look() {
    if (!plugged_ && looks_left != never && looks_left-- == 0) {
      plugged_ = true;
      if (on_return) on_return();
    }
    return status();
  }

 private:
  bool plugged_ = true;
};

}  // namespace tests::hid
