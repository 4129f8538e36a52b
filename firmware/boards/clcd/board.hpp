// SPDX-License-Identifier: MIT
//
// The board clcd: QEMU's `versatilepb` (ARM926EJ-S) with its PL110 colour LCD at 320x240, 8 bits a pixel.
//
// Two frame buffers lie in RAM; the VBLANK interrupt puts one of them and its palette on display together.
// Colour depth: the palette holds 5 bits a component, and QEMU shows component & 0xF8 (31 as 248). No
// magnification. UART0 carries reports.
#pragma once

#include <hal/baremetal/text_output.hpp>
#include <hal/panel.hpp>
#include <intaglio/image/format.hpp>
#include <intaglio/present/swap_chain.hpp>

#include <cstdint>

namespace boards::clcd {

struct Board {
  using Screen = intaglio::present::SwapChain<intaglio::image::Indexed8>;

  /// Turns on the UART, the panel and interrupts. False if the panel doesn't start.
  [[nodiscard]] static bool start() noexcept;
  [[nodiscard]] static Screen screen() noexcept;
  [[nodiscard]] static hal::Panel& panel() noexcept;
  /// VBLANKs so far.
  [[nodiscard]] static std::uint32_t vblanks() noexcept;
  /// The board's counter of 24 MHz; wraps.
  [[nodiscard]] static std::uint32_t time() noexcept;
  /// Its value when the latest VBLANK began.
  [[nodiscard]] static std::uint32_t vblank_time() noexcept;
  [[nodiscard]] static hal::baremetal::TextOutput& serial() noexcept;
};

}  // namespace boards::clcd
