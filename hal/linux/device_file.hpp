// SPDX-License-Identifier: MIT
//
// A device behind a file of /dev: held open, and called by its name in all that is said of it.
#pragma once

#include <hal/linux/system.hpp>
#include <hal/linux/trouble.hpp>

#include <string>

namespace hal::linux_io {

class DeviceFile : public File {
 public:
  /// `kind` as "SPI device". Throws DeviceError.
  DeviceFile(System& system, const char* kind, const std::string& path);

  /// "SPI device /dev/spidev0.0"
  [[nodiscard]] const std::string& name() const noexcept { return name_; }

  /// Throws a DeviceError, "NAME: WHAT: TEXT OF ERROR". A file without such a request is no such device.
  [[noreturn]] void refuse(const std::string& what, int error) const;

  /// Remembers what went wrong with a transfer.
  Status note(const char* what, int error, Part part) noexcept {
    return fault_.note(name_, what, error, part);
  }
  /// What was noted last.
  [[nodiscard]] const std::string& fault() const noexcept { return fault_.text(); }

 private:
  std::string kind_;
  std::string name_;
  Fault fault_;
};

}  // namespace hal::linux_io
