// SPDX-License-Identifier: MIT
#include <hal/linux/device_file.hpp>

#include <cerrno>
#include <fcntl.h>

namespace hal::linux_io {

namespace {

int open_device(System& system, const char* kind, const std::string& path) {
  const int file = system.open(path.c_str(), O_RDWR);
  if (file < 0) throw DeviceError(cannot_open(path, kind, errno));
  return file;
}

}  // namespace

DeviceFile::DeviceFile(System& system, const char* kind, const std::string& path)
    : File(system, open_device(system, kind, path)), kind_(kind), name_(kind_ + ' ' + path) {}

void DeviceFile::refuse(const std::string& what, int error) const {
  throw DeviceError(name_ + (error == ENOTTY ? " is no " + kind_ : ": " + what + ": " + error_text(error)));
}

}  // namespace hal::linux_io
