// SPDX-License-Identifier: MIT
//
// What a driver needs of the processor core: to sleep until an interrupt has done something.
//
// One of core_cortex_m.cpp, core_arm926.cpp and core_riscv.cpp is linked in; a test on the desk brings its
// own and runs the handler when the driver goes to sleep.
#pragma once

namespace hal::baremetal {

/// Interrupts wait until `unmask_interrupts`. Doesn't nest.
void mask_interrupts() noexcept;
void unmask_interrupts() noexcept;
/// Sleeps until an interrupt wants to be taken, masked or not; returns at once if one already does.
void wait_for_interrupt() noexcept;
/// What was written to registers of the core itself is in force for all that follows.
void synchronise() noexcept;

/// The core that is linked in, as a type.
struct ThisCore {
  static void mask() noexcept { mask_interrupts(); }
  static void unmask() noexcept { unmask_interrupts(); }
  /// `done` is what is waited for; a core of a test may want to know.
  template <class Done>
  static void wait(const Done& /*done*/) noexcept {
    wait_for_interrupt();
  }
};

/// Sleeps until `done()` is true; an interrupt handler makes it so.
/// Rule: the test and the sleep are one step with interrupts masked, so an interrupt that comes between them
/// can't be slept through.
template <class Core = ThisCore, class Done>
void sleep_until(const Done& done) noexcept {
  for (;;) {
    Core::mask();
    const bool ready = done();
    if (!ready) Core::wait(done);
    Core::unmask();
    if (ready) return;
  }
}

}  // namespace hal::baremetal
