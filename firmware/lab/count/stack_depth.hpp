// SPDX-License-Identifier: MIT
//
// How deep the stack was: the free stack is painted before a call, and looked at afterwards.
//
// Rule: the lowest word that isn't paint any more is the deepest. This sees the compiler's helpers (division)
// and whatever a call reaches through pointers, which -fstack-usage doesn't; it sees only what the load
// reaches.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lab {

/// The stack pointer of whoever inlines this.
[[gnu::always_inline]] inline std::uintptr_t stack_pointer() noexcept {
  std::uintptr_t pointer = 0;
#if defined(__x86_64__)
  asm volatile("mov %%rsp, %0" : "=r"(pointer));
#elif defined(__riscv)
  asm volatile("mv %0, sp" : "=r"(pointer));
#else
  asm volatile("mov %0, sp" : "=r"(pointer));
#endif
  return pointer;
}

class StackDepth {
 public:
  /// As much as is painted. What a call uses beyond isn't seen.
  static constexpr std::uintptr_t most = 16 * 1024;

  /// Paints what lies below the caller.
  [[gnu::noinline, gnu::noclone]] static void paint() noexcept {
    const std::uintptr_t top = stack_pointer() - red_zone;
    for (std::uintptr_t at = top - most; at < top; at += word) *cell(at) = colour;
  }

  /// Bytes used below `caller`, the stack pointer of whoever called paint(), since then.
  [[gnu::noinline, gnu::noclone]] static std::uint32_t since_paint(std::uintptr_t caller) noexcept {
    // paint() began a little below its caller, so its end is left out.
    constexpr std::uintptr_t margin = 256;
    std::uintptr_t at = caller - most + margin;
    while (at < caller && *cell(at) == colour) at += word;
    return static_cast<std::uint32_t>(caller - at);
  }

 private:
  static constexpr std::uintptr_t word = 4;
  static constexpr std::uint32_t colour = 0xA5C3'5A3CU;
  // Below its stack pointer a function may keep things on x86-64.
  static constexpr std::uintptr_t red_zone = sizeof(void*) == 8 ? 128 : 0;

  static volatile std::uint32_t* cell(std::uintptr_t address) noexcept {
    // The stack pointer is a number to begin with.
    return reinterpret_cast<volatile std::uint32_t*>(address);  // NOLINT(performance-no-int-to-ptr)
  }
};

}  // namespace lab
