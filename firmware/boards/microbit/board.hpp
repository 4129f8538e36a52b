// SPDX-License-Identifier: MIT
//
// The board microbit: QEMU's `microbit` (Cortex-M0, 256 KiB flash, 16 KiB RAM), headless. It draws into RAM
// what the board oled shows, and reports digests on the UART: the smallest core there is, without a divider
// and with 32-bit products only.
#pragma once

#include <hal/baremetal/text_output.hpp>
#include <intaglio/image/format.hpp>

#include <cstdint>
#include <firmware/boards/common/memory_screen.hpp>

namespace boards::microbit {

struct Board {
  using Screen = MemoryScreen<intaglio::image::Indexed4>;

  /// Turns on the UART.
  [[nodiscard]] static bool start() noexcept;
  [[nodiscard]] static Screen screen() noexcept;
  /// There is no display to blank.
  [[nodiscard]] static constexpr std::uint32_t vblanks() noexcept { return 0; }
  [[nodiscard]] static hal::baremetal::TextOutput& serial() noexcept;
};

}  // namespace boards::microbit
