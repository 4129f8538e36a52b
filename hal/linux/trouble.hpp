// SPDX-License-Identifier: MIT
//
// What goes wrong with a device, in words that name the device and say what to do.
#pragma once

#include <hal/status.hpp>

#include <stdexcept>
#include <string>

namespace hal::linux_io {

/// A device that can't be set up. The text is the whole message.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The kernel's words for an error number.
[[nodiscard]] std::string error_text(int error);

/// Why a device file couldn't be opened and what to do about it. `what` names its kind, "SPI device".
[[nodiscard]] std::string cannot_open(const std::string& path, const std::string& what, int error);

/// The status of a transfer that failed with this error number.
[[nodiscard]] Status status_of(int error, Part part) noexcept;

/// The last thing that went wrong with a device after it was set up; transfers can't throw.
class Fault {
 public:
  /// "DEVICE: WHAT: TEXT OF ERROR", and the status that goes with it. Out of memory it keeps what it had.
  Status note(const std::string& device, const char* what, int error, Part part) noexcept;
  [[nodiscard]] const std::string& text() const noexcept { return text_; }

 private:
  std::string text_;
};

}  // namespace hal::linux_io
