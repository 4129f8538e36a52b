// SPDX-License-Identifier: MIT
#include <hal/linux/trouble.hpp>

#include <cerrno>
#include <cstring>
#include <grp.h>
#include <sys/stat.h>

namespace hal::linux_io {

namespace {

/// What to do when a device file may not be opened: it depends on the group that the file belongs to.
std::string access_advice(const std::string& path) {
  struct stat about {};
  if (stat(path.c_str(), &about) != 0) return "run as a user who may open it";
  const group* const owner = about.st_gid == 0 ? nullptr : getgrgid(about.st_gid);
  if (owner == nullptr || (about.st_mode & S_IRGRP) == 0 || (about.st_mode & S_IWGRP) == 0)
    return "no group may use it: install hal/linux/70-intaglio.rules in /etc/udev/rules.d, or run as root";
  const std::string name = owner->gr_name;
  return "it belongs to group " + name + ": sudo usermod -aG " + name + " $USER, then log in anew";
}

}  // namespace

std::string error_text(int error) { return std::strerror(error); }

std::string cannot_open(const std::string& path, const std::string& what, int error) {
  const std::string start = what + ' ' + path + ": ";
  switch (error) {
    case EACCES:
    case EPERM:
      return start + "permission denied; " + access_advice(path);
    case ENOENT:
    case ENODEV:
    case ENXIO:
      return start + "there is no such device; is its driver loaded and switched on?";
    case EBUSY:
      return start + "another program or a driver of the kernel is using it";
    default:
      return start + error_text(error);
  }
}

Status status_of(int error, Part part) noexcept {
  switch (error) {
    case ENODEV:
    case ESHUTDOWN:
    case ENOENT:
      return {Error::disconnected, part};
    case ETIMEDOUT:
      return {Error::timeout, part};
    default:
      return {Error::bus, part};
  }
}

Status Fault::note(const std::string& device, const char* what, int error, Part part) noexcept {
  const Status status = status_of(error, part);
  try {
    text_ = device + ": " + what + ": " +
            (status.error() == Error::disconnected ? "the device is gone" : error_text(error));
  } catch (const std::bad_alloc&) {
    return status;
  }
  return status;
}

}  // namespace hal::linux_io
