// SPDX-License-Identifier: MIT
//
// SPI by the kernel's spidev.
//
// Rule: what is written goes out in order, cut into transfers that the driver takes at once: at most `bufsiz`
// bytes as /sys/module/spidev says, and half as many each time the driver says that it was too much. Between
// two transfers the select line may go up, which display controllers don't mind.
#pragma once

#include <hal/bus.hpp>
#include <hal/linux/device_file.hpp>

#include <cstdint>
#include <string>

namespace hal::linux_io {

struct SpiOptions {
  std::uint32_t hertz = 10'000'000;
  int mode = 0;  ///< 0..3: polarity and phase of the clock.
};

class SpiDevice final : public SpiBus {
 public:
  /// `path` as "/dev/spidev0.0". Throws DeviceError.
  explicit SpiDevice(const std::string& path, const SpiOptions& options = {},
                     System& system = System::kernel());
  [[nodiscard]] const std::string& fault() const noexcept { return file_.fault(); }
  /// Bytes that go out in one transfer.
  [[nodiscard]] std::size_t transfer_limit() const noexcept { return limit_; }

 private:
  Status do_write(std::span<const std::uint8_t> bytes) noexcept override;

  DeviceFile file_;
  std::size_t limit_;
};

}  // namespace hal::linux_io
