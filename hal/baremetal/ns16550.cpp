// SPDX-License-Identifier: MIT
#include <hal/baremetal/ns16550.hpp>

namespace hal::baremetal {

namespace {

volatile std::uint8_t* byte_register(std::uintptr_t address) noexcept {
  return reinterpret_cast<volatile std::uint8_t*>(address);  // NOLINT(performance-no-int-to-ptr)
}

}  // namespace

void Ns16550::do_put(char c) noexcept {
  constexpr std::uintptr_t transmit = 0;
  constexpr std::uintptr_t line_status = 5;
  constexpr unsigned transmit_empty = 0x20;
  for (;;) {
    const std::uint8_t status = *byte_register(registers_ + line_status);
    if ((status & transmit_empty) != 0) break;
  }
  *byte_register(registers_ + transmit) = static_cast<std::uint8_t>(c);
}

}  // namespace hal::baremetal
