// SPDX-License-Identifier: MIT
//
// Frames on a scan-out panel: single or double buffering (or more), swapped at VBLANK.
//
// Rule: what is on display is never drawn on, and buffer and palette change together at a VBLANK or not at
// all. With two buffers `begin` waits until the last swap has happened, for only then is there a buffer to
// draw on; with more it never waits, and `present` waits for the swap before, so no frame is skipped.
// With one buffer there is nothing to swap: `begin` waits for the VBLANK, drawing then runs ahead of the
// beam, and what isn't drawn before the beam comes tears; the palette still changes at the VBLANK after.
#pragma once

#include <intaglio/present/frame.hpp>
#include <intaglio/present/pacer.hpp>
#include <intaglio/present/panel_port.hpp>
#include <intaglio/present/screen_info.hpp>

namespace intaglio::present {

/// The part of a swap chain that doesn't depend on the pixel format.
class SwapControl {
 public:
  SwapControl(hal::Panel& panel, int interval) noexcept : panel_(&panel), pacer_(interval) {}

  /// Chooses the buffer to draw on. Errors: busy (only if `wait` is false), device.
  [[nodiscard]] Result<int> acquire(bool wait) noexcept;
  /// Asks for the acquired buffer to be shown. Errors: palette, device.
  [[nodiscard]] Status release(std::span<const std::uint8_t> palette) noexcept;
  /// Returns when nothing is pending. Errors: device.
  [[nodiscard]] Status settle() noexcept;

  [[nodiscard]] hal::Panel& panel() const noexcept { return *panel_; }
  [[nodiscard]] const Pacer& pacer() const noexcept { return pacer_; }

 private:
  /// The VBLANK at which the request just made takes effect.
  [[nodiscard]] std::uint32_t vblank_of_request() noexcept;

  /// True if the last wait for a frame to be shown ended with the latest VBLANK.
  [[nodiscard]] bool at_vblank_of_settling() noexcept {
    return settled_here_ && panel_->vblank_count() == settled_at_;
  }

  hal::Panel* panel_;
  Pacer pacer_;
  std::uint32_t settled_at_ = 0;
  bool settled_here_ = false;
  int shown_ = 0;  // The buffer last asked for; a panel starts with buffer 0 on display.
  int acquired_ = 0;
};

/// Frames of format `F` on a scan-out panel. Lives as long as any of its frames.
template <image::PixelFormat F>
class SwapChain : public FrameLender {
 public:
  using Format = F;

  /// A frame every `interval` VBLANKs. Whether that can be done says `status`.
  explicit SwapChain(hal::Panel& panel, int interval = 1) noexcept
      : control_(panel, interval), status_(check(panel, interval)) {}

  /// Errors: panel (mismatched: other pixel format; unsupported: a write panel), count (interval below 1),
  /// and those of `Surface::over` if the panel's buffers are wrong.
  [[nodiscard]] Status status() const noexcept { return status_; }
  [[nodiscard]] ScreenInfo info() const noexcept { return screen_info(control_.panel().capabilities()); }

  /// The next frame; waits until there is a buffer for it. What is in it is some earlier frame.
  /// Errors: `status`; busy frame, if the last one is still held; device.
  [[nodiscard]] Result<Frame<F>> begin() noexcept { return begin(true); }
  /// The same, but says busy frame instead of waiting.
  [[nodiscard]] Result<Frame<F>> try_begin() noexcept { return begin(false); }

  /// Shows the frame with these colours (3 bytes an entry; empty: the colours stay) from the next VBLANK on
  /// that the interval allows; returns before it. After an error of an argument the frame is still the
  /// caller's, after a device error it is gone.
  /// Errors: frame (empty; mismatched: another screen's), palette (`check_palette`), device.
  [[nodiscard]] Status present(Frame<F>&& frame, std::span<const std::uint8_t> palette = {}) noexcept {
    if (const Status s = check_own(frame); !s.ok()) return s;
    if (const Status s = check_palette(control_.panel().capabilities(), palette); !s.ok()) return s;
    const Frame<F> taken(std::move(frame));
    return control_.release(palette);
  }

  /// Returns when the frame last presented is on display. Errors: device.
  [[nodiscard]] Status wait_until_shown() noexcept { return control_.settle(); }

  /// Frames that appeared later than `interval` VBLANKs after the one before.
  [[nodiscard]] std::uint32_t missed_deadlines() const noexcept { return control_.pacer().missed(); }

 private:
  static Status check(hal::Panel& panel, int interval) noexcept {
    if (panel.capabilities().buffers < 1) return {Error::unsupported, Argument::panel};
    if (const Status s = check_format<F>(panel.capabilities()); !s.ok()) return s;
    if (const Status s = Pacer::check(interval); !s.ok()) return s;
    return surface_of(panel, 0).status();
  }
  static Result<image::Surface<F>> surface_of(hal::Panel& panel, int buffer) noexcept {
    const hal::Capabilities& c = panel.capabilities();
    return image::Surface<F>::over(panel.buffer(buffer), {c.width, c.height}, panel.buffer_stride());
  }

  Result<Frame<F>> begin(bool wait) noexcept {
    if (!status_.ok()) return status_;
    if (lent()) return Status{Error::busy, Argument::frame};
    const Result<int> buffer = control_.acquire(wait);
    if (!buffer.ok()) return buffer.status();
    const Result<image::Surface<F>> surface = surface_of(control_.panel(), buffer.value());
    if (!surface.ok()) return surface.status();
    return lend<F>(surface.value());
  }

  SwapControl control_;
  Status status_;
};

}  // namespace intaglio::present
