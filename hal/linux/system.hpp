// SPDX-License-Identifier: MIT
//
// The calls of the kernel that drivers of device files make, as an object, so that tests can stand in for the
// kernel and its clock.
//
// Rule: each call is the system call of its name: -1 and `errno` on failure, nothing retried.
#pragma once

#include <hal/clock.hpp>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <poll.h>
#include <string>
#include <sys/types.h>

namespace hal::linux_io {

class System {
 public:
  System() = default;
  System(const System&) = delete;
  System& operator=(const System&) = delete;
  virtual ~System() = default;

  virtual int open(const char* path, int flags);
  virtual int close(int file);
  virtual int ioctl(int file, unsigned long request, void* argument);
  /// The same of requests that take a number.
  virtual int ioctl_number(int file, unsigned long request, unsigned long number);
  virtual ssize_t read(int file, void* bytes, std::size_t size);
  virtual ssize_t write(int file, const void* bytes, std::size_t size);
  virtual int poll(pollfd* files, unsigned count, int milliseconds);
  /// Memory of a device, shared, for reading and writing; null on failure.
  virtual void* map(int file, std::size_t size, std::uint64_t offset);
  virtual void unmap(void* memory, std::size_t size);
  /// What a small file (of /sys) holds, "" if it can't be read.
  virtual std::string text_of(const std::string& path);
  /// CLOCK_MONOTONIC.
  virtual Clock& clock();

  /// The kernel itself.
  static System& kernel();
};

/// An open device file, closed on every way out.
class File {
 public:
  /// Takes an open file, or -1.
  File(System& system, int number) : system_(&system), number_(number) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (number_ >= 0) system_->close(number_);
  }
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] System& system() const { return *system_; }
  /// `ioctl` with any structure, begun again after a signal.
  template <class T>
  int control(unsigned long request, T& argument) const {
    for (;;)
      if (const int done = system_->ioctl(number_, request, &argument); done >= 0 || errno != EINTR)
        return done;
  }

 private:
  System* system_;
  int number_;
};

}  // namespace hal::linux_io
