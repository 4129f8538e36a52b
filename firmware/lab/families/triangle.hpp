// SPDX-License-Identifier: MIT
//
// The family of filled triangles: with vertices snapped to 0, 4 or 8 fraction bits, by walking edges or by
// edge functions in 32 or 64 bits. Whatever the snapping, triangles that share an edge share no pixel.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/linear/sub_rect.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/raster/triangle.hpp>
#include <intaglio/raster/triangle_box.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>
#include <type_traits>
#include <utility>

namespace lab {

using Corners = std::array<intaglio::linear::SubPoint, 3>;

/// How many pixels a triangle may have wrong whose sides are so long along their longer axis, together.
[[nodiscard]] constexpr number::Bound wrong_along_sides(int length) noexcept {
  return {(length + 6) * 1000, number::Unit::wrong_pixel};
}

/// Vertices rounded to whole pixels; edges walked exactly.
struct WalkSnapped0 {
  static constexpr number::Bound bound = wrong_along_sides(3 * 300);
  template <class S>
  bool operator()(const S& sink, const Corners& t) const noexcept {
    using intaglio::linear::to_pixel_nearest;
    return intaglio::raster::fill_triangle(sink, to_pixel_nearest(t[0]), to_pixel_nearest(t[1]),
                                           to_pixel_nearest(t[2]))
        .ok();
  }
};

/// The nearest 1/16 pixel, in sixteenths.
[[nodiscard]] constexpr intaglio::linear::SubPoint in_sixteenths(intaglio::linear::SubPoint p) noexcept {
  return {(p.x + 8) >> 4, (p.y + 8) >> 4};
}

/// Vertices rounded to 1/16 pixel; edges walked exactly.
struct WalkSnapped4 {
  static constexpr number::Bound bound = WalkSnapped0::bound;
  static constexpr std::string_view slack =
      "the two long sides of a sliver would both have to run along pixel centres";
  template <class S>
  bool operator()(const S& sink, const Corners& t) const noexcept {
    Corners snapped = t;
    for (auto& p : snapped) {
      const auto in_16 = in_sixteenths(p);
      p = {in_16.x * 16, in_16.y * 16};
    }
    return intaglio::raster::fill_triangle(sink, snapped[0], snapped[1], snapped[2]).ok();
  }
};

/// The library's: vertices to 1/256 pixel, edges walked exactly.
struct WalkExact {
  static constexpr number::Bound bound = number::exactly(number::Unit::wrong_pixel);
  template <class S>
  bool operator()(const S& sink, const Corners& t) const noexcept {
    return intaglio::raster::fill_triangle(sink, t[0], t[1], t[2]).ok();
  }
};

/// Edge functions set up and stepped in 32 bits, vertices rounded to 1/16 pixel: for coordinates within 2^13
/// pixels and bounding boxes below 2,048 pixels each way, so that a product stays below 2^30.
struct Box32Snapped4 {
  static constexpr number::Bound bound = WalkSnapped0::bound;
  static constexpr std::string_view slack = WalkSnapped4::slack;
  template <class S>
  bool operator()(const S& sink, const Corners& t) const noexcept {
    using intaglio::linear::SubPoint;
    constexpr int most = 2'047 * 16;
    std::array<SubPoint, 3> v{in_sixteenths(t[0]), in_sixteenths(t[1]), in_sixteenths(t[2])};
    const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
    if (right - left > most || bottom - top > most) return false;
    const int twice_area = (v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[1].y - v[0].y) * (v[2].x - v[0].x);
    if (twice_area == 0) return true;
    if (twice_area < 0) std::swap(v[1], v[2]);
    const auto up = [](int c) { return (c + 15) >> 4; };
    intaglio::raster::detail::TriangleBox triangle{};
    triangle.box = intersect(sink.clip(), {up(left), up(top), up(right) - up(left), up(bottom) - up(top)});
    if (triangle.box.empty()) return true;
    for (std::size_t i = 0; i < 3; ++i) {
      const SubPoint a = v[i];
      const SubPoint b = v[(i + 1) % 3];
      const int dx = b.x - a.x;
      const int dy = b.y - a.y;
      const bool owns_zero = dy < 0 || (dy == 0 && dx > 0);
      const int value =
          dx * (triangle.box.y * 16 - a.y) - dy * (triangle.box.x * 16 - a.x) - (owns_zero ? 0 : 1);
      triangle.edges[i] = {value >> 4, -dy, dx};
    }
    intaglio::raster::detail::triangle_by_pixels<std::int32_t>(sink, triangle);
    return true;
  }
};

/// Edge functions of 1/256 pixel, set up in 64 bits and stepped in so many.
template <class Int>
struct BoxExact {
  static constexpr number::Bound bound = WalkExact::bound;
  template <class S>
  bool operator()(const S& sink, const Corners& t) const noexcept {
    intaglio::raster::detail::TriangleBox triangle;
    if (!intaglio::raster::detail::triangle_box(t, sink.clip(), triangle).ok()) return false;
    if (std::is_same_v<Int, std::int32_t> && !triangle.narrow) return triangle.box.empty();
    intaglio::raster::detail::triangle_by_pixels<Int>(sink, triangle);
    return true;
  }
};
/// For bounding boxes up to 2,032 pixels each way.
struct Box32 : BoxExact<std::int32_t> {};
struct Box64 : BoxExact<std::int64_t> {};

/// Edge functions at the corners of blocks of 8x8 pixels first.
struct Blocks {
  static constexpr number::Bound bound = WalkExact::bound;
  template <class S>
  bool operator()(const S& sink, const Corners& t) const noexcept {
    return intaglio::raster::fill_triangle_blocks(sink, t[0], t[1], t[2]).ok();
  }
};

struct Triangle {
  static constexpr std::string_view name = "triangle";
  static constexpr std::string_view title = "Filling a triangle";
  using Rungs = number::Family<WalkSnapped0, WalkSnapped4, WalkExact, Blocks, Box32Snapped4, Box32, Box64>;
  using Default = WalkExact;
  static constexpr Load loads[] = {
      {"sides up to 60 pixels", 8}, {"slivers", 8}, {"sides up to 300 pixels", 3}};
  static constexpr int longest[] = {60, 100, 300};

  using Input = Corners;
  static Input input(int load, int i) noexcept {
    using intaglio::linear::SubPoint;
    Random random(static_cast<std::uint32_t>(i + 1));
    const int reach = longest[load] * 128;
    const SubPoint middle{160 * 256 + random.between(-9'999, 9'999),
                          120 * 256 + random.between(-9'999, 9'999)};
    Corners t{};
    for (SubPoint& p : t)
      p = {middle.x + random.between(-reach, reach), middle.y + random.between(-reach, reach)};
    if (load == 1) t[2] = {t[1].x + random.between(-500, 500), t[1].y + random.between(-500, 500)};
    return t;
  }
  template <class R>
  static std::uint32_t run(const Input& corners) noexcept {
    return R{}(intaglio::raster::Solid<image::Indexed8>(canvas(), 1), corners) ? 1 : 0;
  }

  /// A side whose ends move by half a pixel or less each way moves by a pixel or less along its minor axis:
  /// so at each step of the other axis, and of one more at either end, one pixel is wrong at most. So it is
  /// where all sides go through pixel centres but for a bit. The short side of a sliver is up to two pixels.
  template <class R>
  static constexpr number::Bound bound(int load) noexcept {
    constexpr int sides[] = {3 * 60, 2 * 102 + 2, 3 * 300};
    return R::bound.exact() ? R::bound : wrong_along_sides(sides[load]);
  }
};

}  // namespace lab
