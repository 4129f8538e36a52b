// SPDX-License-Identifier: MIT
//
// Arm PrimeCell PL022 synchronous serial port as an SPI bus: 8 bits a frame, mode 3 (clock idles high, data
// taken on the rising edge), half the module clock.
#pragma once

#include <hal/bus.hpp>

#include <cstdint>

namespace hal::baremetal {

class Pl022 final : public SpiBus {
 public:
  constexpr explicit Pl022(std::uintptr_t registers) noexcept : registers_(registers) {}

  /// Turns the port on as a master. Clocks and pins must be on already.
  void start() noexcept;

 private:
  Status do_write(std::span<const std::uint8_t> bytes) noexcept override;
  void drain() noexcept;

  std::uintptr_t registers_;
};

}  // namespace hal::baremetal
