// SPDX-License-Identifier: MIT
//
// Stellaris LM3S6965: which modules have a clock, and which pins a module drives.
#pragma once

#include <hal/baremetal/registers.hpp>

#include <cstdint>

namespace hal::baremetal::stellaris {

inline constexpr std::uintptr_t gpio_a = 0x4000'4000;
inline constexpr std::uintptr_t gpio_c = 0x4000'6000;
inline constexpr std::uintptr_t gpio_d = 0x4000'7000;
inline constexpr std::uintptr_t ssi_0 = 0x4000'8000;
inline constexpr std::uintptr_t uart_0 = 0x4000'C000;

/// The core clock after reset.
inline constexpr std::uint32_t core_hertz = 12'500'000;

/// Gives UART 0, SSI 0 and the ports A, C and D their clocks, and UART 0 and SSI 0 their pins on port A.
inline void start() noexcept {
  constexpr std::uintptr_t clock_gates_1 = 0x400F'E104;
  constexpr std::uintptr_t clock_gates_2 = 0x400F'E108;
  constexpr std::uint32_t uart_and_ssi = 1U << 0U | 1U << 4U;
  constexpr std::uint32_t ports_a_c_d = 1U << 0U | 1U << 2U | 1U << 3U;
  set_register_bits(clock_gates_1, uart_and_ssi);
  set_register_bits(clock_gates_2, ports_a_c_d);
  // A module may be touched three cycles after its clock came on; reading the gate back takes that long.
  static_cast<void>(read_register(clock_gates_2));

  constexpr std::uintptr_t alternate_function = 0x420;
  constexpr std::uintptr_t digital_enable = 0x51C;
  constexpr std::uint32_t uart_pins = 1U << 0U | 1U << 1U;
  constexpr std::uint32_t ssi_pins = 1U << 2U | 1U << 3U | 1U << 5U;  // clock, frame, transmit
  set_register_bits(gpio_a + alternate_function, uart_pins | ssi_pins);
  set_register_bits(gpio_a + digital_enable, uart_pins | ssi_pins);
}

}  // namespace hal::baremetal::stellaris
