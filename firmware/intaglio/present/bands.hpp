// SPDX-License-Identifier: MIT
//
// Bands: a picture on a write panel by a program whose memory holds only some rows of it.
//
// Rule: the frame is cut into bands of as many rows as fit the memory, a multiple of the panel's row
// alignment; the last may be shorter. The same drawing call is made for each band, top to bottom, on a
// surface that keeps the frame's coordinates, so it draws the same pixels and those outside the band are
// clipped. The picture is the one a whole frame buffer would give, bit for bit, at the price of calling
// again.
#pragma once

#include <intaglio/image/surface.hpp>
#include <intaglio/present/pacer.hpp>
#include <intaglio/present/panel_port.hpp>
#include <intaglio/present/screen_info.hpp>

#include <concepts>

namespace intaglio::present {

/// Rows of a band in `memory` bytes at `stride` bytes a row on this panel; 0 if not even the least aligned
/// group of rows fits.
[[nodiscard]] int band_rows(const hal::Capabilities& panel, int stride, std::size_t memory) noexcept;

/// Bands of format `F` on a write panel.
template <image::PixelFormat F>
class BandWriter {
 public:
  using Format = F;

  /// Draws in `memory`, a frame every `interval` VBLANKs or ticks of the panel's frame clock. Whether that
  /// can be done says `status`.
  BandWriter(hal::Panel& panel, std::span<std::uint8_t> memory, int interval = 1) noexcept
      : panel_(&panel), pacer_(interval), memory_(memory), status_(start(interval)) {}
  BandWriter(const BandWriter&) = delete;
  BandWriter& operator=(const BandWriter&) = delete;

  /// Errors: panel (mismatched: other pixel format; unsupported: a scan-out panel), count (interval below 1),
  /// workspace (too small: `needed()` bytes hold the least band).
  [[nodiscard]] Status status() const noexcept { return status_; }
  [[nodiscard]] ScreenInfo info() const noexcept { return screen_info(panel_->capabilities()); }
  /// Rows of a band; the last may have fewer.
  [[nodiscard]] int rows() const noexcept { return rows_; }

  /// Draws and sends a frame when it is due, with these colours (3 bytes an entry; empty: the colours stay).
  /// `draw(image::Surface<F>)` is called for every band and answers a `Status`; the surface holds what an
  /// earlier band left. `watch(image::Picture<F>)` sees every band drawn, in order.
  /// Errors: `status`, palette (`check_palette`), what `draw` answers (the bands above are sent then),
  /// device.
  template <std::invocable<image::Surface<F>> Draw, std::invocable<image::Picture<F>> Watch>
  [[nodiscard]] Status present(Draw&& draw, std::span<const std::uint8_t> palette, Watch&& watch) {
    if (!status_.ok()) return status_;
    const hal::Capabilities& c = panel_->capabilities();
    if (const Status s = check_palette(c, palette); !s.ok()) return s;
    if (const Status s = pacer_.wait(*panel_, 0); !s.ok()) return s;
    pacer_.appeared(panel_->vblank_count());
    if (!palette.empty())
      if (const hal::Status s = panel_->load_palette(palette); !s.ok()) return to_status(s);
    for (int y = 0; y < c.height; y += rows_) {
      const int rows = c.height - y < rows_ ? c.height - y : rows_;
      const auto band = image::Surface<F>::over_band(memory_, {0, y, c.width, rows});
      if (!band.ok()) return band.status();
      if (const Status s = draw(band.value()); !s.ok()) return s;
      watch(image::Picture<F>(band.value()));
      const hal::Status s = panel_->write({0, y, c.width, rows}, memory_, band.value().stride());
      if (!s.ok()) return to_status(s);
    }
    return {};
  }
  template <std::invocable<image::Surface<F>> Draw>
  [[nodiscard]] Status present(Draw&& draw, std::span<const std::uint8_t> palette = {}) {
    return present(draw, palette, [](image::Picture<F>) {});
  }

  /// Does nothing: a frame is on display when `present` returns.
  [[nodiscard]] Status wait_until_shown() noexcept { return {}; }

  /// Frames that were begun later than `interval` VBLANKs after the one before.
  [[nodiscard]] std::uint32_t missed_deadlines() const noexcept { return pacer_.missed(); }

 private:
  Status start(int interval) noexcept {
    const hal::Capabilities& c = panel_->capabilities();
    if (c.buffers != 0) return {Error::unsupported, Argument::panel};
    if (const Status s = check_format<F>(c); !s.ok()) return s;
    if (const Status s = Pacer::check(interval); !s.ok()) return s;
    const int stride = F::row_bytes(c.width);
    rows_ = band_rows(c, stride, memory_.size());
    if (rows_ > 0) return {};
    const int least = c.y_alignment < c.height ? c.y_alignment : c.height;
    return {Error::too_small, Argument::workspace, static_cast<std::uint32_t>(stride * least)};
  }

  hal::Panel* panel_;
  Pacer pacer_;
  std::span<std::uint8_t> memory_;
  int rows_ = 0;
  Status status_;
};

}  // namespace intaglio::present
