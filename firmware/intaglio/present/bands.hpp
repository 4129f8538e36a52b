// SPDX-License-Identifier: MIT
//
// Bands: a picture on a write panel by a program whose memory holds only some rows of it.
//
// Rule: the frame is cut into bands of as many rows as fit the memory, a multiple of the panel's row
// alignment; the last may be shorter. The same drawing call is made for each band, top to bottom, on a
// surface that keeps the frame's coordinates, so it draws the same pixels and those outside the band are
// clipped. The picture is the one a whole frame buffer would give, bit for bit, at the price of calling
// again.
// A frame that is due is sent at once, as by a `FrameWriter`, wherever the beam is.
// With a beam chaser the bands follow the beam instead: rows from the bottom up, or columns, where the panel
// is scanned that way; each is sent when the beam can't meet it.
#pragma once

#include <intaglio/image/surface.hpp>
#include <intaglio/present/band_cut.hpp>
#include <intaglio/present/beam_chaser.hpp>
#include <intaglio/present/pacer.hpp>
#include <intaglio/present/panel_port.hpp>
#include <intaglio/present/screen_info.hpp>

#include <concepts>
#include <type_traits>

namespace intaglio::present {

/// Bands of format `F` on a write panel.
template <image::PixelFormat F>
class BandWriter {
 public:
  using Format = F;

  /// Draws in `memory` frames at this pace, in VBLANKs or ticks of the panel's frame clock. Whether that can
  /// be done says `status`.
  BandWriter(hal::Panel& panel, std::span<std::uint8_t> memory, const Pace& pace = {}) noexcept
      : BandWriter(panel, memory, nullptr, pace) {}
  /// The same behind the beam. The chaser outlives the writer and serves it alone; its lines are rows, or
  /// columns of a panel that is scanned sideways.
  BandWriter(hal::Panel& panel, std::span<std::uint8_t> memory, BeamChaser& chaser,
             const Pace& pace = {}) noexcept
      : BandWriter(panel, memory, &chaser, pace) {}
  BandWriter(const BandWriter&) = delete;
  BandWriter& operator=(const BandWriter&) = delete;

  /// Errors: panel (mismatched: other pixel format; unsupported: a scan-out panel), count (`Pacer::check`),
  /// workspace (too small: `needed()` bytes hold the least band), table (`BeamChaser::prepare`).
  [[nodiscard]] Status status() const noexcept { return status_; }
  [[nodiscard]] ScreenInfo info() const noexcept { return screen_info(panel_->capabilities()); }
  /// Rows of a band (columns, if the chased beam goes sideways); the last may have fewer.
  [[nodiscard]] int rows() const noexcept { return cut_.lines; }

  /// Draws and sends a frame when it is due, with these colours (3 bytes an entry; empty: the colours stay).
  /// `draw(image::Surface<F>)` is called for every band and answers a `Status`; the surface holds what an
  /// earlier band left. `watch(image::Picture<F>)` sees every band drawn, from the top; if they aren't sent
  /// in that order, or the frame is dropped for being late, they are drawn for it again. Errors: `status`,
  /// palette (`check_palette`), what `draw` answers (the bands above are sent then), device.
  template <std::invocable<image::Surface<F>> Draw, std::invocable<image::Picture<F>> Watch>
  [[nodiscard]] Status present(Draw&& draw, std::span<const std::uint8_t> palette, Watch&& watch) {
    if (!status_.ok()) return status_;
    const hal::Capabilities& c = panel_->capabilities();
    if (const Status s = check_palette(c, palette); !s.ok()) return s;
    bool sent = false;
    const Status s = chaser_ == nullptr ? send(draw, palette, watch, sent) : chase(draw, palette, sent);
    if (!s.ok()) return s;
    if (sent && chaser_ == nullptr) return {};
    return show_to(draw, watch);
  }
  template <std::invocable<image::Surface<F>> Draw>
  [[nodiscard]] Status present(Draw&& draw, std::span<const std::uint8_t> palette = {}) {
    return present(draw, palette, NoWatch{});
  }

  /// Does nothing: a frame is on display when `present` returns.
  [[nodiscard]] Status wait_until_shown() noexcept { return {}; }

  /// Frames that were begun later than `interval` VBLANKs after the one before.
  [[nodiscard]] std::uint32_t missed_deadlines() const noexcept { return pacer_.missed(); }
  /// What became of the frames so far.
  [[nodiscard]] const FrameCounts& counts() const noexcept { return pacer_.counts(); }

 private:
  struct NoWatch {
    void operator()(image::Picture<F>) const noexcept {}
  };

  BandWriter(hal::Panel& panel, std::span<std::uint8_t> memory, BeamChaser* chaser, const Pace& pace) noexcept
      : panel_(&panel), chaser_(chaser), pacer_(pace), memory_(memory), status_(start(pace)) {}

