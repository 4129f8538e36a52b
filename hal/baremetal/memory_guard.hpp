// SPDX-License-Identifier: MIT
//
// The memory protection unit of Cortex-M (Armv7-M) guarding one piece of memory.
//
// Rule: while the guard is closed a write to the piece is a fault, to be seen at once, and the unit knows the
// address. Everything else stays as it is without the unit, for privileged code has the default map in the
// background.
#pragma once

#include <cstdint>

namespace hal::baremetal {

class MemoryGuard {
 public:
  /// `begin` is a multiple of `bytes`, which is a power of two from 32 on; `registers` is where the unit is.
  constexpr MemoryGuard(std::uintptr_t begin, std::uint32_t bytes,
                        std::uintptr_t registers = 0xE000'ED90) noexcept
      : begin_(begin), bytes_(bytes), registers_(registers) {}

  /// Turns the unit on, the guard open. False if the core has none, or the piece can't be guarded.
  [[nodiscard]] bool start() const noexcept;
  /// From now on the piece may be read only.
  void close() const noexcept { set(true); }
  void open() const noexcept { set(false); }

  /// In a fault handler: true if the fault was a write to the piece while the guard was closed.
  [[nodiscard]] bool caught() const noexcept;

 private:
  void set(bool read_only) const noexcept;

  std::uintptr_t begin_;
  std::uint32_t bytes_;
  std::uintptr_t registers_;
};

}  // namespace hal::baremetal
