// SPDX-License-Identifier: MIT
//
// Byte buses that display controllers hang on.
#pragma once

#include <hal/status.hpp>

#include <cstdint>
#include <span>

namespace hal {

/// SPI or SSI, write only: the bytes go out most significant bit first and are all out when the call returns.
class SpiBus {
 public:
  SpiBus(const SpiBus&) = delete;
  SpiBus& operator=(const SpiBus&) = delete;

  Status write(std::span<const std::uint8_t> bytes) noexcept {
    return bytes.empty() ? Status{} : do_write(bytes);
  }

 protected:
  constexpr SpiBus() noexcept = default;
  ~SpiBus() = default;

 private:
  virtual Status do_write(std::span<const std::uint8_t> bytes) noexcept = 0;
};

/// I2C, write only: one transaction (start, address, bytes, stop) a call.
class I2cBus {
 public:
  I2cBus(const I2cBus&) = delete;
  I2cBus& operator=(const I2cBus&) = delete;

  /// `address` has 7 bits. `prefix` and `bytes` go out one after the other in the same transaction, so a
  /// control byte needs no copy of the data behind it.
  Status write(std::uint8_t address, std::span<const std::uint8_t> prefix,
               std::span<const std::uint8_t> bytes) noexcept {
    if (address > 0x7F) return {Error::invalid, Part::bus};
    return do_write(address, prefix, bytes);
  }

 protected:
  constexpr I2cBus() noexcept = default;
  ~I2cBus() = default;

 private:
  virtual Status do_write(std::uint8_t address, std::span<const std::uint8_t> prefix,
                          std::span<const std::uint8_t> bytes) noexcept = 0;
};

}  // namespace hal
