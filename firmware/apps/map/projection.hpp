// SPDX-License-Identifier: MIT
//
// From places on the globe to places on the panel.
//
// Rule: x = (longitude - camera) * scale_x, y likewise, rounded to the nearest 1/256 px, plus the middle of
// the panel. Each vertex is rounded once, so polygons that share a vertex on the globe share it on the panel.
//
// Bit budget: a difference has 8 fraction bits and 26 in all, a scale 27: products have 53.
#pragma once

#include <intaglio/linear/point.hpp>

#include <cstdint>
#include <firmware/apps/map/tour.hpp>

namespace apps::map {

/// The camera's view of the globe on one panel.
class Projection {
 public:
  constexpr Projection(const Camera& camera, intaglio::linear::Size size) noexcept
      : camera_(camera), middle_{(size.width - 1) * 128, (size.height - 1) * 128} {}

  /// Column of a longitude in units, in 1/256 px. At most four worlds from the camera.
  [[nodiscard]] constexpr int column(int longitude) const noexcept {
    return middle_.x + scaled(longitude, camera_.x, camera_.scale_x);
  }
  /// Row of a latitude in units, south positive, in 1/256 px.
  [[nodiscard]] constexpr int row(int latitude) const noexcept {
    return middle_.y + scaled(latitude, camera_.y, camera_.scale_y);
  }
  [[nodiscard]] constexpr intaglio::linear::SubPoint place(int longitude, int latitude) const noexcept {
    return {column(longitude), row(latitude)};
  }

 private:
  [[nodiscard]] static constexpr int scaled(int at, int camera, std::int64_t scale) noexcept {
    constexpr int bits = scale_bits + camera_bits;
    const std::int64_t distance = std::int64_t{at} * (1 << camera_bits) - camera;
    return static_cast<int>((distance * scale + (std::int64_t{1} << (bits - 1))) >> bits);
  }

  Camera camera_;
  intaglio::linear::SubPoint middle_;
};

/// The pixel nearest to a place in 1/256 px.
[[nodiscard]] constexpr int to_pixel(int sub) noexcept {
  return (sub + intaglio::linear::subpixel_one / 2) >> intaglio::linear::subpixel_bits;
}

}  // namespace apps::map
