// SPDX-License-Identifier: MIT
//
// 16550 UART with byte-wide registers, write only (QEMU's RISC-V board `virt`).
#pragma once

#include <hal/baremetal/text_output.hpp>

#include <cstdint>

namespace hal::baremetal {

class Ns16550 final : public TextOutput {
 public:
  constexpr explicit Ns16550(std::uintptr_t registers) noexcept : registers_(registers) {}

 private:
  void do_put(char c) noexcept override;

  std::uintptr_t registers_;
};

}  // namespace hal::baremetal
