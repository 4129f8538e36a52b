// SPDX-License-Identifier: MIT
//
// The cores that instructions are counted on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace intaglio::number {

/// A core that the accuracy lab counts on, with the options it compiles with (host/lab/cores.py).
enum class Core : std::uint8_t {
  cortex_m0plus,  ///< Also stands for Cortex-M0: no divider, no product of 64 bits.
  cortex_m3,
  cortex_m4,
  cortex_m7,
  arm926,  ///< No divider.
  rv32imac,
  x86_64,
};

inline constexpr std::size_t core_count = 7;

/// What a rung costs: hundredths of an instruction a call on each core, under its family's first load.
struct MeasuredCost {
  std::string_view family;
  std::string_view rung;
  std::array<std::int64_t, core_count> hundredths;
};

// The core this is compiled for, where it was counted; there is no `this_core` elsewhere. Compilers don't say
// whether ARMv7E-M is a Cortex-M4 or M7: M4 stands for both.
#if defined(__ARM_ARCH_6M__)
inline constexpr Core this_core = Core::cortex_m0plus;
#elif defined(__ARM_ARCH_7M__)
inline constexpr Core this_core = Core::cortex_m3;
#elif defined(__ARM_ARCH_7EM__)
inline constexpr Core this_core = Core::cortex_m4;
#elif defined(__ARM_ARCH_5TEJ__)
inline constexpr Core this_core = Core::arm926;
#elif defined(__riscv) && __riscv_xlen == 32
inline constexpr Core this_core = Core::rv32imac;
#elif defined(__x86_64__)
inline constexpr Core this_core = Core::x86_64;
#endif

}  // namespace intaglio::number
