// SPDX-License-Identifier: MIT
//
// Ways to fill a triangle: rungs that differ in how exactly they take its vertices, and how they find pixels.
//
// Rule: pixels whose centres are inside, by the top-left rule (triangle.hpp), of a triangle whose vertices
// are rounded first: to whole pixels (`WalkSnapped0`), to 1/16 pixel (`WalkSnapped4`, `Box32Snapped4`) or not
// at all. `Walk...` step edges from row to row, `Box...` edge functions over the bounding box
// (triangle_box.hpp), `Blocks` those at the corners of blocks of 8x8 pixels first. Whatever the rounding,
// triangles that share an edge share no pixel and leave no gap.
//
// Error: how far the outline is from the true one, in pixels. A vertex moves by half a unit along each axis
// at most, so by 0.70711 or 0.04420 pixel, and no place of a side moves further than its ends do. Bit budget:
// the functions' own; `Box32Snapped4`, set up in 32 bits, has products below 2^30, as bounding boxes are
// below 2^15 sixteenths each way. Textbook: section 2.6. Worst known inputs: sides along pixel centres but
// for a bit, of which whole pixels may be wrong all along.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/linear/sub_rect.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/raster/triangle.hpp>
#include <intaglio/raster/triangle_box.hpp>
#include <intaglio/status.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace intaglio::raster {

/// Fills the triangle a, b, c (in 1/256 pixel, |c| <= 2^28) with its vertices rounded to whole pixels.
/// Errors and cost as `fill_triangle`.
struct WalkSnapped0 {
  static constexpr number::Bound bound = number::pixels(708);
  template <SpanSink S>
  Status operator()(S&& sink, linear::SubPoint a, linear::SubPoint b, linear::SubPoint c) const {
    using linear::to_pixel_nearest;
    if (!linear::in_domain(a) || !linear::in_domain(b) || !linear::in_domain(c))
      return {Error::out_of_domain, Argument::point};
    return fill_triangle(sink, to_pixel_nearest(a), to_pixel_nearest(b), to_pixel_nearest(c));
  }
};

namespace detail {

/// The nearest 1/16 pixel to a place in the domain, in sixteenths.
[[nodiscard]] constexpr linear::SubPoint in_sixteenths(linear::SubPoint p) noexcept {
  return {(p.x + 8) >> 4, (p.y + 8) >> 4};
}

}  // namespace detail

/// The same, rounded to 1/16 pixel.
struct WalkSnapped4 {
  static constexpr number::Bound bound = number::pixels(45);
  template <SpanSink S>
  Status operator()(S&& sink, linear::SubPoint a, linear::SubPoint b, linear::SubPoint c) const {
    if (!linear::in_domain(a) || !linear::in_domain(b) || !linear::in_domain(c))
      return {Error::out_of_domain, Argument::point};
    const auto snapped = [](linear::SubPoint p) {
      const linear::SubPoint in_16 = detail::in_sixteenths(p);
      return linear::SubPoint{in_16.x * 16, in_16.y * 16};
    };
    return fill_triangle(sink, snapped(a), snapped(b), snapped(c));
  }
};

/// The library's: `fill_triangle`.
struct WalkExact {
  static constexpr number::Bound bound = number::exactly(number::Unit::pixel);
  template <SpanSink S>
  Status operator()(S&& sink, linear::SubPoint a, linear::SubPoint b, linear::SubPoint c) const {
    return fill_triangle(sink, a, b, c);
  }
};

/// Edge functions set up and stepped in 32 bits, vertices rounded to 1/16 pixel. Errors: as `fill_triangle`,
/// and vertices, too_large, for bounding boxes of more than 2,047 pixels each way.
struct Box32Snapped4 {
  static constexpr std::string_view domain = "bounding boxes of up to 2,047 pixels";
  static constexpr number::Bound bound = WalkSnapped4::bound;
  /// The longest side of a bounding box.
  static constexpr int most = 2'047;

  template <SpanSink S>
  Status operator()(S&& sink, linear::SubPoint a, linear::SubPoint b, linear::SubPoint c) const {
    if (!linear::in_domain(a) || !linear::in_domain(b) || !linear::in_domain(c))
      return {Error::out_of_domain, Argument::point};
    std::array<linear::SubPoint, 3> v{detail::in_sixteenths(a), detail::in_sixteenths(b),
                                      detail::in_sixteenths(c)};
    const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
    if (right - left > most * 16 || bottom - top > most * 16)
      return {Error::too_large, Argument::vertices, most};
    const int twice_area = (v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[1].y - v[0].y) * (v[2].x - v[0].x);
    if (twice_area == 0) return {};
    if (twice_area < 0) std::swap(v[1], v[2]);
    const auto up = [](int coordinate) { return (coordinate + 15) >> 4; };
    detail::TriangleBox triangle{};
    triangle.box = intersect(sink.clip(), {up(left), up(top), up(right) - up(left), up(bottom) - up(top)});
    if (triangle.box.empty()) return {};
    for (std::size_t i = 0; i < 3; ++i) {
      const linear::SubPoint from = v[i];
      const linear::SubPoint to = v[(i + 1) % 3];
      const int dx = to.x - from.x;
      const int dy = to.y - from.y;
      const bool owns_zero = dy < 0 || (dy == 0 && dx > 0);
      const int value =
          dx * (triangle.box.y * 16 - from.y) - dy * (triangle.box.x * 16 - from.x) - (owns_zero ? 0 : 1);
      triangle.edges[i] = {value >> 4, -dy, dx};
    }
    detail::triangle_by_pixels<std::int32_t>(sink, triangle);
    return {};
  }
};

namespace detail {

/// Edge functions of 1/256 pixel, set up in 64 bits and stepped in so many.
template <class Int>
struct BoxRung {
  static constexpr number::Bound bound = WalkExact::bound;
  template <SpanSink S>
  Status operator()(S&& sink, linear::SubPoint a, linear::SubPoint b, linear::SubPoint c) const {
    TriangleBox triangle;
    const Status status = triangle_box({a, b, c}, sink.clip(), triangle);
    if (!status.ok()) return status;
    if constexpr (std::same_as<Int, std::int32_t>) {
      if (!triangle.narrow && !triangle.box.empty()) return {Error::too_large, Argument::vertices, 2'032};
    }
    triangle_by_pixels<Int>(sink, triangle);
    return {};
  }
};

}  // namespace detail

/// Edge functions stepped in 32 bits. Errors: as `fill_triangle`, and vertices, too_large, for bounding boxes
/// of more than 2,032 pixels each way.
struct Box32 : detail::BoxRung<std::int32_t> {
  static constexpr std::string_view domain = "bounding boxes of up to 2,032 pixels";
};
/// Edge functions stepped in 64 bits; takes what `fill_triangle` takes.
struct Box64 : detail::BoxRung<std::int64_t> {};

/// `fill_triangle_blocks`.
struct Blocks {
  static constexpr number::Bound bound = WalkExact::bound;
  template <SpanSink S>
  Status operator()(S&& sink, linear::SubPoint a, linear::SubPoint b, linear::SubPoint c) const {
    return fill_triangle_blocks(sink, a, b, c);
  }
};

/// The rungs of triangles, cheapest first.
using TriangleFamily =
    number::Family<WalkSnapped0, WalkSnapped4, WalkExact, Blocks, Box32Snapped4, Box32, Box64>;

}  // namespace intaglio::raster
