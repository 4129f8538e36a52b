// SPDX-License-Identifier: MIT
//
// The kinds of real panels, a source file each: an entry of a table in attach.cpp.
#pragma once

#include <host/attach/attach.hpp>

#include <string_view>

namespace host {

struct Backend {
  /// A controller's name, "st7789", or a scheme, "kms:".
  std::string_view name;
  std::string_view description;
  /// Throws Failure or hal::linux_io::DeviceError, or anything else that derives from std::exception.
  std::unique_ptr<AttachedPanel> (*attach)(const AttachOptions& options);
};

/// attach_spi.cpp: controllers on wires of their own.
[[nodiscard]] std::vector<Backend> wired_backends();
/// SPI and I2C buses and GPIO chips.
[[nodiscard]] std::vector<std::string> list_wires();

std::unique_ptr<AttachedPanel> attach_hid(const AttachOptions& options);
[[nodiscard]] std::vector<std::string> list_hid();
std::unique_ptr<AttachedPanel> attach_kms(const AttachOptions& options);
[[nodiscard]] std::vector<std::string> list_kms();
std::unique_ptr<AttachedPanel> attach_fb(const AttachOptions& options);
[[nodiscard]] std::vector<std::string> list_fb();

/// Files of a folder whose names begin so, in order.
[[nodiscard]] std::vector<std::string> files_of(const std::string& folder, const std::string& beginning);

/// A device and the size of the picture on it: "/dev/fb0@320x240".
struct ScreenName {
  std::string device;
  int width = 0;  ///< 0: as large as the device.
  int height = 0;
};
/// Throws Failure.
[[nodiscard]] ScreenName screen_of(const AttachOptions& options);

/// What follows the scheme in `options.panel`: "/dev/fb0" of "fb:/dev/fb0".
[[nodiscard]] std::string device_of(const AttachOptions& options);

}  // namespace host
