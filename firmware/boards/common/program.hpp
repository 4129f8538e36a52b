// SPDX-License-Identifier: MIT
//
// A program on a board: the endless animation, and the short run that reports digests.
//
// A board is a type with `start()` (false: the hardware doesn't come up), `screen()` (what present::run shows
// frames on), `vblanks()` and, static, `serial()`. It lives on main's stack, for there are no constructors of
// static objects.
#pragma once

#include <hal/baremetal/core.hpp>
#include <intaglio/present/run.hpp>

#include <cstdint>
#include <firmware/boards/common/report.hpp>
#include <limits>

namespace boards {

/// Frames of a digest run.
inline constexpr std::uint32_t digest_frames = 120;

/// Sleeps for ever; interrupts go on, so what is on display stays there.
[[noreturn]] inline void hold() noexcept {
  for (;;) hal::baremetal::wait_for_interrupt();
}

/// Shows frame after frame.
template <template <class> class App, class Board>
[[noreturn]] void animate() noexcept {
  Board board;
  if (!board.start()) report_failure(Board::serial(), {});
  auto screen = board.screen();
  App<typename decltype(screen)::Format> app(screen.info());
  // 2^32 frames last two years at 60 a second; then the animation begins anew.
  for (;;) {
    const intaglio::Status s = intaglio::present::run(app, screen, std::numeric_limits<std::uint32_t>::max());
    if (!s.ok()) report_failure(Board::serial(), s);
  }
}

/// Shows `digest_frames` frames and reports the digest of each; the last one stays on display.
template <template <class> class App, class Board>
[[noreturn]] void report_digests() noexcept {
  Board board;
  if (!board.start()) report_failure(Board::serial(), {});
  auto screen = board.screen();
  App<typename decltype(screen)::Format> app(screen.info());
  std::array<std::uint16_t, digest_frames> pace{};
  std::uint32_t before = board.vblanks();
  const intaglio::Status s =
      intaglio::present::run(app, screen, digest_frames, [&](std::uint32_t frame, std::uint32_t digest) {
        const std::uint32_t now = board.vblanks();
        pace[frame] = static_cast<std::uint16_t>(now - before);
        before = now;
        report_frame(Board::serial(), frame, digest);
      });
  if (!s.ok()) report_failure(Board::serial(), s);
  report_end(Board::serial(), pace, screen.missed_deadlines());
  hold();
}

}  // namespace boards
