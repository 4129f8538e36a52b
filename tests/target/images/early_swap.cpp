// SPDX-License-Identifier: MIT
//
// An image that breaks the rule of the board clcd: it writes the LCD controller's base address as soon as a
// frame is drawn instead of leaving that to the VBLANK interrupt. It proves that the test of the rule can
// fail.
#include <hal/baremetal/registers.hpp>

#include <cstdint>
#include <firmware/boards/clcd/board.hpp>
#include <firmware/boards/common/report.hpp>

namespace {

constexpr std::uintptr_t lcd_base_address = 0x1012'0010;

}  // namespace

int main() {
  using Board = boards::clcd::Board;
  Board board;
  if (!board.start()) boards::report_failure(Board::serial(), {});
  hal::Panel& panel = board.panel();
  for (int back = 1;; back ^= 1) {
    const auto memory = reinterpret_cast<std::uintptr_t>(panel.buffer(back).data());
    hal::baremetal::write_register(lcd_base_address, static_cast<std::uint32_t>(memory));
    if (!panel.wait_for_vblank().ok()) boards::report_failure(Board::serial(), {});
  }
}
