// SPDX-License-Identifier: MIT
//
// What a counted row is made of: a name and one call, with arguments the compiler knows nothing about.
#pragma once

#include <intaglio/image/surface.hpp>
#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/number/sine.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/status.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace boards::mps2 {

namespace image = intaglio::image;
namespace linear = intaglio::linear;
namespace number = intaglio::number;
namespace raster = intaglio::raster;

using intaglio::Status;
using linear::Point;
using linear::Rect;
using linear::SubPoint;
using Format = image::Indexed8;
using Pen = raster::Solid<Format>;

/// One counted call.
struct Row {
  const char* name;
  void (*draw)(const Pen& pen);
  /// Where the limit counts more than pixels (crossings, say): how many of them there are, counted after the
  /// call.
  std::uint32_t (*units)(const Pen& pen) = nullptr;
};

/// The same primitive twice: as large as fills the window, and a million pixels large.
struct Pair {
  const char* name;
  void (*filling)(const Pen& pen);
  void (*far)(const Pen& pen);
};

extern const std::span<const Row> basic_rows;
extern const std::span<const Row> line_rows;
extern const std::span<const Row> curve_rows;
extern const std::span<const Row> polygon_rows;
extern const std::span<const Row> composed_rows;
extern const std::span<const Row> picture_rows;
extern const std::span<const Row> smooth_rows;
extern const std::span<const Pair> pairs;

/// A value that the compiler knows nothing about.
inline int opaque(int value) noexcept {
  asm volatile("" : "+r"(value));
  return value;
}
inline Point opaque(Point p) noexcept { return {opaque(p.x), opaque(p.y)}; }
inline SubPoint opaque(SubPoint p) noexcept { return {opaque(p.x), opaque(p.y)}; }
inline Rect opaque(const Rect& r) noexcept {
  return {opaque(r.x), opaque(r.y), opaque(r.width), opaque(r.height)};
}

inline void use(Status status) noexcept { asm volatile("" : : "r"(status)); }
inline void use(std::uint32_t value) noexcept { asm volatile("" : : "r"(value)); }

/// N vertices around a middle, by turns this far from it and that (in 1/256 pixel).
template <std::size_t N>
constexpr std::array<SubPoint, N> gear(SubPoint middle, int outer, int inner) noexcept {
  std::array<SubPoint, N> vertices{};
  for (std::size_t i = 0; i < N; ++i) {
    const auto angle = number::Angle::from_ratio(static_cast<int>(i), static_cast<int>(N));
    const int reach = i % 2 == 0 ? outer : inner;
    vertices[i] = {middle.x + static_cast<int>(std::int64_t{reach} * number::cosine(angle).raw() >> 15),
                   middle.y + static_cast<int>(std::int64_t{reach} * number::sine(angle).raw() >> 15)};
  }
  return vertices;
}

}  // namespace boards::mps2