  Status start(const Pace& pace) noexcept {
    const hal::Capabilities& c = panel_->capabilities();
    if (c.buffers != 0) return {Error::unsupported, Argument::panel};
    if (const Status s = check_format<F>(c); !s.ok()) return s;
    if (const Status s = Pacer::check(pace); !s.ok()) return s;
    cut_ = chaser_ == nullptr ? rows_from_top(c, F::bits, memory_.size())
                              : along_scan(c, F::bits, memory_.size());
    if (cut_.count == 0)
      return {Error::too_small, Argument::workspace, least_memory(c, F::bits, cut_.columns)};
    if (chaser_ == nullptr) return {};
    return chaser_->prepare(cut_.sizes(c), cut_.travel());
  }

  template <class Draw>
  Result<image::Surface<F>> drawn(Draw& draw, const linear::Rect& area) {
    const auto band = image::Surface<F>::over_band(memory_, area);
    if (!band.ok()) return band.status();
    if (const Status s = draw(band.value()); !s.ok()) return s;
    return band;
  }

  hal::Status write(const image::Surface<F>& band) {
    const linear::Rect r = band.bounds();
    return panel_->write({r.x, r.y, r.width, r.height}, memory_, band.stride());
  }

  hal::Status load(std::span<const std::uint8_t> palette) {
    return palette.empty() ? hal::Status{} : panel_->load_palette(palette);
  }

  /// A frame whose first row could be sent at this VBLANK is late and not sent. Colours are kept by the
  /// panel, which doesn't show them before pixels are written.
  bool drop(std::uint32_t vblank, std::span<const std::uint8_t> palette) {
    return can_wait(panel_->capabilities(), palette) && pacer_.drop(vblank);
  }

  Status failed(hal::Status s, std::uint32_t vblank) {
    pacer_.lost(vblank);
    return to_status(s);
  }

  template <class Draw, class Watch>
  Status send(Draw& draw, std::span<const std::uint8_t> palette, Watch& watch, bool& sent) {
    if (const Status s = pacer_.wait(*panel_, 0); !s.ok()) return s;
    const std::uint32_t vblank = panel_->vblank_count();
    sent = !drop(vblank, palette);
    if (const hal::Status s = load(palette); !s.ok()) return sent ? failed(s, vblank) : to_status(s);
    if (!sent) return {};
    for (int step = 0; step < cut_.count; ++step) {
      const auto band = drawn(draw, cut_.band(panel_->capabilities(), step));
      if (!band.ok()) return band.status();
      watch(image::Picture<F>(band.value()));
      if (const hal::Status s = write(band.value()); !s.ok()) return failed(s, vblank);
    }
    pacer_.appeared(vblank);
    return {};
  }

  template <class Draw>
  Status chase(Draw& draw, std::span<const std::uint8_t> palette, bool& sent) {
    const hal::Capabilities& c = panel_->capabilities();
    std::uint32_t refresh = 0;
    for (int step = 0; step < cut_.count; ++step) {
      const linear::Rect area = cut_.band(c, step);
      const auto band = drawn(draw, area);
      if (!band.ok()) return band.status();
      if (step == 0) {
        const Result<std::uint32_t> aim = chaser_->aim(pacer_);
        if (!aim.ok()) return aim.status();
        refresh = aim.value();
        sent = !drop(refresh, palette);
        if (const hal::Status s = load(palette); !s.ok()) return sent ? failed(s, refresh) : to_status(s);
        if (!sent) return {};
      }
      const int first = cut_.first_scanned(c, step);
      chaser_->before_write(first, first + cut_.lines_of(area));
      if (const hal::Status s = write(band.value()); !s.ok()) return failed(s, refresh);
      chaser_->after_write();
    }
    chaser_->complete();
    pacer_.appeared(refresh);
    return {};
  }

  /// The bands from the top for one who watches.
  template <class Draw, class Watch>
  Status show_to(Draw& draw, Watch& watch) {
    if constexpr (!std::is_same_v<std::remove_cvref_t<Watch>, NoWatch>) {
      const hal::Capabilities& c = panel_->capabilities();
      const BandCut rows = rows_from_top(c, F::bits, memory_.size());
      if (rows.count == 0) return {Error::too_small, Argument::workspace, least_memory(c, F::bits, false)};
      for (int step = 0; step < rows.count; ++step) {
        const auto band = drawn(draw, rows.band(c, step));
        if (!band.ok()) return band.status();
        watch(image::Picture<F>(band.value()));
      }
    }
    return {};
  }

  hal::Panel* panel_;
  BeamChaser* chaser_;
  Pacer pacer_;
  std::span<std::uint8_t> memory_;
  BandCut cut_{};
  Status status_;
};

}  // namespace intaglio::present
