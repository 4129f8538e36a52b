// SPDX-License-Identifier: MIT
//
// A clock that moves only when it is told to, so simulated time has nothing to do with the speed of the desk.
//
// Rule: whoever listens is told before time moves, and sees the memory of the program as it was during the
// whole interval, because a program changes memory only between two moves.
#pragma once

#include <hal/clock.hpp>

#include <algorithm>
#include <vector>

namespace hal::sim {

class VirtualClock final : public Clock {
 public:
  /// A device whose state depends on the time.
  class Listener {
   public:
    virtual ~Listener() = default;
    /// Time is about to move to `time`: do what happens until then, that moment included. Must not move the
    /// clock itself.
    virtual void before_time_moves(Nanoseconds time) = 0;
  };

  VirtualClock() = default;

  /// Moves time on.
  void advance(Nanoseconds by) { wait_until(now_ + by); }

  /// The listener must be detached before it dies.
  void attach(Listener& listener) { listeners_.push_back(&listener); }
  void detach(Listener& listener) { std::erase(listeners_, &listener); }

 private:
  Nanoseconds do_now() noexcept override { return now_; }
  void do_wait_until(Nanoseconds time) noexcept override {
    if (time <= now_) return;
    for (Listener* const listener : listeners_) listener->before_time_moves(time);
    now_ = time;
  }

  Nanoseconds now_ = 0;
  std::vector<Listener*> listeners_;
};

}  // namespace hal::sim
