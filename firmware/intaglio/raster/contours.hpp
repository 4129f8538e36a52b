// SPDX-License-Identifier: MIT
//
// Polygons as arguments: one array of vertices, cut into contours by their lengths, and a rule that says what
// is inside. What every function that takes a polygon checks before it reads a coordinate.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/status.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::raster {

/// What is inside a contour that winds around a place more than once.
enum class FillRule : std::uint8_t {
  even_odd,  ///< Places that an odd number of turns winds around.
  non_zero,  ///< Places that the turns to one side and to the other don't cancel at.
};

namespace detail {

/// The bits of a winding number that mean inside; 0 for a rule that isn't one.
[[nodiscard]] constexpr int winding_mask(FillRule rule) noexcept {
  return rule == FillRule::even_odd ? 1 : rule == FillRule::non_zero ? -1 : 0;
}

/// Errors: contours (lengths that are negative or don't add up to the number of vertices: mismatched),
/// vertices (one is outside the domain).
[[nodiscard]] inline Status check_contours(const std::span<const linear::SubPoint>& vertices,
                                           const std::span<const int>& contour_lengths) noexcept {
  std::size_t rest = vertices.size();
  for (const int length : contour_lengths) {
    // As an unsigned number a negative length is beyond any rest.
    if (static_cast<std::size_t>(length) > rest) return {Error::mismatched, Argument::contours};
    rest -= static_cast<std::size_t>(length);
  }
  if (rest != 0) return {Error::mismatched, Argument::contours};
  for (const linear::SubPoint& vertex : vertices)
    if (!linear::in_domain(vertex)) return {Error::out_of_domain, Argument::vertices};
  return {};
}

/// The least and the greatest coordinates of some vertices.
struct VertexBox {
  linear::SubPoint least;
  linear::SubPoint most;
};

/// The box of vertices inside the domain. Of none: `least` is right of and below `most`.
[[nodiscard]] inline VertexBox vertex_box(const std::span<const linear::SubPoint>& vertices) noexcept {
  constexpr int limit = linear::coordinate_limit * linear::subpixel_one;
  VertexBox box{{limit, limit}, {-limit, -limit}};
  for (const linear::SubPoint& vertex : vertices) {
    box.least = {std::min(box.least.x, vertex.x), std::min(box.least.y, vertex.y)};
    box.most = {std::max(box.most.x, vertex.x), std::max(box.most.y, vertex.y)};
  }
  return box;
}

}  // namespace detail
}  // namespace intaglio::raster
