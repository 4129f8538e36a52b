// SPDX-License-Identifier: MIT
//
// Counts instructions from inside the guest, exactly.
//
// Rule: run with `-icount shift=10,sleep=off`, where QEMU lets every instruction take 1024 ns of virtual
// time. CMSDK timer 0 counts down at 25 MHz of the same time, so n instructions are n * 25.6 ticks, give or
// take one, and the nearest n is the number executed. The counter wraps after 167 million instructions.
#pragma once

#include <cstdint>

namespace boards::mps2 {

class InstructionCounter {
 public:
  InstructionCounter() noexcept {
    at(reload) = 0xFFFF'FFFF;
    at(value) = 0xFFFF'FFFF;
    at(control) = 1;
  }

  /// Instructions that `run()` executes, plus a constant for the call and for reading the timer.
  template <class Run>
  [[nodiscard]] std::uint32_t measure(Run&& run) const noexcept {
    const std::uint32_t before = at(value);
    run();
    const std::uint32_t after = at(value);
    // n = ticks / 25.6, rounded to the nearest.
    return static_cast<std::uint32_t>((std::uint64_t{before - after} * 10 + 128) / 256);
  }

 private:
  static constexpr std::uintptr_t control = 0x4000'0000;
  static constexpr std::uintptr_t value = 0x4000'0004;
  static constexpr std::uintptr_t reload = 0x4000'0008;

  static volatile std::uint32_t& at(std::uintptr_t address) noexcept {
    return *reinterpret_cast<volatile std::uint32_t*>(address);
  }
};

}  // namespace boards::mps2
