// SPDX-License-Identifier: MIT
//
// The family of filled triangles: with vertices snapped to 0, 4 or 8 fraction bits, by walking edges or by
// edge functions in 32 or 64 bits. Whatever the snapping, triangles that share an edge share no pixel.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/raster/triangle_rungs.hpp>

#include <array>
#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>
#include <type_traits>

namespace lab {

struct Triangle {
  static constexpr std::string_view name = "triangle";
  static constexpr std::string_view title = "Filling a triangle";
  using Rungs = intaglio::raster::TriangleFamily;
  using Default = intaglio::raster::WalkExact;
  static constexpr Load loads[] = {
      {"sides up to 60 pixels", 8}, {"slivers", 8}, {"sides up to 300 pixels", 3}};
  static constexpr int longest[] = {60, 100, 300};

  using Input = std::array<intaglio::linear::SubPoint, 3>;
  static Input input(int load, int i) noexcept {
    using intaglio::linear::SubPoint;
    Random random(static_cast<std::uint32_t>(i + 1));
    const int reach = longest[load] * 128;
    const SubPoint middle{160 * 256 + random.between(-9'999, 9'999),
                          120 * 256 + random.between(-9'999, 9'999)};
    Input t{};
    for (SubPoint& p : t)
      p = {middle.x + random.between(-reach, reach), middle.y + random.between(-reach, reach)};
    if (load == 1) t[2] = {t[1].x + random.between(-500, 500), t[1].y + random.between(-500, 500)};
    return t;
  }
  template <class R>
  static std::uint32_t run(const Input& t) noexcept {
    return R{}(intaglio::raster::Solid<image::Indexed8>(canvas(), 1), t[0], t[1], t[2]).ok() ? 1 : 0;
  }

  /// How many pixels are wrong. A side whose ends move by half a pixel or less each way moves by a pixel or
  /// less along its minor axis: so at each step of the other axis, and of one more at either end, one pixel
  /// is wrong at most. So it is where all sides go through pixel centres but for a bit. The short side of a
  /// sliver is up to two pixels.
  template <class R>
  static constexpr number::Bound bound(int load) noexcept {
    constexpr int sides[] = {3 * 60, 2 * 102 + 2, 3 * 300};
    return number::wrong_pixels(R::bound.exact() ? 0 : (sides[load] + 6) * 1000);
  }
  /// Why a bound isn't reached.
  template <class R>
  static constexpr std::string_view slack() noexcept {
    if (std::is_same_v<R, intaglio::raster::WalkSnapped4> ||
        std::is_same_v<R, intaglio::raster::Box32Snapped4>)
      return "the two long sides of a sliver would both have to run along pixel centres";
    return "";
  }
};

}  // namespace lab
