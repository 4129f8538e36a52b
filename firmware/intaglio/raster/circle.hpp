// SPDX-License-Identifier: MIT
//
// Circle outlines.
//
// Rule: in the octant 0 <= t <= v the pixel (t, v) with v the integer nearest to sqrt(r^2 - t^2), mirrored
// eight times, each pixel once: what lies on an axis or a diagonal belongs to one octant. r = 0 is one pixel.
//
// A circle that is wholly visible, on a sink that can be walked, is walked by cursors, four octants at a
// time. Otherwise only the visible rows are visited (disc_scan.hpp): the work is bounded by what is visible,
// at any radius.
//
// Bit budget: centre within 2^20, radius <= 2^20, clip within 2^22: int32 (octant.hpp has the squares).
// Error: none. Textbook: section 2.4.
// Worst known inputs: r = 1 and r = 2 under XOR (drawn twice they vanish); r = 2^20 with a window at a pole
// (runs of a thousand pixels).
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/cursor.hpp>
#include <intaglio/raster/disc_scan.hpp>
#include <intaglio/raster/octant.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

#include <algorithm>
#include <type_traits>

namespace intaglio::raster {

namespace detail {

/// Draws a wholly visible circle, radius above 0: the four octants that begin at the poles, then the four
/// that begin at the sides (`steep`), each by a cursor. The poles and sides come first; diagonals aren't
/// steep.
template <CursorSink S>
void walk_circle(S& sink, linear::Point centre, int radius) {
  for (bool steep = false;; steep = true) {
    const int dx = steep ? radius : 0;
    const int dy = steep ? 0 : radius;
    auto a = sink.cursor(centre.x + dx, centre.y - dy);  // from the top to the right, from the right upwards
    auto b = a;                                          // from the top to the left, from the right downwards
    auto c = sink.cursor(centre.x - dx, centre.y + dy);  // opposite
    auto d = c;
    a.put(), c.put();
    for (Octant octant(radius, 0, radius);;) {
      const bool inwards = octant.next();
      if (octant.t() > octant.v() - (steep ? 1 : 0)) break;
      if (steep) {
        a.up(), b.down(), c.up(), d.down();
        if (inwards) a.left(), b.left(), c.right(), d.right();
      } else {
        a.right(), b.left(), c.right(), d.left();
        if (inwards) a.down(), b.down(), c.up(), d.up();
      }
      a.put(), b.put(), c.put(), d.put();
    }
    if (steep) return;
  }
}

}  // namespace detail

/// Draws the circle around the pixel `centre` (|c| <= 2^20), radius 0..2^20 pixels; it is 2*radius + 1 wide.
/// Errors: point, radius (outside the domain); nothing is drawn then.
/// Cost: about 7 instructions a pixel on an 8-bit surface if wholly visible; otherwise six `half_chord`, and
/// about 60 instructions a visible row on top of what the sink takes.
template <SpanSink S>
Status draw_circle(S&& sink, linear::Point centre, int radius) {
  const Status status = detail::check_circle(centre, radius);
  if (!status.ok()) return status;
  const linear::Rect clip = sink.clip();
  if constexpr (CursorSink<std::remove_reference_t<S>>) {
    if (radius > 0 && detail::wholly_visible(centre, radius, clip)) {
      detail::walk_circle(sink, centre, radius);
      return {};
    }
  }
  const int clip_right = clip.right();
  const int middle = centre.x - clip.x;
  const auto pixel = [&](int column, int y) {
    if (static_cast<unsigned>(column) < static_cast<unsigned>(clip.width))
      cursor_at(sink, clip.x + column, y).put();
  };
  const auto run = [&](int y, int begin, int end) {
    begin = std::max(begin, clip.x);
    end = std::min(end, clip_right);
    if (begin < end) sink.span(y, begin, end);
  };
  detail::scan_disc(centre, radius, clip, detail::Part::outline, [&](int y, const detail::DiscRow& row) {
    if (row.inner == row.outer && row.inner != 0) {
      pixel(middle - row.outer, y);
      pixel(middle + row.outer, y);
      return;
    }
    // On the axis both runs are one.
    const int right_begin = centre.x + row.inner;
    const int left_end = row.inner == 0 ? right_begin : centre.x - row.inner + 1;
    run(y, centre.x - row.outer, left_end);
    run(y, right_begin, centre.x + row.outer + 1);
  });
  return {};
}

}  // namespace intaglio::raster
