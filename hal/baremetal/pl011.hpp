// SPDX-License-Identifier: MIT
//
// Arm PrimeCell PL011 UART, write only, for the reports of test images. Line speed is left as it is after
// reset: QEMU has none, and a real board's loader has set it.
#pragma once

#include <hal/baremetal/text_output.hpp>

#include <cstdint>

namespace hal::baremetal {

class Pl011 final : public TextOutput {
 public:
  constexpr explicit Pl011(std::uintptr_t registers) noexcept : registers_(registers) {}

  /// Turns the transmitter on. Clocks and pins must be on already.
  void start() noexcept;

 private:
  void do_put(char c) noexcept override;

  std::uintptr_t registers_;
};

}  // namespace hal::baremetal
