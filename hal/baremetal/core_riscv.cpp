// SPDX-License-Identifier: MIT
//
// RISC-V, machine mode: mstatus.MIE holds interrupts back, and `wfi` wakes for one that it holds back.
#include <hal/baremetal/core.hpp>

namespace hal::baremetal {

void mask_interrupts() noexcept { asm volatile("csrci mstatus, 8" ::: "memory"); }
void unmask_interrupts() noexcept { asm volatile("csrsi mstatus, 8" ::: "memory"); }
void wait_for_interrupt() noexcept { asm volatile("wfi" ::: "memory"); }
void synchronise() noexcept { asm volatile("fence" ::: "memory"); }

}  // namespace hal::baremetal
