// SPDX-License-Identifier: MIT
//
// Ways to draw the outline of a circle: by cursors, by the midpoint's error in 16, 32 and 64 bits, and by a
// table of sines.
//
// Rule: the pixels of circle.hpp, each once. `CursorCircle` is its `draw_circle`; the others go around all of
// an octant, visible or not, so their cost grows with the radius. `MidpointCircle...` step the error
// x^2 + y^2 - y - r^2 of the pixel (x, y); `SineCircle` takes as many points of the octant as it has columns
// and one more, each rounded to a pixel.
//
// Error: pixels that are wrong, of one circle; those of sines by trying all radii. Bit budget: the midpoint's
// |error| < 2*r + 8, so 16 bits hold up to the radius 16,383. Of sines: points are less than a pixel apart up
// to the radius 1,024, so that no column lacks one (0.79 pixel, and an angle's last place, 0.1, and two of
// the sine's, 0.06). Textbook: section 2.4. Worst known input: the radius 984 by sines, of whose 5,564 pixels
// and as many points 1,160 differ.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/number/sine.hpp>
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/mirrored_pixels.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

#include <cstdint>
#include <string_view>

namespace intaglio::raster {

/// The library's: `draw_circle`.
struct CursorCircle {
  static constexpr number::Bound bound = number::exactly(number::Unit::wrong_pixel);
  template <SpanSink S>
  Status operator()(S&& sink, linear::Point centre, int radius) const {
    return draw_circle(sink, centre, radius);
  }
};

namespace detail {

/// The error of the octant, in so many bits.
template <class Int, int most_radius>
struct MidpointCircle {
  static constexpr number::Bound bound = CursorCircle::bound;
  /// The largest radius.
  static constexpr int most = most_radius;

  /// Errors: as `draw_circle`; too_large radius.
  template <SpanSink S>
  Status operator()(S&& sink, linear::Point centre, int radius) const {
    const Status status = at_most(check_circle(centre, radius), radius, most);
    if (!status.ok()) return status;
    const linear::Rect clip = sink.clip();
    Int x = 0;
    auto y = static_cast<Int>(radius);
    auto error = static_cast<Int>(-radius);
    while (x <= y) {
      put_octants(sink, clip, centre, static_cast<int>(x), static_cast<int>(y));
      error = static_cast<Int>(error + 2 * x + 1);
      ++x;
      if (error >= 0) {
        --y;
        error = static_cast<Int>(error - 2 * y);
      }
    }
    return {};
  }
};

}  // namespace detail

struct MidpointCircle16 : detail::MidpointCircle<std::int16_t, 16'383> {
  static constexpr std::string_view domain = "radius up to 16,383";
};
struct MidpointCircle32 : detail::MidpointCircle<std::int32_t, linear::coordinate_limit> {};
struct MidpointCircle64 : detail::MidpointCircle<std::int64_t, linear::coordinate_limit> {};

/// By a table of sines.
struct SineCircle {
  static constexpr number::Bound bound = number::wrong_pixels(1'160'000);
  static constexpr std::string_view domain = "radius up to 1,024";
  /// The largest radius.
  static constexpr int most = 1'024;

  /// Errors: as `draw_circle`; too_large radius.
  template <SpanSink S>
  Status operator()(S&& sink, linear::Point centre, int radius) const {
    const Status status = detail::at_most(detail::check_circle(centre, radius), radius, most);
    if (!status.ok()) return status;
    const linear::Rect clip = sink.clip();
    constexpr unsigned octant = 8192U << 16U;
    const unsigned points = static_cast<unsigned>(radius) + 1;
    const unsigned step = octant / points;
    const auto scaled = [radius](int sine) { return (radius * sine + (1 << 14)) >> 15; };
    linear::Point before{-1, -1};
    for (unsigned i = 0, angle = 0; i <= points; ++i, angle += step) {
      const auto turn = number::Angle::from_steps(static_cast<int>(angle >> 16U));
      const linear::Point place{scaled(number::sine(turn).raw()), scaled(number::cosine(turn).raw())};
      if (place != before) detail::put_octants(sink, clip, centre, place.x, place.y);
      before = place;
    }
    return {};
  }
};

/// The rungs of circles, cheapest first.
using CircleFamily =
    number::Family<CursorCircle, MidpointCircle32, MidpointCircle16, MidpointCircle64, SineCircle>;

}  // namespace intaglio::raster
