// SPDX-License-Identifier: MIT
//
// Circle outlines.
//
// Rule: in the octant 0 <= t <= v the pixel (t, v) with v the integer nearest to sqrt(r^2 - t^2), mirrored
// eight times, each pixel once: what lies on an axis or a diagonal belongs to one octant. r = 0 is one pixel.
//
// A circle that is wholly visible, on a sink that can be walked, is walked by cursors, four octants at a
// time. Otherwise the visible part of each octant, an interval of t, is found by exact roots, and only it is
// walked: the work is bounded by the visible pixels, at any radius.
// Bit budget: centre within 2^20, radius <= 2^20, clip within 2^22: int32 (octant.hpp has the squares).
// Error: none. Textbook: section 2.4. Worst known inputs: r = 1 and r = 2 under XOR (drawn twice they
// vanish); r = 2^20 with a window at a pole (runs of a thousand pixels).
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/octant.hpp>
#include <intaglio/raster/row_span.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

#include <type_traits>

namespace intaglio::raster {

namespace detail {

/// The visible pixels of an outline, span by span, octant by octant.
class CircleScan {
 public:
  CircleScan(linear::Point centre, int radius, const linear::Rect& clip) noexcept;
  /// Puts the next span in `span`; false if there is none.
  [[nodiscard]] bool next(RowSpan& span) noexcept;

 private:
  void start() noexcept;

  linear::Point centre_;
  int radius_;
  linear::Rect clip_;
  int octant_;  // what is walked: bit 0 leftwards, bit 1 upwards, bit 2 t counts rows
  Octant walk_;
  int t_last_ = -1;
};

/// The four octants that begin at two opposite points of the outline, without those points and, if `Steep`,
/// without the diagonals. The cursors a and b stand on the top or right point, c and d on the one opposite.
template <bool Steep, PixelCursor C>
void walk_octants(int radius, C a, C c) {
  C b = a;
  C d = c;
  Octant octant(radius, 0, radius);
  for (;;) {
    const bool inwards = octant.next();
    if constexpr (Steep) {
      if (octant.t() >= octant.v()) return;
      a.up(), b.down(), c.up(), d.down();
      if (inwards) a.left(), b.left(), c.right(), d.right();
    } else {
      if (octant.t() > octant.v()) return;
      a.right(), b.left(), c.right(), d.left();
      if (inwards) a.down(), b.down(), c.up(), d.up();
    }
    a.put(), b.put(), c.put(), d.put();
  }
}

}  // namespace detail

/// Draws the circle around the pixel `centre` (|c| <= 2^20), radius 0..2^20 pixels; it is 2*radius + 1 wide.
/// Errors: point, radius (outside the domain); nothing is drawn then.
/// Cost: about 6 instructions a pixel on an 8-bit surface if wholly visible; otherwise up to 16 roots and
/// about 40 instructions a visible pixel.
template <SpanSink S>
Status draw_circle(S&& sink, linear::Point centre, int radius) {
  if (!linear::in_domain(centre)) return {Error::out_of_domain, Argument::point};
  if (!radius_in_domain(radius)) return {Error::out_of_domain, Argument::radius};
  const linear::Rect clip = sink.clip();
  if constexpr (CursorSink<std::remove_reference_t<S>>) {
    const linear::Point low{centre.x - radius, centre.y - radius};
    const linear::Point high{centre.x + radius, centre.y + radius};
    if (radius > 0 && clip.contains(low) && clip.contains(high)) {
      auto top = sink.cursor(centre.x, low.y);
      auto bottom = sink.cursor(centre.x, high.y);
      top.put(), bottom.put();
      detail::walk_octants<false>(radius, top, bottom);
      auto right = sink.cursor(high.x, centre.y);
      auto left = sink.cursor(low.x, centre.y);
      right.put(), left.put();
      detail::walk_octants<true>(radius, right, left);
      return {};
    }
  }
  detail::CircleScan scan(centre, radius, clip);
  for (RowSpan span; scan.next(span);) sink.span(span.y, span.x_begin, span.x_end);
  return {};
}

}  // namespace intaglio::raster
