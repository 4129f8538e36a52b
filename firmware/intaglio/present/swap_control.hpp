// SPDX-License-Identifier: MIT
//
// Which buffer of a scan-out panel is drawn on next, and when a drawn one is asked for.
//
// Rule: a buffer on display (or being sent), or waiting for it, is never drawn on. With `Order::every` a
// request waits until the one before has taken effect; with `Order::latest` it replaces it, and of the buffer
// replaced only the panel itself can tell whether it got on display in between (`hal::Panel::on_display`).
// Where the driver can't tell, both buffers count as on display until nothing is pending.
// Each rule is named in `SwapGuards`, so a test can leave it out and see that it is needed: tests/present
// explores all interleavings with a panel's interrupts.
#pragma once

#include <intaglio/present/kept_colours.hpp>
#include <intaglio/present/pacer.hpp>
#include <intaglio/present/panel_port.hpp>

namespace intaglio::present {

/// What keeps a swap from going wrong.
struct SwapGuards {
  /// The buffer on display isn't drawn on,
  static constexpr bool spares_displayed = true;
  /// nor is one that waits for its VBLANK.
  static constexpr bool spares_pending = true;
  /// Whether a request waits is asked before what is on display.
  static constexpr bool asks_in_order = true;
  /// With `Order::every` no request is replaced.
  static constexpr bool waits_for_swap = true;
  /// The colours of a dropped frame reach the next.
  static constexpr bool keeps_colours = true;
};

/// The part of a swap chain that doesn't depend on the pixel format.
template <class Guards>
class GuardedSwapControl {
 public:
  /// A pace that `Pacer::check` accepts.
  GuardedSwapControl(hal::Panel& panel, const Pace& pace) noexcept
      : panel_(&panel), pacer_(pace), before_(pacer_), order_(pace.order) {}

  /// Chooses the buffer to draw on. Errors: busy (only if `wait` is false), device.
  [[nodiscard]] Result<int> acquire(bool wait) noexcept;
  /// Asks for the acquired buffer to be shown, or drops it if it is late. Errors: palette, device.
  [[nodiscard]] Status release(std::span<const std::uint8_t> palette) noexcept;
  /// Returns when nothing is pending. Errors: device.
  [[nodiscard]] Status settle() noexcept;

  [[nodiscard]] hal::Panel& panel() const noexcept { return *panel_; }
  [[nodiscard]] const Pacer& pacer() const noexcept { return pacer_; }
  /// The buffers that the chain believes on display or pending, a bit each, and the one asked for last.
  [[nodiscard]] std::uint32_t held() const noexcept { return held_; }
  [[nodiscard]] int requested() const noexcept { return requested_; }

 private:
  [[nodiscard]] static constexpr std::uint32_t bit(int buffer) noexcept {
    return std::uint32_t{1} << static_cast<unsigned>(buffer);
  }

  /// A buffer that may be drawn on, or -1.
  [[nodiscard]] int free_buffer() noexcept;
  /// The only buffer, at the beginning of a VBLANK.
  [[nodiscard]] Result<int> acquire_only(bool wait) noexcept;
  /// Returns when a request may be made. Errors: device.
  [[nodiscard]] Status await_turn() noexcept;
  /// True if the request of before, which was pending when this one was about to be made, was replaced by it.
  /// Where the driver can't tell it is taken to be.
  [[nodiscard]] bool was_replaced() noexcept;
  /// The VBLANK at which the request just made takes effect.
  [[nodiscard]] std::uint32_t vblank_of_request() noexcept;
  /// True if the last wait for a frame to be shown ended with the latest VBLANK.
  [[nodiscard]] bool at_vblank_of_settling() noexcept {
    return settled_here_ && panel_->vblank_count() == settled_at_;
  }

  static constexpr int most_buffers = 32;

