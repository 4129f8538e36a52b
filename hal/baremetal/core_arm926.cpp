// SPDX-License-Identifier: MIT
//
// ARM926EJ-S: bit 7 of CPSR holds IRQs back; sleep is a CP15 operation, which wakes for one held back.
#include <hal/baremetal/core.hpp>

#include <cstdint>

namespace hal::baremetal {

namespace {
constexpr std::uint32_t irq_masked = 0x80;
}

void mask_interrupts() noexcept {
  std::uint32_t status = 0;
  asm volatile("mrs %0, cpsr\n\torr %0, %0, %1\n\tmsr cpsr_c, %0"
               : "=&r"(status)
               : "i"(irq_masked)
               : "memory");
}

void unmask_interrupts() noexcept {
  std::uint32_t status = 0;
  asm volatile("mrs %0, cpsr\n\tbic %0, %0, %1\n\tmsr cpsr_c, %0"
               : "=&r"(status)
               : "i"(irq_masked)
               : "memory");
}

void wait_for_interrupt() noexcept { asm volatile("mcr p15, 0, %0, c7, c0, 4" ::"r"(0) : "memory"); }
void synchronise() noexcept { asm volatile("" ::: "memory"); }

}  // namespace hal::baremetal
