// SPDX-License-Identifier: MIT
#include <hal/baremetal/pl061.hpp>
#include <hal/baremetal/registers.hpp>

namespace hal::baremetal {

void Pl061Pin::start() noexcept {
  constexpr std::uintptr_t direction = 0x400;
  constexpr std::uintptr_t digital_enable = 0x51C;  // Stellaris only; the plain part ignores it
  set_register_bits(registers_ + direction, 1U << bit_);
  set_register_bits(registers_ + digital_enable, 1U << bit_);
}

Status Pl061Pin::do_set(bool high) noexcept {
  write_register(registers_ + (4U << bit_), high ? 1U << bit_ : 0U);
  return {};
}

}  // namespace hal::baremetal