  hal::Panel* panel_;
  Pacer pacer_;
  Pacer before_;  // As it was before the request that waits, for that may be replaced.
  std::uint32_t settled_at_ = 0;
  std::uint32_t held_ = 1;  // Bit i: buffer i may be on display or pending. A panel starts with buffer 0.
  int requested_ = 0;
  int acquired_ = 0;
  Order order_;
  bool settled_here_ = false;
  KeptColours kept_;
};

template <class Guards>
int GuardedSwapControl<Guards>::free_buffer() noexcept {
  // In this order: a request that takes effect between the two questions is then held for both reasons.
  const int before = Guards::asks_in_order ? hal::Panel::unknown : panel_->on_display();
  const bool pending = panel_->show_pending();
  const int displayed = Guards::asks_in_order ? panel_->on_display() : before;
  if (displayed != hal::Panel::unknown) {
    held_ = pending && Guards::spares_pending ? bit(requested_) : 0;
    if (displayed >= 0 && Guards::spares_displayed) held_ |= bit(displayed);
  } else if (!pending) {
    held_ = bit(requested_);
  }
  const int buffers =
      panel_->capabilities().buffers < most_buffers ? panel_->capabilities().buffers : most_buffers;
  int buffer = requested_;
  for (int i = 0; i < buffers; ++i) {
    buffer = buffer + 1 < buffers ? buffer + 1 : 0;
    if ((held_ & bit(buffer)) == 0) return buffer;
  }
  return -1;
}

template <class Guards>
Result<int> GuardedSwapControl<Guards>::acquire(bool wait) noexcept {
  if (panel_->capabilities().buffers == 1) return acquire_only(wait);
  for (;;) {
    const int buffer = free_buffer();
    if (buffer >= 0) {
      acquired_ = buffer;
      return buffer;
    }
    if (!wait) return Status{Error::busy, Argument::frame};
    if (const hal::Status s = panel_->wait_for_vblank(); !s.ok()) return to_status(s);
  }
}

template <class Guards>
Result<int> GuardedSwapControl<Guards>::acquire_only(bool wait) noexcept {
  if (!wait && panel_->show_pending()) return Status{Error::busy, Argument::frame};
  if (const Status s = settle(); !s.ok()) return s;
  if (wait && !at_vblank_of_settling())
    if (const hal::Status s = panel_->wait_for_vblank(); !s.ok()) return to_status(s);
  settled_here_ = false;
  return 0;
}

template <class Guards>
Status GuardedSwapControl<Guards>::await_turn() noexcept {
  if (order_ == Order::latest) return {};
  if (const Status s = pacer_.wait(*panel_, 1); !s.ok()) return s;
  return Guards::waits_for_swap ? settle() : Status{};
}

template <class Guards>
Status GuardedSwapControl<Guards>::release(std::span<const std::uint8_t> palette) noexcept {
  const bool replaces = order_ == Order::latest && panel_->show_pending();
  Status s = await_turn();
  const std::uint32_t next = panel_->vblank_count() + 1U;
  if (s.ok() && order_ == Order::every && pacer_.drop(next)) {
    if (Guards::keeps_colours) kept_.keep(palette);
    return {};
  }
  if (s.ok()) s = to_status(panel_->show(acquired_, kept_.joined(palette)));
  if (!s.ok()) {
    if (order_ == Order::every) {
      pacer_.lost(next);
    } else {  // It had no VBLANK of its own to miss.
      pacer_.replaced();
      before_.replaced();
    }
    kept_.keep(palette);
    return s;
  }
  kept_.forget();
  if (replaces && was_replaced()) {
    pacer_ = before_;
    pacer_.replaced();
  }
  before_ = pacer_;
  requested_ = acquired_;
  held_ |= bit(acquired_);
  pacer_.appeared(vblank_of_request());
  return {};
}

template <class Guards>
bool GuardedSwapControl<Guards>::was_replaced() noexcept {
  return panel_->on_display() == hal::Panel::unknown || panel_->show_replaced();
}

template <class Guards>
Status GuardedSwapControl<Guards>::settle() noexcept {
  while (panel_->show_pending()) {
    if (const hal::Status s = panel_->wait_for_vblank(); !s.ok()) return to_status(s);
    settled_here_ = true;
    settled_at_ = panel_->vblank_count();
  }
  return {};
}

template <class Guards>
std::uint32_t GuardedSwapControl<Guards>::vblank_of_request() noexcept {
  // A VBLANK may come between the two questions; then they are asked again, for only answers given within the
  // same VBLANK period belong together.
  for (;;) {
    const std::uint32_t count = panel_->vblank_count();
    const bool pending = panel_->show_pending();
    if (panel_->vblank_count() == count) return pending ? count + 1U : count;
  }
}

using SwapControl = GuardedSwapControl<SwapGuards>;
extern template class GuardedSwapControl<SwapGuards>;

}  // namespace intaglio::present
