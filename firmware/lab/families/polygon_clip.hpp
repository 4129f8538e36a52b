// SPDX-License-Identifier: MIT
//
// The family of polygon clippers: what of a polygon lies inside a convex window of eight sides. The simplest
// knows convex windows alone and rounds new vertices to 1/256 pixel; the others take any two polygons and
// stay exact.
#pragma once

#include <intaglio/clip/polygon_rungs.hpp>
#include <intaglio/linear/point.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/number/sine.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/lab/family.hpp>
#include <span>
#include <string_view>

namespace lab {

/// A window and a polygon around it, from their number.
class WindowAndPolygon {
 public:
  constexpr WindowAndPolygon() noexcept = default;
  constexpr WindowAndPolygon(int vertices, std::uint32_t seed) noexcept
      : count_(static_cast<std::size_t>(vertices)) {
    Random random(seed);
    const auto middle = [&] {
      return intaglio::linear::SubPoint{random.between(140 * 256, 180 * 256),
                                        random.between(100 * 256, 140 * 256)};
    };
    around(middle(), window_, [] { return 60 * 256 + 77; });
    around(middle(), std::span(polygon_).first(count_), [&] { return random.between(20 * 256, 110 * 256); });
  }
  [[nodiscard]] constexpr std::span<const intaglio::linear::SubPoint> window() const noexcept {
    return window_;
  }
  [[nodiscard]] constexpr std::span<const intaglio::linear::SubPoint> polygon() const noexcept {
    return std::span(polygon_).first(count_);
  }

 private:
  template <class Reach>
  static constexpr void around(intaglio::linear::SubPoint middle,
                               std::span<intaglio::linear::SubPoint> vertices, Reach reach) noexcept {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const auto angle = number::Angle::from_ratio(static_cast<int>(i), static_cast<int>(vertices.size()));
      const std::int64_t far = reach();
      vertices[i] = {middle.x + static_cast<int>(far * number::cosine(angle).raw() / 32768),
                     middle.y + static_cast<int>(far * number::sine(angle).raw() / 32768)};
    }
  }

  std::array<intaglio::linear::SubPoint, 8> window_{};
  std::array<intaglio::linear::SubPoint, 32> polygon_{};
  std::size_t count_ = 0;
};

/// The contours that are left, in a rung's vertices.
template <class R>
struct ClippedContours {
  std::span<const typename R::Vertex> vertices;
  std::span<const int> lengths;
  bool ok = false;
};

struct PolygonClip {
  static constexpr std::string_view name = "polygon-clip";
  static constexpr std::string_view title = "Clipping a polygon to a convex window (area off, in pixels)";
  using Rungs = intaglio::clip::PolygonClipFamily;
  using Default = intaglio::clip::SutherlandHodgman;
  static constexpr Load loads[] = {{"6 vertices", 8}, {"32 vertices", 2}};

  using Input = WindowAndPolygon;
  static constexpr int vertices_of(int load) noexcept { return load == 0 ? 6 : 32; }
  static Input input(int load, int i) noexcept {
    return {vertices_of(load), static_cast<std::uint32_t>(i + 1)};
  }
  template <class R>
  static ClippedContours<R> clipped(const Input& input) noexcept {
    static std::array<typename R::Vertex, 128> vertices;
    static std::array<int, 32> lengths;
    static std::array<typename R::Cell, 256> workspace;
    const auto made = R{}(input.polygon(), input.window(), vertices, lengths, workspace);
    if (!made.ok()) return {};
    return {std::span(vertices).first(made.value().vertices), std::span(lengths).first(made.value().contours),
            true};
  }
  template <class R>
  static std::uint32_t run(const Input& input) noexcept {
    const auto left = clipped<R>(input);
    return left.ok ? static_cast<std::uint32_t>(left.vertices.size()) : 0xFFFF'FFFFU;
  }

  /// The area that rounding takes or adds: each new vertex is off by at most 1/512 pixel on each axis, so by
  /// 0.0028; along the boundary, up to 800 pixels here, that is 2.2 of area.
  template <class R>
  static constexpr number::Bound bound(int /*load*/) noexcept {
    return number::pixels(R::bound.exact() ? 0 : 2'200);
  }
  template <class R>
  static constexpr std::string_view slack() noexcept {
    return R::bound.exact() ? "" : "it adds up what all vertices may be off in one direction";
  }
};

}  // namespace lab
