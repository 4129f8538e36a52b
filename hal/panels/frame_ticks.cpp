// SPDX-License-Identifier: MIT
#include <hal/panels/frame_ticks.hpp>

namespace hal::panels {

std::uint32_t FrameTicks::count() noexcept {
  if (clock_ == nullptr) return free_ticks_;
  const Nanoseconds now = clock_->now();
  if (!started_) {
    started_ = true;
    start_ = now;
  }
  return static_cast<std::uint32_t>((now - start_) / period_);
}

void FrameTicks::wait() noexcept {
  if (clock_ == nullptr) {
    ++free_ticks_;
    return;
  }
  const Nanoseconds now = clock_->now();
  if (!started_) {
    started_ = true;
    start_ = now;
  }
  clock_->wait_until(now + period_ - (now - start_) % period_);
}

}  // namespace hal::panels
