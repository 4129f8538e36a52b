// SPDX-License-Identifier: MIT
//
// Cortex-M: PRIMASK holds interrupts back, and `wfi` wakes for one that it holds back.
#include <hal/baremetal/core.hpp>

namespace hal::baremetal {

void mask_interrupts() noexcept { asm volatile("cpsid i" ::: "memory"); }
void unmask_interrupts() noexcept { asm volatile("cpsie i" ::: "memory"); }
void wait_for_interrupt() noexcept { asm volatile("wfi" ::: "memory"); }
void synchronise() noexcept { asm volatile("dsb\n\tisb" ::: "memory"); }

}  // namespace hal::baremetal
