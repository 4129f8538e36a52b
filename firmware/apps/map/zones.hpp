// SPDX-License-Identifier: MIT
//
// Bands of latitude on the panel, and a sink that colours by them.
//
// Rule: the globe from pole to pole is cut into equal bands; a pixel row belongs to the band that its
// centre's projection begins or passes. Rows beyond the poles count to the last band.
#pragma once

#include <intaglio/image/surface.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/solid.hpp>

#include <array>
#include <cstddef>
#include <firmware/apps/map/projection.hpp>

namespace apps::map {

/// First rows of the bands, north to south.
class Zones {
 public:
  static constexpr int most = 176;

  /// `steps` (1..most) bands on a panel of `height` rows.
  Zones(const Projection& projection, int steps, int height) noexcept : steps_(steps) {
    constexpr int pole = 90 * units_per_degree;
    for (int i = 1; i < steps; ++i) {
      const int row = to_pixel(projection.row(2 * pole * i / steps - pole));
      rows_[static_cast<std::size_t>(i)] = row < 0 ? 0 : row > height ? height : row;
    }
    rows_[static_cast<std::size_t>(steps)] = height;
  }

  /// The first row of a band, 0 <= band <= steps; that of `steps` is the panel's height.
  [[nodiscard]] int begin(int band) const noexcept { return rows_[static_cast<std::size_t>(band)]; }
  /// The band of a row of the panel; `near` is where to look first.
  [[nodiscard]] int band_of(int row, int near) const noexcept {
    while (near > 0 && row < begin(near)) --near;
    while (near < steps_ - 1 && row >= begin(near + 1)) ++near;
    return near;
  }

 private:
  std::array<int, most + 1> rows_{};
  int steps_;
};

/// Takes spans in the palette index of their row's band: the first band's is `first`, the next one's is
/// `stride` more.
template <intaglio::image::PixelFormat F>
class ZoneSink {
 public:
  ZoneSink(const intaglio::image::Surface<F>& target, const intaglio::linear::Rect& window,
           const Zones& zones, int first, int stride) noexcept
      : target_(target),
        window_(window),
        zones_(zones),
        first_(first),
        stride_(stride),
        solid_{target, 0U, window} {}

  [[nodiscard]] intaglio::linear::Rect clip() const noexcept { return solid_.clip(); }
  void span(int y, int x_begin, int x_end) noexcept {
    const int band = zones_.band_of(y, band_);
    if (band != band_ || !chosen_) {
      chosen_ = true;
      band_ = band;
      solid_ = {target_, static_cast<unsigned>(first_ + band * stride_), window_};
    }
    solid_.span(y, x_begin, x_end);
  }

 private:
  intaglio::image::Surface<F> target_;
  intaglio::linear::Rect window_;
  const Zones& zones_;
  int first_;
  int stride_;
  int band_ = 0;
  bool chosen_ = false;
  intaglio::raster::Solid<F> solid_;
};

}  // namespace apps::map
