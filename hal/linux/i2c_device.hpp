// SPDX-License-Identifier: MIT
//
// I2C by the kernel's i2c-dev.
//
// Rule: a write is one transaction if the adapter takes it at once. Else it is several, each begun by the
// whole prefix, which is what control bytes of display controllers want: I2C messages of at most 8192 bytes,
// halved each time that the adapter says it was too much; or, where the adapter knows SMBus alone, block
// writes of 32 bytes, or of one.
#pragma once

#include <hal/bus.hpp>
#include <hal/linux/device_file.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace hal::linux_io {

class I2cDevice final : public I2cBus {
 public:
  /// `path` as "/dev/i2c-1". Throws DeviceError.
  explicit I2cDevice(const std::string& path, System& system = System::kernel());
  [[nodiscard]] const std::string& fault() const noexcept { return fault_; }

 private:
  enum class Way : std::uint8_t { messages, blocks, bytes };

  Status do_write(std::uint8_t address, std::span<const std::uint8_t> prefix,
                  std::span<const std::uint8_t> bytes) noexcept override;
  /// Sends one transaction: 0, or the error number.
  int send(std::uint8_t address, std::span<const std::uint8_t> prefix, std::span<const std::uint8_t> bytes);
  int send_smbus(std::span<const std::uint8_t> prefix, std::span<const std::uint8_t> bytes);
  Status fail(std::uint8_t address, int error);

  DeviceFile file_;
  Way way_ = Way::messages;
  std::size_t limit_ = 0;
  int address_ = -1;  // That the adapter was told last.
  std::vector<std::uint8_t> message_;
  std::string fault_;
};

}  // namespace hal::linux_io
