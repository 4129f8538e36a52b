// SPDX-License-Identifier: MIT
//
// The board oled: QEMU's `lm3s6965evb` (Cortex-M3, 256 KiB flash, 64 KiB RAM) with its SSD0323 OLED of
// 128x64 pixels in 16 greys behind SSI 0; data/command is line C7, chip select line D0 (active high in QEMU,
// low on the real board).
//
// The panel tells no VBLANK: SysTick, at a millisecond a tick, is the clock of its 60 frames a second.
// The picture in RAM is what the panel shows: the memory protection unit makes it read-only while no frame is
// begun, so drawing on it is a fault.
// QEMU shows each pixel as 4x4 pixels and grey g of 16 as 17*g in all three colours. UART 0 carries reports.
#pragma once

#include <hal/baremetal/memory_guard.hpp>
#include <hal/baremetal/pl022.hpp>
#include <hal/baremetal/pl061.hpp>
#include <hal/baremetal/text_output.hpp>
#include <hal/panels/command_port.hpp>
#include <hal/panels/ssd0323.hpp>
#include <intaglio/image/format.hpp>

#include <cstdint>
#include <firmware/boards/common/guarded_screen.hpp>

namespace boards::oled {

class Board {
 public:
  using Screen = GuardedScreen<intaglio::image::Indexed4, hal::baremetal::MemoryGuard>;

  Board() noexcept;
  /// Turns on the UART, the guard of the picture, the frame clock and the panel. False if one of them doesn't
  /// start.
  [[nodiscard]] bool start() noexcept;
  [[nodiscard]] Screen screen() noexcept;
  /// The same without the clock: each frame is sent as soon as it is drawn.
  [[nodiscard]] Screen screen_without_clock() noexcept;
  /// Ticks of the frame clock so far.
  [[nodiscard]] std::uint32_t vblanks() noexcept { return panel_.vblank_count(); }
  /// Cycles of the core; wraps.
  [[nodiscard]] static std::uint32_t time() noexcept;
  [[nodiscard]] static hal::baremetal::TextOutput& serial() noexcept;

 private:
  hal::baremetal::Pl022 bus_;
  hal::baremetal::Pl061Pin data_command_;
  hal::baremetal::Pl061Pin chip_select_;
  hal::panels::SpiPort port_;
  hal::panels::Ssd0323 panel_;
  hal::panels::Ssd0323 panel_without_clock_;
  hal::baremetal::MemoryGuard guard_;
};

}  // namespace boards::oled
