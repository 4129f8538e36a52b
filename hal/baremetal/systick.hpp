// SPDX-License-Identifier: MIT
//
// The SysTick timer of Cortex-M as a clock, also the frame clock of boards whose panel tells no VBLANK.
//
// Bit budget: ticks are counted in 64 bits; `period` in nanoseconds times the ticks of 500 years fits 64.
#pragma once

#include <hal/clock.hpp>

#include <cstdint>

namespace hal::baremetal {

class SysTick final : public Clock {
 public:
  /// A tick every `cycles` (2..2^24) cycles of a core clock of `hertz` (1 kHz..1 GHz) whose multiple
  /// `cycles` is; a tick is the resolution of `now`.
  /// `registers` is where the timer is.
  constexpr SysTick(std::uint32_t hertz, std::uint32_t cycles,
                    std::uintptr_t registers = 0xE000'E010) noexcept
      : registers_(registers), cycles_(cycles), tick_length_(std::uint64_t{1'000'000'000} * cycles / hertz) {}

  void start() noexcept;
  /// Cycles since the start, modulo 2^32, to the cycle. For a program whose interrupts aren't masked: a tick
  /// that waits to be counted is missing, and one that is due is waited for.
  [[nodiscard]] std::uint32_t cycles() const noexcept;
  /// The handler of the SysTick exception.
  void on_interrupt() noexcept;

 private:
  Nanoseconds do_now() noexcept override;
  void do_wait_until(Nanoseconds time) noexcept override;

  std::uintptr_t registers_;
  std::uint32_t cycles_;
  Nanoseconds tick_length_;
  // Two words, so the reader must look out for a tick between them; 64-bit atomics would need library calls.
  volatile std::uint32_t ticks_low_ = 0;
  volatile std::uint32_t ticks_high_ = 0;
};

}  // namespace hal::baremetal
