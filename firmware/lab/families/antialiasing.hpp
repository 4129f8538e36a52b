// SPDX-License-Identifier: MIT
//
// The family of antialiasing: how much of each pixel a triangle covers, from none at all to the exact area.
// Samples s by s are the textbook's supersampling; of 3 by 3 it has a box and a Bartlett window.
//
// Each rung draws under the triangle's bounding box, as a program would.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/smooth_triangle_rungs.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>
#include <type_traits>

namespace lab {

namespace raster = intaglio::raster;

struct Antialiasing {
  static constexpr std::string_view name = "antialiasing";
  static constexpr std::string_view title = "Filling a triangle with smooth edges";
  using Rungs = raster::SmoothTriangleFamily;
  using Default = raster::ExactArea;
  static constexpr Load loads[] = {{"triangles, where one edge is in a pixel", 3},
                                   {"needles, everywhere", 3}};

  struct Input {
    raster::TriangleCorners triangle;
    intaglio::linear::Rect box;
  };
  /// The triangle that follows from a number: of some 40 pixels (every fourth with edges along rows and
  /// columns, every fourth along diagonals), or a needle up to two pixels wide.
  static Input triangle(int load, std::uint32_t seed) noexcept {
    using intaglio::linear::SubPoint;
    Random random(seed);
    const SubPoint a{random.between(20 * 256, 30 * 256), random.between(20 * 256, 30 * 256)};
    raster::TriangleCorners t{a, a, a};
    const auto near = [&](int reach) {
      return SubPoint{a.x + random.between(-reach, reach), a.y + random.between(-reach, reach)};
    };
    const int size = random.between(4 * 256, 20 * 256);
    if (load == 1) {
      t[1] = near(20 * 256);
      t[2] = {t[1].x + random.between(-512, 512), t[1].y + random.between(-512, 512)};
    } else if (seed % 4 == 0) {
      t[1].x += size;
      t[2].y += random.between(4 * 256, 20 * 256);
    } else if (seed % 4 == 1) {
      t[1] = {a.x + size, a.y + size};
      t[2] = {a.x + size, a.y - size};
    } else {
      t[1] = near(20 * 256);
      t[2] = near(20 * 256);
    }
    const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
    const int x = (left + 128) >> 8;
    const int y = (top + 128) >> 8;
    return {t, {x, y, ((right + 128) >> 8) + 1 - x, ((bottom + 128) >> 8) + 1 - y}};
  }
  static Input input(int load, int i) noexcept { return triangle(load, static_cast<std::uint32_t>(i + 1)); }

  /// Draws on a sink, with memory for clips as wide as the canvas; samples have some for 16 rows.
  template <class R, class S>
  static bool draw(S& sink, const raster::TriangleCorners& triangle) noexcept {
    static std::array<typename R::Cell, std::size_t{16} * 320> workspace;
    return R{}(sink, triangle, workspace).ok();
  }
  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    auto ramp = raster::RampCoverage<image::Indexed8>::over(canvas(), 0, 256, in.box);
    return ramp.ok() && draw<R>(ramp.value(), in.triangle) ? 1 : 0;
  }

  /// With one edge in a pixel: 1/(2*s) of it for s by s samples, and half a level (supersample.hpp has it,
  /// and what Bartlett's window adds); m/8 for Pitteway and Watkinson (pitteway.hpp). Anywhere: of a convex
  /// shape each of s rows has a sample too many or too few at most, 1/s of all; and as the rows' chords grow
  /// and then shrink, their sum is at most 1/s off the area.
  template <class R>
  static constexpr number::Bound bound(int load) noexcept {
    if (load == 1 || std::is_same_v<R, raster::ExactArea>) return R::bound;
    if (std::is_same_v<R, raster::NoAntialiasing>) return number::coverage_levels(127'500);
    if (std::is_same_v<R, raster::Samples2x2> || std::is_same_v<R, raster::Bartlett3x3>)
      return number::coverage_levels(64'250);
    if (std::is_same_v<R, raster::Samples3x3>) return number::coverage_levels(43'000);
    if (std::is_same_v<R, raster::Samples15x17>) return number::coverage_levels(8'500);
    return number::coverage_levels(32'400);
  }
};

}  // namespace lab
