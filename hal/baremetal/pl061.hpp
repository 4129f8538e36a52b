// SPDX-License-Identifier: MIT
//
// One line of an Arm PrimeCell PL061 GPIO port (also the Stellaris parts') as an output.
//
// Rule: address bits 9:2 of the data register mask the write, so one line changes without reading the others.
#pragma once

#include <hal/pin.hpp>

#include <cstdint>

namespace hal::baremetal {

class Pl061Pin final : public OutputPin {
 public:
  /// Line `bit` (0..7) of the port.
  constexpr Pl061Pin(std::uintptr_t registers, unsigned bit) noexcept
      : registers_(registers), bit_(bit & 7U) {}

  /// Makes the line a digital output. The port's clock must be on already.
  void start() noexcept;

 private:
  Status do_set(bool high) noexcept override;

  std::uintptr_t registers_;
  unsigned bit_;
};

}  // namespace hal::baremetal
