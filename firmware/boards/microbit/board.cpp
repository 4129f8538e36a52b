// SPDX-License-Identifier: MIT
#include <hal/baremetal/nrf51_uart.hpp>

#include <array>
#include <cstddef>
#include <firmware/boards/microbit/board.hpp>

namespace {

constexpr intaglio::linear::Size size{128, 64};
constexpr unsigned serial_pin = 24;

/// 0, 17, 34 … 255, as the OLED's.
constexpr auto greys = [] {
  std::array<std::uint8_t, 48> colours{};
  for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = static_cast<std::uint8_t>(i / 3 * 17);
  return colours;
}();

constinit std::array<std::uint8_t, static_cast<std::size_t>(size.width / 2 * size.height)> frame{};
constinit hal::baremetal::Nrf51Uart uart{0x4000'2000};

}  // namespace

extern "C" void handle_fault() { uart.text("failed: fault\n"); }

namespace boards::microbit {

bool Board::start() noexcept {
  uart.start(serial_pin);
  return true;
}

Board::Screen Board::screen() noexcept { return {frame, {size, 0, greys}}; }
hal::baremetal::TextOutput& Board::serial() noexcept { return uart; }

}  // namespace boards::microbit
