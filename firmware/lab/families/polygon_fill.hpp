// SPDX-License-Identifier: MIT
//
// The family of polygon fills: any contour, crossing itself or not. All rungs are exact; they differ in time
// and memory.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/raster/polygon_rungs.hpp>
#include <intaglio/raster/solid.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/lab/family.hpp>
#include <span>
#include <string_view>

namespace lab {

/// Fills a polygon on the canvas by a rung; 1 if it could.
template <class R>
[[nodiscard]] std::uint32_t fill_on_canvas(std::span<const intaglio::linear::SubPoint> vertices) noexcept {
  static std::array<typename R::Cell, 128> workspace;
  const intaglio::raster::Solid<image::Indexed8> pen(canvas(), 1);
  return R{}(pen, intaglio::raster::FillRule::even_odd, vertices, workspace).ok() ? 1 : 0;
}

struct PolygonFill {
  static constexpr std::string_view name = "polygon-fill";
  static constexpr std::string_view title = "Filling a polygon";
  using Rungs = intaglio::raster::PolygonFamily;
  using Default = intaglio::raster::ScanlineFill;
  static constexpr Load loads[] = {
      {"triangles to pentagons", 16}, {"hands and needles", 16}, {"100 vertices at random", 2}};

  /// The polygon that follows from a number.
  class Input {
   public:
    constexpr Input() noexcept = default;
    constexpr Input(int load, std::uint32_t seed) noexcept {
      Random random(seed);
      if (load == 0) count_ = static_cast<std::size_t>(random.between(3, 5));
      if (load == 1) count_ = 4;
      if (load == 2) count_ = most;
      const intaglio::linear::SubPoint middle{random.between(40 * 256, 280 * 256),
                                              random.between(40 * 256, 200 * 256)};
      for (std::size_t i = 0; i < count_; ++i) {
        // A needle is a quadrilateral three pixels wide and up to 100 long; others lie anywhere about the
        // middle.
        const int reach = load == 0 ? 40 * 256 : 20'000;
        vertices_[i] = load == 1 && i % 2 == 1
                           ? intaglio::linear::SubPoint{vertices_[i - 1].x + 500, vertices_[i - 1].y + 600}
                           : intaglio::linear::SubPoint{middle.x + random.between(-reach, reach),
                                                        middle.y + random.between(-reach, reach)};
      }
    }
    [[nodiscard]] constexpr std::span<const intaglio::linear::SubPoint> vertices() const noexcept {
      return {vertices_.data(), count_};
    }

   private:
    static constexpr std::size_t most = 100;
    std::array<intaglio::linear::SubPoint, most> vertices_{};
    std::size_t count_ = 0;
  };

  static Input input(int load, int i) noexcept { return {load, static_cast<std::uint32_t>(i + 1)}; }
  template <class R>
  static std::uint32_t run(const Input& polygon) noexcept {
    return fill_on_canvas<R>(polygon.vertices());
  }
};

}  // namespace lab
