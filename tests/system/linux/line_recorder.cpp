// SPDX-License-Identifier: MIT
//
// A library loaded before all others (LD_PRELOAD) that writes down what a program does to its GPIO lines and
// SPI bus, below libgpiod: the system calls themselves. The lines are the kernel's all the same; the SPI bus,
// of which the machine has none, is pretended under the name /dev/spidev9.0.
//
// The record, $LINE_RECORD, has a line for each thing in the order in which it happened:
//   at NANOSECONDS       the time of what follows, on the monotonic clock, a millisecond or more later than
//   the last line OFFSET VALUE    an output was driven (only when its value changes, and when it is
//   requested) spi HEX              bytes that went out over SPI event OFFSET         an edge event was read
//   release OFFSET       the line was let go
#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <dlfcn.h>
#include <fcntl.h>
#include <linux/gpio.h>
#include <linux/spi/spidev.h>
#include <mutex>
#include <sys/mman.h>
#include <unistd.h>

namespace {

constexpr int most_files = 1024;
constexpr const char* spi_name = "/dev/spidev9.0";

/// What a file descriptor stands for.
struct File {
  enum class Kind : unsigned char { other, outputs, events, spi } kind = Kind::other;
  unsigned lines = 0;
  std::size_t event_bytes = sizeof(gpioevent_data);
  std::array<unsigned, GPIOHANDLES_MAX> offsets{};
  std::array<int, GPIOHANDLES_MAX> values{};
};

std::mutex lock;
std::array<File, most_files> files;

std::FILE* record() {
  static std::FILE* const file = [] {
    const char* const name = std::getenv("LINE_RECORD");
    std::FILE* const opened = std::fopen(name == nullptr ? "/dev/null" : name, "we");
    if (opened == nullptr) std::abort();
    return opened;
  }();
  return file;
}

/// Says what time it is, if a while has passed.
void tell_time() {
  static long long told = 0;
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  const long long nanoseconds = now.tv_sec * 1'000'000'000LL + now.tv_nsec;
  if (nanoseconds - told < 1'000'000) return;
  told = nanoseconds;
  std::fprintf(record(), "at %lld\n", nanoseconds);
}

template <class F>
F next(const char* name) {
  return reinterpret_cast<F>(dlsym(RTLD_NEXT, name));
}

File* file_of(int fd) { return fd >= 0 && fd < most_files ? &files[static_cast<std::size_t>(fd)] : nullptr; }

void drive(File& file, unsigned index, int value, bool always) {
  if (!always && file.values[index] == value) return;
  file.values[index] = value;
  tell_time();
  std::fprintf(record(), "line %u %d\n", file.offsets[index], value);
}

void opened_outputs(int fd, const unsigned* offsets, unsigned lines, const auto& value_of) {
  File* const file = file_of(fd);
  if (file == nullptr) return;
  *file = {};
  file->kind = File::Kind::outputs;
  file->lines = lines;
  for (unsigned i = 0; i < lines; ++i) {
    file->offsets[i] = offsets[i];
    drive(*file, i, value_of(i), true);
  }
}

void opened_events(int fd, unsigned offset, std::size_t event_bytes) {
  File* const file = file_of(fd);
  if (file == nullptr) return;
  *file = {};
  file->kind = File::Kind::events;
  file->lines = 1;
  file->event_bytes = event_bytes;
  file->offsets[0] = offset;
}

/// Libgpiod 1 speaks the first version of the kernel's interface, libgpiod 2 the second.
void after_gpio(int fd, unsigned long request, void* argument) {
  File* const file = file_of(fd);
  switch (request) {
    case GPIO_GET_LINEHANDLE_IOCTL: {
      const auto& r = *static_cast<gpiohandle_request*>(argument);
      if ((r.flags & GPIOHANDLE_REQUEST_OUTPUT) != 0)
        opened_outputs(r.fd, r.lineoffsets, r.lines, [&](unsigned i) { return r.default_values[i]; });
      break;
    }
    case GPIO_GET_LINEEVENT_IOCTL: {
      const auto& r = *static_cast<gpioevent_request*>(argument);
      opened_events(r.fd, r.lineoffset, sizeof(gpioevent_data));
      break;
    }
    case GPIOHANDLE_SET_LINE_VALUES_IOCTL: {
      const auto& data = *static_cast<gpiohandle_data*>(argument);
      if (file == nullptr || file->kind != File::Kind::outputs) break;
      for (unsigned i = 0; i < file->lines; ++i) drive(*file, i, data.values[i], false);
      break;
    }
    case GPIO_V2_GET_LINE_IOCTL: {
      const auto& r = *static_cast<gpio_v2_line_request*>(argument);
      if ((r.config.flags & GPIO_V2_LINE_FLAG_OUTPUT) != 0) {
        unsigned long long values = 0;
        for (unsigned i = 0; i < r.config.num_attrs; ++i)
          if (r.config.attrs[i].attr.id == GPIO_V2_LINE_ATTR_ID_OUTPUT_VALUES)
            values |= r.config.attrs[i].attr.values & r.config.attrs[i].mask;
        opened_outputs(r.fd, r.offsets, r.num_lines,
                       [&](unsigned i) { return static_cast<int>(values >> i & 1U); });
      } else {
        opened_events(r.fd, r.offsets[0], sizeof(gpio_v2_line_event));
      }
      break;
    }
    case GPIO_V2_LINE_SET_VALUES_IOCTL: {
      const auto& data = *static_cast<gpio_v2_line_values*>(argument);
      if (file == nullptr || file->kind != File::Kind::outputs) break;
      for (unsigned i = 0; i < file->lines; ++i)
        if ((data.mask >> i & 1U) != 0) drive(*file, i, static_cast<int>(data.bits >> i & 1U), false);
      break;
    }
    default:
      break;
  }
}

int spi_bytes(const void* bytes, std::size_t count) {
  tell_time();
  std::fprintf(record(), "spi %zu\n", count);
  std::fwrite(bytes, 1, count, record());
  std::fputc('\n', record());
  return static_cast<int>(count);
}

/// The pretended bus: takes every setting and every message.
int spi_request(unsigned long request, void* argument) {
  if (_IOC_TYPE(request) != SPI_IOC_MAGIC) return -1;
  if (_IOC_NR(request) != 0) {
    if ((_IOC_DIR(request) & _IOC_READ) != 0) std::memset(argument, 0, _IOC_SIZE(request));
    return 0;
  }
  const auto* const transfers = static_cast<spi_ioc_transfer*>(argument);
  const unsigned count = _IOC_SIZE(request) / sizeof(spi_ioc_transfer);
  int sent = 0;
  for (unsigned i = 0; i < count; ++i)
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the kernel's structure keeps pointers as numbers
    sent += spi_bytes(reinterpret_cast<const void*>(transfers[i].tx_buf), transfers[i].len);
  return sent;
}

int open_spi() {
  const int fd = memfd_create("spi", MFD_CLOEXEC);
  if (File* const file = file_of(fd)) *file = {.kind = File::Kind::spi};
  return fd;
}

bool is_spi(const char* name) { return std::strcmp(name, spi_name) == 0; }

}  // namespace

