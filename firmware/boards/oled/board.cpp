// SPDX-License-Identifier: MIT
#include <hal/baremetal/core.hpp>
#include <hal/baremetal/pl011.hpp>
#include <hal/baremetal/stellaris.hpp>
#include <hal/baremetal/systick.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <firmware/boards/oled/board.hpp>

namespace {

namespace chip = hal::baremetal::stellaris;
using boards::oled::Board;

constexpr int frame_bytes =
    Board::Screen::memory_for({hal::panels::Ssd0323::width, hal::panels::Ssd0323::height});

// Nothing else lies in the memory that is guarded: it fills it.
static_assert(std::has_single_bit(static_cast<unsigned>(frame_bytes)));
alignas(frame_bytes) constinit std::array<std::uint8_t, static_cast<std::size_t>(frame_bytes)> frame{};
constinit hal::baremetal::Pl011 uart{chip::uart_0};
constinit hal::baremetal::SysTick tick{chip::core_hertz, chip::core_hertz / 1000};

}  // namespace

extern "C" void handle_systick() { tick.on_interrupt(); }

namespace {

hal::baremetal::MemoryGuard guard_of_frame() noexcept {
  return {reinterpret_cast<std::uintptr_t>(frame.data()), frame_bytes};
}

}  // namespace

extern "C" void handle_fault() {
  if (guard_of_frame().caught()) {
    uart.text("failed: drawing on the picture on display\n");
  } else {
    uart.text("failed: fault\n");
  }
}

namespace boards::oled {

Board::Board() noexcept
    : bus_(chip::ssi_0),
      data_command_(chip::gpio_c, 7),
      chip_select_(chip::gpio_d, 0),
      port_(bus_, data_command_),
      panel_(port_, &tick),
      panel_without_clock_(port_),
      guard_(guard_of_frame()) {}

bool Board::start() noexcept {
  chip::start();
  uart.start();
  if (!guard_.start()) return false;
  tick.start();
  data_command_.start();
  chip_select_.start();
  bus_.start();
  return chip_select_.set(true).ok() && panel_.start().ok();
}

Board::Screen Board::screen() noexcept { return {panel_, frame, guard_}; }
Board::Screen Board::screen_without_clock() noexcept { return {panel_without_clock_, frame, guard_}; }
std::uint32_t Board::time() noexcept { return tick.cycles(); }
hal::baremetal::TextOutput& Board::serial() noexcept { return uart; }

}  // namespace boards::oled
