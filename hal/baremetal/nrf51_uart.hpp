// SPDX-License-Identifier: MIT
//
// The UART of the nRF51, write only. Line speed is left as it is after reset: QEMU has none.
#pragma once

#include <hal/baremetal/text_output.hpp>

#include <cstdint>

namespace hal::baremetal {

class Nrf51Uart final : public TextOutput {
 public:
  constexpr explicit Nrf51Uart(std::uintptr_t registers) noexcept : registers_(registers) {}

  /// Turns the transmitter on, its output on this pin of port 0.
  void start(unsigned pin) noexcept;

 private:
  void do_put(char c) noexcept override;

  std::uintptr_t registers_;
};

}  // namespace hal::baremetal