extern "C" {

int open(const char* name, int flags, ...) {
  std::va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  if (is_spi(name)) return open_spi();
  return next<int (*)(const char*, int, ...)>("open")(name, flags, mode);
}

int open64(const char* name, int flags, ...) {
  std::va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  if (is_spi(name)) return open_spi();
  return next<int (*)(const char*, int, ...)>("open64")(name, flags, mode);
}

int ioctl(int fd, unsigned long request, ...) {
  std::va_list arguments;
  va_start(arguments, request);
  void* const argument = va_arg(arguments, void*);
  va_end(arguments);
  if (const File* const file = file_of(fd); file != nullptr && file->kind == File::Kind::spi) {
    const std::lock_guard guard(lock);
    return spi_request(request, argument);
  }
  const int result = next<int (*)(int, unsigned long, ...)>("ioctl")(fd, request, argument);
  if (result >= 0) {
    const std::lock_guard guard(lock);
    after_gpio(fd, request, argument);
  }
  return result;
}

ssize_t read(int fd, void* buffer, std::size_t size) {
  const ssize_t result = next<ssize_t (*)(int, void*, std::size_t)>("read")(fd, buffer, size);
  if (File* const file = file_of(fd); result > 0 && file != nullptr && file->kind == File::Kind::events) {
    const std::lock_guard guard(lock);
    for (ssize_t at = 0; at < result; at += static_cast<ssize_t>(file->event_bytes))
      std::fprintf(record(), "event %u\n", file->offsets[0]);
  }
  return result;
}

ssize_t write(int fd, const void* bytes, std::size_t count) {
  if (const File* const file = file_of(fd); file != nullptr && file->kind == File::Kind::spi) {
    const std::lock_guard guard(lock);
    return spi_bytes(bytes, count);
  }
  return next<ssize_t (*)(int, const void*, std::size_t)>("write")(fd, bytes, count);
}

int close(int fd) {
  if (File* const file = file_of(fd); file != nullptr && file->kind != File::Kind::other) {
    const std::lock_guard guard(lock);
    if (file->kind != File::Kind::spi)
      for (unsigned i = 0; i < file->lines; ++i) std::fprintf(record(), "release %u\n", file->offsets[i]);
    *file = {};
    std::fflush(record());
  }
  return next<int (*)(int)>("close")(fd);
}

}  // extern "C"
