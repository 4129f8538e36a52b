// SPDX-License-Identifier: MIT
//
// Frames on a scan-out panel: single, double or triple buffering (or more), swapped at VBLANK.
//
// Rule: what is on display is never drawn on, and buffer and palette change together at a VBLANK or not at
// all. With two buffers `begin` waits until the last swap has happened, for only then is there a buffer to
// draw on. With three it doesn't: `present` waits for the swap before, so no frame is skipped
// (`Order::every`), or nothing waits and a VBLANK shows the frame finished last (`Order::latest`).
// With one buffer there is nothing to swap: `begin` waits for the VBLANK, drawing then runs ahead of the
// beam, and what isn't drawn before the beam comes tears; the palette still changes at the VBLANK after.
#pragma once

#include <intaglio/present/frame.hpp>
#include <intaglio/present/pacer.hpp>
#include <intaglio/present/panel_port.hpp>
#include <intaglio/present/screen_info.hpp>
#include <intaglio/present/swap_control.hpp>

namespace intaglio::present {

/// Frames of format `F` on a scan-out panel. Lives as long as any of its frames.
template <image::PixelFormat F, class Control = SwapControl>
class SwapChain : public FrameLender {
 public:
  using Format = F;

  /// Frames at this pace. Whether that can be done says `status`.
  explicit SwapChain(hal::Panel& panel, const Pace& pace = {}) noexcept
      : control_(panel, pace), status_(check(panel, pace)) {}

  /// Errors: panel (mismatched: other pixel format; unsupported: a write panel), count (`Pacer::check`), and
  /// those of `Surface::over` if the panel's buffers are wrong.
  [[nodiscard]] Status status() const noexcept { return status_; }
  [[nodiscard]] ScreenInfo info() const noexcept { return screen_info(control_.panel().capabilities()); }

  /// The next frame; waits until there is a buffer for it. What is in it is some earlier frame.
  /// Errors: `status`; busy frame, if the last one is still held; device.
  [[nodiscard]] Result<Frame<F>> begin() noexcept { return begin(true); }
  /// The same, but says busy frame instead of waiting.
  [[nodiscard]] Result<Frame<F>> try_begin() noexcept { return begin(false); }

  /// Shows the frame with these colours (3 bytes an entry; empty: the colours stay) from the next VBLANK on
  /// that the pace allows; returns before it. A frame that comes too late may be dropped instead, but its
  /// colours aren't: they are shown with the next. After an error of an argument the frame is still the
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

  /// Frames that came later than `interval` VBLANKs after the one before.
  [[nodiscard]] std::uint32_t missed_deadlines() const noexcept { return control_.pacer().missed(); }
  /// What became of the frames so far; with `Order::latest` the last may yet be replaced.
  [[nodiscard]] const FrameCounts& counts() const noexcept { return control_.pacer().counts(); }
  [[nodiscard]] const Control& control() const noexcept { return control_; }

 private:
  static Status check(hal::Panel& panel, const Pace& pace) noexcept {
    if (panel.capabilities().buffers < 1) return {Error::unsupported, Argument::panel};
    if (const Status s = check_format<F>(panel.capabilities()); !s.ok()) return s;
    if (const Status s = Pacer::check(pace); !s.ok()) return s;
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

  Control control_;
  Status status_;
};

}  // namespace intaglio::present
