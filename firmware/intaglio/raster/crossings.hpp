// SPDX-License-Identifier: MIT
//
// One row of a polygon: from crossings in order to spans.
//
// Rule: a crossing at x is the first pixel right of an edge; with it the winding number changes by the
// edge's turn. The pixels between two crossings belong to the polygon iff the winding number's bits that the
// rule looks at aren't all zero there. Crossings at the same x may come in any order.
#pragma once

#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/sink.hpp>

#include <algorithm>
#include <span>

namespace intaglio::raster::detail {

/// Draws the row. `crossings` are sorted by their x(), and their turn()s sum up to zero; `mask`: see
/// `winding_mask`.
template <SpanSink S, class Crossing>
void fill_row(S& sink, const linear::Rect& clip, int mask, int y,
              const std::span<const Crossing>& crossings) {
  int winding = 0;
  int begin = 0;
  for (const Crossing& crossing : crossings) {
    const bool was_inside = (winding & mask) != 0;
    winding += crossing.turn();
    if (was_inside == ((winding & mask) != 0)) continue;
    if (!was_inside) {
      begin = std::max(crossing.x(), clip.x);
    } else {
      const int end = std::min(crossing.x(), clip.right());
      if (begin < end) sink.span(y, begin, end);
    }
  }
}

}  // namespace intaglio::raster::detail
