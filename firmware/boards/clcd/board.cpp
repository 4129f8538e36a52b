// SPDX-License-Identifier: MIT
#include <hal/baremetal/core.hpp>
#include <hal/baremetal/pl011.hpp>
#include <hal/baremetal/pl110.hpp>
#include <hal/baremetal/pl190.hpp>
#include <hal/baremetal/registers.hpp>
#include <hal/swap_protocol.hpp>

#include <array>
#include <firmware/boards/clcd/board.hpp>

namespace {

using hal::baremetal::Pl110;

constexpr Pl110::Geometry geometry{320, 240, boards::clcd::Board::Screen::Format::bits};
constexpr unsigned lcd_interrupt = 16;
constexpr std::uintptr_t counter_24_mhz = 0x1000'005C;

alignas(16) constinit std::array<std::uint8_t, Pl110::memory_bytes(geometry)> frame_buffers{};
constinit Pl110 lcd{0x1012'0000, geometry, frame_buffers};
constinit hal::baremetal::Pl011 uart{0x101F'1000};
constinit hal::InterruptCell<std::uint32_t> latest_vblank{0};
constexpr hal::baremetal::Pl190 interrupt_controller{0x1014'0000};

}  // namespace

extern "C" void handle_irq() {
  latest_vblank.store(boards::clcd::Board::time());
  lcd.on_interrupt();
}
extern "C" void handle_fault() { uart.text("failed: fault\n"); }

namespace boards::clcd {

bool Board::start() noexcept {
  uart.start();
  if (!lcd.start().ok()) return false;
  interrupt_controller.enable(lcd_interrupt);
  hal::baremetal::unmask_interrupts();
  return true;
}

Board::Screen Board::screen() noexcept { return Screen(lcd); }
hal::Panel& Board::panel() noexcept { return lcd; }
std::uint32_t Board::vblanks() noexcept { return lcd.vblank_count(); }
std::uint32_t Board::time() noexcept { return hal::baremetal::read_register(counter_24_mhz); }
std::uint32_t Board::vblank_time() noexcept { return latest_vblank.load(); }
hal::baremetal::TextOutput& Board::serial() noexcept { return uart; }

}  // namespace boards::clcd
