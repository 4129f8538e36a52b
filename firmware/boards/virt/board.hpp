// SPDX-License-Identifier: MIT
//
// The board virt: QEMU's RISC-V machine of that name (rv32imac), headless. It draws into RAM and reports
// digests on the UART: the same pictures as clcd shows, from a core of another make.
#pragma once

#include <hal/baremetal/text_output.hpp>
#include <intaglio/image/format.hpp>

#include <cstdint>
#include <firmware/boards/common/memory_screen.hpp>

namespace boards::virt {

struct Board {
  using Screen = MemoryScreen<intaglio::image::Indexed8>;

  [[nodiscard]] static constexpr bool start() noexcept { return true; }
  [[nodiscard]] static Screen screen() noexcept;
  /// There is no display to blank.
  [[nodiscard]] static constexpr std::uint32_t vblanks() noexcept { return 0; }
  [[nodiscard]] static hal::baremetal::TextOutput& serial() noexcept;
};

}  // namespace boards::virt
