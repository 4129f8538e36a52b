// SPDX-License-Identifier: MIT
//
// Where the map looks at a frame: a round trip that never ends, from place to place.
//
// Rule: the camera rests at a stop, then flies to the next: it pulls back, moves while it sees most, and
// comes down again. Places are in 1/180 degree, x eastwards and y southwards; the camera's in 1/256 of that.
// Zoom is in 1/256 octaves above the scale at which the world just covers the panel. The horizontal scale is
// the vertical one times the cosine of the camera's latitude, so shapes are true where one looks.
//
// Bit budget: `scale_limit` keeps every vertex of five copies of the world within 2^28 sub-pixels.
#pragma once

#include <intaglio/linear/point.hpp>

#include <cstdint>

namespace apps::map {

/// Units of the land table in a degree.
inline constexpr int units_per_degree = 180;
/// Units around the world.
inline constexpr int world_width = 360 * units_per_degree;
/// Fraction bits of the camera's place.
inline constexpr int camera_bits = 8;
/// Fraction bits of a scale.
inline constexpr int scale_bits = 16;
/// Largest scale: four worlds from the middle of the largest panel is still inside the coordinate domain.
inline constexpr std::int64_t scale_limit = (std::int64_t{1} << (27 + scale_bits)) / (4 * world_width);

/// What the map looks at.
struct Camera {
  int x = 0;                 ///< Longitude, east positive, in 1/256 unit; within half a world of 0.
  int y = 0;                 ///< Latitude, south positive.
  std::int64_t scale_x = 1;  ///< Sub-pixels (1/256 px) a unit, times 2^16; 1 .. scale_limit.
  std::int64_t scale_y = 1;
  int zoom = 0;   ///< In 1/256 octaves; 0 shows the world.
  int night = 0;  ///< 0 (noon) .. 256 (midnight)
};

/// Whole pixels a degree northwards.
[[nodiscard]] constexpr int pixels_per_degree(const Camera& camera) noexcept {
  return static_cast<int>((camera.scale_y * units_per_degree) >> (scale_bits + 8));
}

/// The camera of a frame on a panel. Sides of 1 and more.
[[nodiscard]] Camera camera_at(std::uint32_t frame, intaglio::linear::Size size) noexcept;

}  // namespace apps::map
