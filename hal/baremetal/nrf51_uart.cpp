// SPDX-License-Identifier: MIT
#include <hal/baremetal/nrf51_uart.hpp>
#include <hal/baremetal/registers.hpp>

namespace hal::baremetal {

namespace {

enum Offset : std::uintptr_t {
  start_transmitter = 0x008,
  byte_is_out = 0x11C,
  enable = 0x500,
  transmit_pin = 0x50C,
  transmit_data = 0x51C,
};

}  // namespace

void Nrf51Uart::start(unsigned pin) noexcept {
  constexpr std::uint32_t enabled = 4;
  write_register(registers_ + transmit_pin, pin);
  write_register(registers_ + enable, enabled);
  write_register(registers_ + start_transmitter, 1);
}

void Nrf51Uart::do_put(char c) noexcept {
  write_register(registers_ + byte_is_out, 0);
  write_register(registers_ + transmit_data, static_cast<unsigned char>(c));
  while (read_register(registers_ + byte_is_out) == 0) {
  }
}

}  // namespace hal::baremetal
