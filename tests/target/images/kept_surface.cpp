// SPDX-License-Identifier: MIT
//
// An image that breaks the rule of the board oled: it keeps the surface of a frame and draws on it when the
// frame has been presented. It proves that the guard of the picture on display is on.
#include <firmware/boards/common/report.hpp>
#include <firmware/boards/oled/board.hpp>

int main() {
  using Board = boards::oled::Board;
  Board board;
  if (!board.start()) boards::report_failure(Board::serial(), {});
  auto screen = board.screen();
  for (std::uint32_t n = 0; n < 3; ++n) {
    auto begun = screen.begin();
    if (!begun.ok()) boards::report_failure(Board::serial(), begun.status());
    const auto kept = begun.value().surface();
    kept.set(5, 7, n & 15U);
    if (const auto s = screen.present(std::move(begun).value()); !s.ok())
      boards::report_failure(Board::serial(), s);
    boards::report_frame(Board::serial(), n, 0);
    if (n == 2) kept.set(5, 7, 15);
  }
  Board::serial().text("done: nobody minded\n");
  for (;;) {
  }
}
