// SPDX-License-Identifier: MIT
//
// The family of polygon fills: any contour, crossing itself or not. All rungs are exact; they differ in time
// and memory.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/polygon_basic.hpp>
#include <intaglio/raster/polygon_critical.hpp>
#include <intaglio/raster/solid.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/lab/family.hpp>
#include <span>
#include <string_view>

namespace lab {

/// An edge table and an active edge table.
struct ScanlineFill {
  static constexpr number::Bound bound = number::exactly(number::Unit::wrong_pixel);
  template <class S>
  intaglio::Status operator()(const S& sink,
                              std::span<const intaglio::linear::SubPoint> vertices) const noexcept {
    static std::array<intaglio::raster::PolygonEdge, 128> edges;
    return intaglio::raster::fill_polygon(sink, intaglio::raster::FillRule::even_odd, vertices, edges);
  }
};

/// Chains of edges from each local minimum.
struct CriticalPointsFill {
  static constexpr number::Bound bound = ScanlineFill::bound;
  template <class S>
  intaglio::Status operator()(const S& sink,
                              std::span<const intaglio::linear::SubPoint> vertices) const noexcept {
    static std::array<intaglio::raster::PolygonChain, 128> chains;
    const int length = static_cast<int>(vertices.size());
    return intaglio::raster::fill_polygon_critical(sink, intaglio::raster::FillRule::even_odd, vertices,
                                                   std::span<const int>(&length, 1), chains);
  }
};

/// All crossings of each row, reckoned anew and sorted.
struct BasicFill {
  static constexpr number::Bound bound = ScanlineFill::bound;
  template <class S>
  intaglio::Status operator()(const S& sink,
                              std::span<const intaglio::linear::SubPoint> vertices) const noexcept {
    static std::array<intaglio::raster::PolygonCrossing, 128> crossings;
    const int length = static_cast<int>(vertices.size());
    return intaglio::raster::fill_polygon_basic(sink, intaglio::raster::FillRule::even_odd, vertices,
                                                std::span<const int>(&length, 1), crossings);
  }
};

struct PolygonFill {
  static constexpr std::string_view name = "polygon-fill";
  static constexpr std::string_view title = "Filling a polygon";
  using Rungs = number::Family<ScanlineFill, CriticalPointsFill, BasicFill>;
  using Default = ScanlineFill;
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
    const intaglio::raster::Solid<image::Indexed8> pen(canvas(), 1);
    return R{}(pen, polygon.vertices()).ok() ? 1 : 0;
  }
};

}  // namespace lab
