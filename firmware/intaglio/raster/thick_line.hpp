// SPDX-License-Identifier: MIT
//
// Lines of true perpendicular width.
//
// Rule (DESIGN.md, "Thick line"): the parallelogram (a rectangle, but for the rounding of its corners to
// 1/256 pixel) whose middle line runs from end to end and whose sides lie half the width to either hand,
// filled by the top-left rule; square caps move its ends out by half the width. So thick lines that touch
// along a side share no pixel, each pixel is drawn once, and a line from b to a is the line from a to b.
//
// Both halves are triangles, which share the diagonal's pixels by the same rule.
// Error: the corners lie at the ends plus and minus one and the same offset, whose two coordinates are the
// true ones rounded, off by at most 1/2 + width/2^31 units of 1/256 pixel (up to 4096 pixels wide: 0.5005).
// So the sides are exactly parallel to the line. Bit budget: see thick_line.cpp. Textbook: section 2.3.3,
// whose line is thick along the minor axis only, hence 1/sqrt(2) too thin along diagonals. Worst known
// inputs: a width of 1 along a diagonal; ends that fall together.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/raster/triangle.hpp>
#include <intaglio/status.hpp>

#include <array>
#include <concepts>
#include <cstdint>

namespace intaglio::raster {

/// How a thick line ends.
enum class Cap : std::uint8_t {
  butt,    ///< At its end; a line without length has no pixel.
  square,  ///< Half the width beyond it; a line without length is an upright square.
};

namespace detail {
/// The corners of a thick line, in order round it. Errors: as `draw_thick_line`.
[[nodiscard]] Status thick_line_corners(linear::SubPoint a, linear::SubPoint b, int width, Cap cap,
                                        std::array<linear::SubPoint, 4>& corners) noexcept;
}  // namespace detail

/// Draws the line from `a` to `b` and of that width, all in 1/256 pixel. A width of 0 has no pixel.
/// Errors: out_of_domain point (an end or a corner), out_of_domain width (not 0..2^28), out_of_range rule
/// (`cap`); nothing is drawn then. Cost: a square root and two divisions, then two `fill_triangle`.
template <SpanSink S, std::same_as<linear::SubPoint> P>
Status draw_thick_line(S&& sink, P a, P b, int width, Cap cap = Cap::butt) {
  std::array<linear::SubPoint, 4> corners;
  const Status status = detail::thick_line_corners(a, b, width, cap, corners);
  if (!status.ok()) return status;
  fill_triangle(sink, corners[0], corners[1], corners[2]).ignore();
  fill_triangle(sink, corners[0], corners[2], corners[3]).ignore();
  return {};
}

/// The same between two pixels' centres, with the width in pixels, 0..2^20.
template <SpanSink S>
Status draw_thick_line(S&& sink, linear::Point a, linear::Point b, int width, Cap cap = Cap::butt) {
  if (!linear::in_domain(a) || !linear::in_domain(b)) return {Error::out_of_domain, Argument::point};
  if (!linear::in_domain(width)) return {Error::out_of_domain, Argument::width};
  return draw_thick_line(sink, linear::to_subpixel(a), linear::to_subpixel(b), width * linear::subpixel_one,
                         cap);
}

}  // namespace intaglio::raster
