// SPDX-License-Identifier: MIT
//
// A program on a board: the endless animation, and short runs that report digests, or times.
//
// A board is a type with `start()` (false: the hardware doesn't come up), `screen()` (what present::run shows
// frames on), `vblanks()` and, static, `serial()`. It lives on main's stack, for there are no constructors of
// static objects.
#pragma once

#include <hal/baremetal/core.hpp>
#include <intaglio/present/run.hpp>

#include <array>
#include <cstdint>
#include <firmware/boards/common/report.hpp>
#include <limits>
#include <span>
#include <utility>

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

/// A screen that takes the time from the VBLANK at which the frame before appeared until the next was asked
/// for, with interrupts held back, so nothing but the program's work is in it. `Board` has `time()`, a
/// counter that wraps at 2^32, and `vblank_time()`, its value when the latest VBLANK began.
template <class Board>
class TimedScreen {
 public:
  using Screen = typename Board::Screen;
  using Format = typename Screen::Format;

  /// A frame has just appeared.
  TimedScreen(Screen& screen, std::span<std::uint32_t> times) noexcept : screen_(&screen), times_(times) {
    hal::baremetal::mask_interrupts();
  }

  [[nodiscard]] intaglio::Status status() const noexcept { return screen_->status(); }
  [[nodiscard]] intaglio::present::ScreenInfo info() const noexcept { return screen_->info(); }
  [[nodiscard]] auto begin() noexcept { return screen_->begin(); }
  [[nodiscard]] intaglio::Status present(intaglio::present::Frame<Format>&& frame,
                                         std::span<const std::uint8_t> palette) noexcept {
    const intaglio::Status s = screen_->present(std::move(frame), palette);
    if (count_ < times_.size()) times_[count_++] = Board::time() - Board::vblank_time();
    hal::baremetal::unmask_interrupts();
    return s;
  }
  [[nodiscard]] intaglio::Status wait_until_shown() noexcept {
    const intaglio::Status s = screen_->wait_until_shown();
    hal::baremetal::mask_interrupts();
    return s;
  }

 private:
  Screen* screen_;
  std::span<std::uint32_t> times_;
  std::size_t count_ = 0;
};

/// Times each frame's work on a board whose panel tells its VBLANKs.
template <class App, class Board>
intaglio::Status time_work(App& app, Board& /*board*/, typename Board::Screen& screen,
                           std::span<std::uint32_t> times) noexcept {
  TimedScreen<Board> timed(screen, times);
  const intaglio::Status s = intaglio::present::run(app, timed, static_cast<std::uint32_t>(times.size()));
  hal::baremetal::unmask_interrupts();
  return s;
}

/// The same on a write panel: from one frame sent to the next, without the clock that holds frames back. The
/// interrupts of the clock are in it, for they are needed.
template <class App, class Board>
requires requires(Board& board) { board.screen_without_clock(); }
intaglio::Status time_work(App& app, Board& board, typename Board::Screen& /*screen*/,
                           std::span<std::uint32_t> times) noexcept {
  auto screen = board.screen_without_clock();
  std::uint32_t before = Board::time();
  return intaglio::present::run(app, screen, static_cast<std::uint32_t>(times.size()),
                                [&](std::uint32_t frame) {
                                  const std::uint32_t now = Board::time();
                                  times[frame] = now - before;
                                  before = now;
                                });
}

/// Shows `digest_frames` frames twice: first each frame's work is timed, then is counted how many VBLANKs
/// each takes.
template <template <class> class App, class Board>
[[noreturn]] void report_pace() noexcept {
  Board board;
  if (!board.start()) report_failure(Board::serial(), {});
  auto screen = board.screen();
  App<typename decltype(screen)::Format> app(screen.info());
  // Each pass needs a frame ahead of the count, for a frame's time begins when the one before appears.
  intaglio::Status s = intaglio::present::run(app, screen, 1);
  if (!s.ok()) report_failure(Board::serial(), s);
  std::array<std::uint32_t, digest_frames> times{};
  s = time_work(app, board, screen, times);
  if (!s.ok()) report_failure(Board::serial(), s);
  report_work(Board::serial(), times);

  std::array<std::uint16_t, digest_frames> pace{};
  s = intaglio::present::run(app, screen, 1);
  std::uint32_t before = board.vblanks();
  const std::uint32_t missed = screen.missed_deadlines();
  if (s.ok())
    s = intaglio::present::run(app, screen, digest_frames, [&](std::uint32_t frame) {
      const std::uint32_t now = board.vblanks();
      pace[frame] = static_cast<std::uint16_t>(now - before);
      before = now;
    });
  if (!s.ok()) report_failure(Board::serial(), s);
  report_end(Board::serial(), pace, screen.missed_deadlines() - missed);
  hold();
}

}  // namespace boards
