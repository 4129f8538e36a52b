// SPDX-License-Identifier: MIT
//
// Ways to draw the outline of an ellipse: row by row, by the midpoint's error in 16, 32 and 64 bits, and by a
// table of sines.
//
// Rule: the pixels of ellipse.hpp, each once. `RowEllipse` is its `draw_ellipse`; the others go around all of
// a quadrant, visible or not, so their cost grows with the half axes. `MidpointEllipse...` see whether the
// middle of the next two pixels is inside, along the longer axis where the curve is flat and then along the
// shorter one; where a slender one ends in a line, its tip is added. `SineEllipse` takes as many points of
// the quadrant as it has columns and rows, each rounded to a pixel.
//
// Error: pixels that are wrong, of one ellipse, by trying all half axes of a rung's domain. The midpoint
// misses one a quadrant, or has one too many, where it turns from the one axis to the other, and at times a
// second. Bit budget of the midpoint, with a >= b: the gradient, in eighths, is below 8*a^2*b each way,
// 27,000 for half axes up to 15, 2^31 for those up to 645; the error stays below it. Textbook: section 2.4.
// Worst known inputs: (10, 18) by midpoints, (434, 438) by sines.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/number/sine.hpp>
#include <intaglio/raster/ellipse.hpp>
#include <intaglio/raster/mirrored_pixels.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace intaglio::raster {

/// The library's: `draw_ellipse`.
struct RowEllipse {
  static constexpr number::Bound bound = number::exactly(number::Unit::wrong_pixel);
  template <SpanSink S>
  Status operator()(S&& sink, linear::Point centre, int a, int b) const {
    return draw_ellipse(sink, centre, a, b);
  }
};

namespace detail {

/// Calls put(x, y) for the pixels of a quadrant, a >= b >= 0, each once.
template <class Int, class Put>
void walk_midpoints(int a, int b, Put put) {
  const auto aa = static_cast<Int>(a * a);
  const auto bb = static_cast<Int>(b * b);
  Int x = 0;
  auto y = static_cast<Int>(b);
  Int across = 0;                            // 8*b^2*x
  auto down = static_cast<Int>(8 * aa * y);  // 8*a^2*y
  auto d = static_cast<Int>(4 * bb - 4 * aa * y + aa);
  while (across < down) {
    put(static_cast<int>(x), static_cast<int>(y));
    ++x;
    across = static_cast<Int>(across + 8 * bb);
    if (d >= 0) {
      --y;
      down = static_cast<Int>(down - 8 * aa);
      d = static_cast<Int>(d - down);
    }
    d = static_cast<Int>(d + across + 4 * bb);
  }
  d = static_cast<Int>(d - across / 2 - down / 2 + 3 * (aa - bb));
  int tip = 0;
  while (y >= 0) {
    put(static_cast<int>(x), static_cast<int>(y));
    tip = static_cast<int>(x) + 1;
    --y;
    down = static_cast<Int>(down - 8 * aa);
    if (d < 0) {
      ++x;
      across = static_cast<Int>(across + 8 * bb);
      d = static_cast<Int>(d + across);
    }
    d = static_cast<Int>(d - down + 4 * aa);
  }
  for (; tip <= a; ++tip) put(tip, 0);
}

/// The midpoints in so many bits.
template <class Int, int longest>
struct MidpointEllipse {
  static constexpr number::Bound bound = number::wrong_pixels(8'000);
  /// The longest half axis.
  static constexpr int most = longest;

  /// Errors: as `draw_ellipse`; too_large radius.
  template <SpanSink S>
  Status operator()(S&& sink, linear::Point centre, int a, int b) const {
    const Status status = at_most(check_ellipse(centre, a, b), std::max(a, b), most);
    if (!status.ok()) return status;
    const linear::Rect clip = sink.clip();
    const bool upright = a < b;
    walk_midpoints<Int>(upright ? b : a, upright ? a : b, [&](int along, int beside) {
      put_quadrants(sink, clip, centre, upright ? beside : along, upright ? along : beside);
    });
    return {};
  }
};

}  // namespace detail

struct MidpointEllipse16 : detail::MidpointEllipse<std::int16_t, 15> {
  static constexpr std::string_view domain = "half axes up to 15";
};
struct MidpointEllipse32 : detail::MidpointEllipse<std::int32_t, 645> {
  static constexpr std::string_view domain = "half axes up to 645";
};
struct MidpointEllipse64 : detail::MidpointEllipse<std::int64_t, 1'024> {
  static constexpr std::string_view domain = "half axes up to 1,024, as far as its bound was tried";
};

/// By a table of sines.
struct SineEllipse {
  static constexpr number::Bound bound = number::wrong_pixels(552'000);
  static constexpr std::string_view domain = "half axes up to 450";
  /// The longest half axis.
  static constexpr int most = 450;

  /// Errors: as `draw_ellipse`; too_large radius.
  template <SpanSink S>
  Status operator()(S&& sink, linear::Point centre, int a, int b) const {
    const Status status = detail::at_most(detail::check_ellipse(centre, a, b), std::max(a, b), most);
    if (!status.ok()) return status;
    const linear::Rect clip = sink.clip();
    constexpr unsigned quadrant = 16384U << 16U;
    const unsigned points = static_cast<unsigned>(a + b) + 1;
    const unsigned step = quadrant / points;
    const auto scaled = [](int length, int sine) { return (length * sine + (1 << 14)) >> 15; };
    linear::Point before{-1, -1};
    for (unsigned i = 0, angle = 0; i <= points; ++i, angle += step) {
      const auto turn = number::Angle::from_steps(static_cast<int>(angle >> 16U));
      const linear::Point place{scaled(a, number::cosine(turn).raw()), scaled(b, number::sine(turn).raw())};
      if (place != before) detail::put_quadrants(sink, clip, centre, place.x, place.y);
      before = place;
    }
    return {};
  }
};

/// The rungs of ellipses.
using EllipseFamily =
    number::Family<MidpointEllipse32, MidpointEllipse16, RowEllipse, MidpointEllipse64, SineEllipse>;

}  // namespace intaglio::raster
