// SPDX-License-Identifier: MIT
//
// Access to 32-bit device registers.
//
// Rule: a register is read and written by a call that returns or takes a value. A function that returned a
// `volatile&` would invite `(void)reg(address)`, which reads nothing in C++ and leaves a FIFO undrained.
#pragma once

#include <cstdint>

namespace hal::baremetal {

[[nodiscard]] inline std::uint32_t read_register(std::uintptr_t address) noexcept {
  return *reinterpret_cast<const volatile std::uint32_t*>(address);  // NOLINT(performance-no-int-to-ptr)
}

inline void write_register(std::uintptr_t address, std::uint32_t value) noexcept {
  *reinterpret_cast<volatile std::uint32_t*>(address) = value;  // NOLINT(performance-no-int-to-ptr)
}

inline void set_register_bits(std::uintptr_t address, std::uint32_t bits) noexcept {
  write_register(address, read_register(address) | bits);
}

}  // namespace hal::baremetal
