// SPDX-License-Identifier: MIT
#include <intaglio/present/swap_chain.hpp>

namespace intaglio::present {

Result<int> SwapControl::acquire(bool wait) noexcept {
  const int buffers = panel_->capabilities().buffers;
  // With three buffers or more one is neither on display nor waiting for it.
  if (buffers <= 2) {
    if (!wait && panel_->show_pending()) return Status{Error::busy, Argument::frame};
    if (const Status s = settle(); !s.ok()) return s;
  }
  if (buffers == 1 && wait && !at_vblank_of_settling())
    if (const hal::Status s = panel_->wait_for_vblank(); !s.ok()) return to_status(s);
  settled_here_ = false;
  acquired_ = shown_ + 1 < buffers ? shown_ + 1 : 0;
  return acquired_;
}

Status SwapControl::release(std::span<const std::uint8_t> palette) noexcept {
  // The wait ends no earlier than the frame before appeared, so its request isn't replaced.
  if (const Status s = pacer_.wait(*panel_, 1); !s.ok()) return s;
  if (const hal::Status s = panel_->show(acquired_, palette); !s.ok()) return to_status(s);
  shown_ = acquired_;
  pacer_.appeared(vblank_of_request());
  return {};
}

Status SwapControl::settle() noexcept {
  while (panel_->show_pending()) {
    if (const hal::Status s = panel_->wait_for_vblank(); !s.ok()) return to_status(s);
    settled_here_ = true;
    settled_at_ = panel_->vblank_count();
  }
  return {};
}

std::uint32_t SwapControl::vblank_of_request() noexcept {
  // A VBLANK may come between the two questions; then they are asked again, for only answers given within the
  // same VBLANK period belong together.
  for (;;) {
    const std::uint32_t count = panel_->vblank_count();
    const bool pending = panel_->show_pending();
    if (panel_->vblank_count() == count) return pending ? count + 1U : count;
  }
}

}  // namespace intaglio::present
