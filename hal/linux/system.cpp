// SPDX-License-Identifier: MIT
#include <hal/linux/monotonic_clock.hpp>
#include <hal/linux/system.hpp>

#include <fcntl.h>
#include <fstream>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace hal::linux_io {

int System::open(const char* path, int flags) { return ::open(path, flags | O_CLOEXEC); }
int System::close(int file) { return ::close(file); }
int System::ioctl(int file, unsigned long request, void* argument) {
  return ::ioctl(file, request, argument);
}
int System::ioctl_number(int file, unsigned long request, unsigned long number) {
  return ::ioctl(file, request, number);
}
ssize_t System::read(int file, void* bytes, std::size_t size) { return ::read(file, bytes, size); }
ssize_t System::write(int file, const void* bytes, std::size_t size) { return ::write(file, bytes, size); }
int System::poll(pollfd* files, unsigned count, int milliseconds) {
  return ::poll(files, count, milliseconds);
}

void* System::map(int file, std::size_t size, std::uint64_t offset) {
  // Graphics drivers give offsets beyond 4 GiB to programs of 32 bits, too.
  static_assert(sizeof(off_t) == sizeof offset, "build with _FILE_OFFSET_BITS=64");
  void* const memory =
      ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, static_cast<off_t>(offset));
  return memory == MAP_FAILED ? nullptr : memory;
}

void System::unmap(void* memory, std::size_t size) { ::munmap(memory, size); }

std::string System::text_of(const std::string& path) {
  std::ifstream file(path);
  std::string text;
  std::getline(file, text);
  return text;
}

Clock& System::clock() {
  static MonotonicClock clock;
  return clock;
}

System& System::kernel() {
  static System system;
  return system;
}

}  // namespace hal::linux_io
