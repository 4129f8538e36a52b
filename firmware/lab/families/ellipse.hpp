// SPDX-License-Identifier: MIT
//
// The family of ellipses: outlines by a table of sines, and by the midpoint's error in 16, 32 and 64 bits,
// which go around all of them, and the library's own, which doesn't.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/raster/ellipse_rungs.hpp>
#include <intaglio/raster/solid.hpp>

#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>
#include <type_traits>

namespace lab {

struct Ellipse {
  static constexpr std::string_view name = "ellipse";
  static constexpr std::string_view title = "Drawing an ellipse";
  using Rungs = intaglio::raster::EllipseFamily;
  using Default = intaglio::raster::RowEllipse;
  static constexpr Load loads[] = {
      {"half axes up to 15", 32}, {"half axes 40 to 110", 8}, {"half axes 300 to 450, clipped", 4}};

  struct Input {
    intaglio::linear::Point centre;
    int across;
    int down;
  };
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i + 1));
    if (load == 0) {
      return {
          {random.between(20, 299), random.between(20, 219)}, random.between(1, 15), random.between(1, 15)};
    }
    if (load == 1) return {{160, 120}, random.between(40, 110), random.between(40, 110)};
    return {{160, 500}, random.between(300, 450), random.between(300, 450)};
  }
  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    const intaglio::raster::Solid<image::Indexed8> pen(canvas(), 1);
    return R{}(pen, in.centre, in.across, in.down).ok() ? 1 : 0;
  }

  /// 16 bits are enough under the first load alone.
  template <class R>
  static constexpr bool takes(int load) noexcept {
    return !std::is_same_v<R, intaglio::raster::MidpointEllipse16> || load == 0;
  }
  /// The most that any ellipse of the load has wrong, all tried.
  template <class R>
  static constexpr number::Bound bound(int load) noexcept {
    constexpr int of_sines[] = {32, 152, 120};
    constexpr int of_midpoints[] = {8, 8, 0};
    int wrong = of_midpoints[load];
    if (std::is_same_v<R, intaglio::raster::SineEllipse>) wrong = of_sines[load];
    if (std::is_same_v<R, intaglio::raster::RowEllipse>) wrong = 0;
    return number::wrong_pixels(1000 * wrong);
  }
};

}  // namespace lab
