// SPDX-License-Identifier: MIT
//
// How reports get to a HID device and back: the seam between what is said to devices and the library, the
// kernel or the test that carries it.
//
// Rule: reports are whole. A device with numbered reports has the number in the first byte, in both
// directions; without numbers the first byte is the report's own.
#pragma once

#include <hal/clock.hpp>
#include <hal/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace hal::hid {

/// What came in.
struct Received {
  Status status;
  std::size_t size = 0;
};

class ReportPort {
 public:
  ReportPort(const ReportPort&) = delete;
  ReportPort& operator=(const ReportPort&) = delete;

  /// Sends an output report. Errors: bus, timeout, disconnected.
  Status send(std::span<const std::uint8_t> report) noexcept { return do_send(report); }
  /// Waits for the next input report, no longer than `patience` (0: only looks). A report that is longer than
  /// `report` is cut. Errors: timeout (nothing came), bus, disconnected.
  [[nodiscard]] Received receive(std::span<std::uint8_t> report, Nanoseconds patience) noexcept {
    return do_receive(report, patience);
  }
  /// Sends a feature report. Errors: bus, unsupported, disconnected.
  Status send_feature(std::span<const std::uint8_t> report) noexcept { return do_send_feature(report); }
  /// Whether the device is still there; takes nothing that it says. Errors: disconnected.
  [[nodiscard]] Status look() noexcept { return do_look(); }
  /// Looks for the same device again after it was disconnected. Errors: disconnected (it isn't there).
  Status reopen() noexcept { return do_reopen(); }

 protected:
  constexpr ReportPort() noexcept = default;
  ~ReportPort() = default;

 private:
  virtual Status do_send(std::span<const std::uint8_t> report) noexcept = 0;
  virtual Received do_receive(std::span<std::uint8_t> report, Nanoseconds patience) noexcept = 0;
  virtual Status do_send_feature(std::span<const std::uint8_t>) noexcept {
    return {Error::unsupported, Part::bus};
  }
  virtual Status do_look() noexcept { return {}; }
  virtual Status do_reopen() noexcept = 0;
};

}  // namespace hal::hid
