// SPDX-License-Identifier: MIT
#include <hal/panels/frame_ticks.hpp>

namespace hal::panels {

Nanoseconds FrameTicks::elapsed() noexcept {
  const Nanoseconds now = clock_->now();
  if (!started_) {
    started_ = true;
    start_ = now;
  }
  return now - start_;
}

std::uint32_t FrameTicks::do_count() noexcept {
  return clock_ == nullptr ? free_ticks_ : static_cast<std::uint32_t>(elapsed() / period_);
}

Status FrameTicks::do_wait() noexcept {
  if (clock_ == nullptr) {
    ++free_ticks_;
    return {};
  }
  const Nanoseconds time = elapsed();
  clock_->wait_until(start_ + time + period_ - time % period_);
  return {};
}

Nanoseconds FrameTicks::do_last() noexcept {
  if (clock_ == nullptr) return 0;
  const Nanoseconds ticks = elapsed() / period_;
  return ticks == 0 ? 0 : start_ + ticks * period_;
}

}  // namespace hal::panels
