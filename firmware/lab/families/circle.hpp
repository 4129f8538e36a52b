// SPDX-License-Identifier: MIT
//
// The family of circles: outlines by a table of sines, and by the midpoint's error in 16, 32 and 64 bits,
// which go around all of them, and the library's own, which doesn't.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/raster/circle_rungs.hpp>
#include <intaglio/raster/solid.hpp>

#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>
#include <type_traits>

namespace lab {

struct Circle {
  static constexpr std::string_view name = "circle";
  static constexpr std::string_view title = "Drawing a circle";
  using Rungs = intaglio::raster::CircleFamily;
  using Default = intaglio::raster::CursorCircle;
  static constexpr Load loads[] = {
      {"radius up to 16", 32}, {"radius 40 to 110", 8}, {"radius 1,000, clipped", 4}};

  struct Input {
    intaglio::linear::Point centre;
    int radius;
  };
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i + 1));
    if (load == 0) return {{random.between(20, 299), random.between(20, 219)}, random.between(1, 16)};
    if (load == 1) return {{160, 120}, random.between(40, 110)};
    return {{160 + (i % 2 == 0 ? 950 : -980), 120 + random.between(-100, 100)}, 1000};
  }
  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    const intaglio::raster::Solid<image::Indexed8> pen(canvas(), 1);
    return R{}(pen, in.centre, in.radius).ok() ? 1 : 0;
  }

  /// Of the table of sines: the most that any circle of the load has wrong, all tried. (With a radius of
  /// 1,000, 105 were found, in windows around each of its rows.)
  template <class R>
  static constexpr number::Bound bound(int load) noexcept {
    constexpr int wrong[] = {32, 168, 120};
    return number::wrong_pixels(std::is_same_v<R, intaglio::raster::SineCircle> ? 1000 * wrong[load] : 0);
  }
};

}  // namespace lab
