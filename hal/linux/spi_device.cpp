// SPDX-License-Identifier: MIT
#include <hal/linux/spi_device.hpp>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <linux/spi/spidev.h>

namespace hal::linux_io {

namespace {

constexpr std::size_t usual_limit = 4096;
constexpr std::size_t least_limit = 16;

std::size_t limit_of(System& system) {
  const std::string text = system.text_of("/sys/module/spidev/parameters/bufsiz");
  std::size_t limit = 0;
  std::from_chars(text.data(), text.data() + text.size(), limit);
  return limit >= least_limit ? limit : usual_limit;
}

}  // namespace

SpiDevice::SpiDevice(const std::string& path, const SpiOptions& options, System& system)
    : file_(system, "SPI device", path), limit_(limit_of(system)) {
  const auto set = [&](unsigned long request, auto value, const std::string& what) {
    if (file_.control(request, value) < 0) file_.refuse(what + " can't be set", errno);
  };
  set(SPI_IOC_WR_MODE, static_cast<std::uint8_t>(options.mode), "mode " + std::to_string(options.mode));
  set(SPI_IOC_WR_BITS_PER_WORD, std::uint8_t{8}, "a word of 8 bits");
  set(SPI_IOC_WR_MAX_SPEED_HZ, options.hertz, std::to_string(options.hertz) + " Hz");
}

Status SpiDevice::do_write(std::span<const std::uint8_t> bytes) noexcept {
  const std::size_t limit_before = limit_;
  while (!bytes.empty()) {
    const std::size_t size = std::min(bytes.size(), limit_);
    const ssize_t written = file_.system().write(file_.number(), bytes.data(), size);
    if (written > 0) {
      // Less than was asked for is no failure: the rest goes next.
      bytes = bytes.subspan(std::min(static_cast<std::size_t>(written), size));
      continue;
    }
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EMSGSIZE && size > least_limit) {
      limit_ = std::max(size / 2U, least_limit);
      continue;
    }
    // If the length wasn't to blame, nothing was learned.
    limit_ = limit_before;
    return file_.note("a transfer failed", written < 0 ? errno : EIO, Part::bus);
  }
  return {};
}

}  // namespace hal::linux_io
