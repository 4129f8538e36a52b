// SPDX-License-Identifier: MIT
//
// Talking to the emulator (or a debugger) instead of a device: text, and the exit code of a test image.
//
// Rule: Arm semihosting, Cortex-M form (`bkpt 0xab`, operation in r0, argument in r1). Without an emulator or
// a debugger that listens the core faults, so only images for tests use this.
#pragma once

#include <cstdint>

namespace boards::semihosting {

namespace detail {

inline std::uint32_t call(std::uint32_t operation, const void* argument) noexcept {
  register std::uint32_t r0 asm("r0") = operation;
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

}  // namespace detail

/// Writes zero-terminated text.
inline void write(const char* text) noexcept { detail::call(0x04, text); }

/// Writes a number in decimal.
inline void write(std::uint32_t value) noexcept {
  char digits[11];
  char* first = digits + 10;
  *first = '\0';
  do {
    *--first = static_cast<char>('0' + value % 10);
    value /= 10;
  } while (value != 0);
  write(first);
}

/// Ends the emulator with this exit code.
[[noreturn]] inline void exit(int code) noexcept {
  constexpr std::uint32_t application_exit = 0x20026;
  const std::uint32_t block[2] = {application_exit, static_cast<std::uint32_t>(code)};
  detail::call(0x20, block);
  while (true) asm volatile("");
}

}  // namespace boards::semihosting
