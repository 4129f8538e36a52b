// SPDX-License-Identifier: MIT
//
// A frame writer whose buffer can be written to only while a frame of it is out.
//
// Rule: the guard opens when a frame begins and closes before it is sent. In between the buffer is what the
// panel shows, and a program that kept a way to draw on it is caught at the write that would show.
#pragma once

#include <intaglio/present/frame_writer.hpp>

#include <span>
#include <utility>

namespace boards {

/// `Guard` has `open()` and `close()`.
template <intaglio::image::PixelFormat F, class Guard>
class GuardedScreen {
 public:
  using Format = F;

  [[nodiscard]] static constexpr int memory_for(intaglio::linear::Size size) noexcept {
    return intaglio::present::FrameWriter<F>::memory_for(size);
  }

  GuardedScreen(hal::Panel& panel, std::span<std::uint8_t> memory, const Guard& guard) noexcept
      : screen_(panel, memory), guard_(&guard) {
    guard_->close();
  }

  [[nodiscard]] intaglio::Status status() const noexcept { return screen_.status(); }
  [[nodiscard]] intaglio::present::ScreenInfo info() const noexcept { return screen_.info(); }

  [[nodiscard]] intaglio::Result<intaglio::present::Frame<F>> begin() noexcept {
    auto begun = screen_.begin();
    if (begun.ok()) guard_->open();
    return begun;
  }
  [[nodiscard]] intaglio::Status present(intaglio::present::Frame<F>&& frame,
                                         std::span<const std::uint8_t> palette = {}) noexcept {
    guard_->close();
    const intaglio::Status s = screen_.present(std::move(frame), palette);
    if (!frame.empty()) guard_->open();  // NOLINT(bugprone-use-after-move): it may have been refused.
    return s;
  }
  [[nodiscard]] intaglio::Status wait_until_shown() noexcept { return screen_.wait_until_shown(); }
  [[nodiscard]] std::uint32_t missed_deadlines() const noexcept { return screen_.missed_deadlines(); }

 private:
  intaglio::present::FrameWriter<F> screen_;
  const Guard* guard_;
};

}  // namespace boards
