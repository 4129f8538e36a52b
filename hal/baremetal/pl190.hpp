// SPDX-License-Identifier: MIT
//
// Arm PrimeCell PL190 vectored interrupt controller, used unvectored: every source raises IRQ and the board's
// handler asks the drivers.
#pragma once

#include <hal/baremetal/registers.hpp>

#include <cstdint>

namespace hal::baremetal {

class Pl190 {
 public:
  constexpr explicit Pl190(std::uintptr_t registers) noexcept : registers_(registers) {}

  /// Lets source 0..31 raise IRQ.
  void enable(unsigned source) const noexcept {
    constexpr std::uintptr_t interrupt_enable = 0x10;
    write_register(registers_ + interrupt_enable, 1U << (source & 31U));
  }

 private:
  std::uintptr_t registers_;
};

}  // namespace hal::baremetal
