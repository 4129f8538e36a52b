// SPDX-License-Identifier: MIT
#include <hal/baremetal/pl011.hpp>
#include <hal/baremetal/registers.hpp>

namespace hal::baremetal {

void Pl011::start() noexcept {
  constexpr std::uintptr_t control = 0x30;
  constexpr std::uint32_t enable = 0x301;  // UART, transmitter, receiver
  write_register(registers_ + control, enable);
}

void Pl011::do_put(char c) noexcept {
  constexpr std::uintptr_t data = 0x00;
  constexpr std::uintptr_t flags = 0x18;
  constexpr std::uint32_t transmit_full = 0x20;
  while ((read_register(registers_ + flags) & transmit_full) != 0) {
  }
  write_register(registers_ + data, static_cast<unsigned char>(c));
}

}  // namespace hal::baremetal
