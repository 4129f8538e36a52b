// SPDX-License-Identifier: MIT
//
// The right to draw one frame.
//
// Rule: a frame exists once. It is handed out by a screen, drawn on, and given back with `present`; whoever
// gave it away holds an empty surface, on which drawing does nothing. So a buffer that is (or is about to be)
// on display can't be drawn on by mistake: a copy doesn't compile, and use after hand-over changes no pixel.
// A frame that is dropped undrawn goes back to its screen.
#pragma once

#include <intaglio/image/surface.hpp>

#include <utility>

namespace intaglio::present {

template <image::PixelFormat F>
class Frame;

/// What lends frames: remembers whether its one frame in work is out.
class FrameLender {
 public:
  FrameLender(const FrameLender&) = delete;
  FrameLender& operator=(const FrameLender&) = delete;

 protected:
  constexpr FrameLender() noexcept = default;
  ~FrameLender() = default;

  [[nodiscard]] constexpr bool lent() const noexcept { return lent_; }
  /// The frame on `surface`, lent by this.
  template <image::PixelFormat F>
  [[nodiscard]] constexpr Frame<F> lend(const image::Surface<F>& surface) noexcept {
    lent_ = true;
    return Frame<F>(*this, surface);
  }
  /// Success if `frame` was lent by this and is still held.
  template <image::PixelFormat F>
  [[nodiscard]] constexpr Status check_own(const Frame<F>& frame) const noexcept {
    if (frame.lender_ == nullptr) return {Error::empty, Argument::frame};
    if (frame.lender_ != this) return {Error::mismatched, Argument::frame};
    return {};
  }

 private:
  template <image::PixelFormat F>
  friend class Frame;

  bool lent_ = false;
};

/// A handle on the buffer in work. Move-only. Must not outlive the screen that lent it.
template <image::PixelFormat F>
class [[nodiscard]] Frame {
 public:
  /// No frame: an empty surface.
  constexpr Frame() noexcept = default;
  constexpr Frame(Frame&& other) noexcept
      : lender_(std::exchange(other.lender_, nullptr)), surface_(std::exchange(other.surface_, {})) {}
  constexpr Frame& operator=(Frame&& other) noexcept {
    Frame taken(std::move(other));
    std::swap(lender_, taken.lender_);
    std::swap(surface_, taken.surface_);
    return *this;
  }
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;
  constexpr ~Frame() {
    if (lender_ != nullptr) lender_->lent_ = false;
  }

  /// Where to draw. A copy of it must not be kept beyond `present`.
  [[nodiscard]] constexpr const image::Surface<F>& surface() const noexcept { return surface_; }
  /// True if there is nothing to draw on: given away, or never lent.
  [[nodiscard]] constexpr bool empty() const noexcept { return lender_ == nullptr; }

 private:
  friend class FrameLender;

  constexpr Frame(FrameLender& lender, const image::Surface<F>& surface) noexcept
      : lender_(&lender), surface_(surface) {}

  FrameLender* lender_ = nullptr;
  image::Surface<F> surface_{};
};

}  // namespace intaglio::present
