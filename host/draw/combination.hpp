// SPDX-License-Identifier: MIT
//
// Two polygons combined: the exact result as text, and its pixels.
#pragma once

#include <intaglio/clip/boolean.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/polygon.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace host::draw {

namespace linear = intaglio::linear;

/// A set of places made of two contours, each filled by even-odd.
struct Combination {
  intaglio::clip::BooleanRule rule{};
  std::vector<linear::SubPoint> a, b;
};

/// One line a contour, `contour x y x y …`, then `area N/D`: pixels and square pixels as fractions in lowest
/// terms. Sets `status` and answers "" if the library refuses the polygons.
std::string describe(const Combination& combination, intaglio::Status& status);

/// A sink that keeps one flag a pixel.
class Mask {
 public:
  explicit Mask(const linear::Rect& clip)
      : clip_(clip), flags_(static_cast<std::size_t>(clip.width) * static_cast<std::size_t>(clip.height)) {}

  [[nodiscard]] const linear::Rect& clip() const { return clip_; }
  void span(int y, int x_begin, int x_end) {
    for (int x = x_begin; x < x_end; ++x) flags_[index(x, y)] = 1;
  }
  [[nodiscard]] bool has(int x, int y) const { return flags_[index(x, y)] != 0; }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - clip_.y) * static_cast<std::size_t>(clip_.width) +
           static_cast<std::size_t>(x - clip_.x);
  }
  linear::Rect clip_;
  std::vector<std::uint8_t> flags_;
};

/// Draws the pixels whose centres are in the set: exactly, since each operand is filled by itself and no
/// vertex of the result is rounded.
template <class Sink>
intaglio::Status fill_combination(Sink& sink, const Combination& combination) {
  Mask a(sink.clip());
  Mask b(sink.clip());
  for (const bool second : {false, true}) {
    const auto& vertices = second ? combination.b : combination.a;
    std::vector<intaglio::raster::PolygonEdge> workspace(vertices.size());
    const auto status =
        fill_polygon(second ? b : a, intaglio::raster::FillRule::even_odd, vertices, workspace);
    if (!status.ok()) return status;
  }
  const linear::Rect clip = sink.clip();
  for (int y = clip.y; y < clip.bottom(); ++y) {
    int begin = clip.x;
    for (int x = clip.x; x <= clip.right(); ++x) {
      if (x < clip.right() && taken(combination.rule, a.has(x, y), b.has(x, y))) continue;
      if (x > begin) sink.span(y, begin, x);
      begin = x + 1;
    }
  }
  return {};
}

}  // namespace host::draw
