// SPDX-License-Identifier: MIT
//
// Thick arcs: the part of a ring that lies in a sweep of binary angles.
//
// Rule: the pixels of the ring (ring.hpp) whose direction from the centre is in the sweep (sector.hpp): the
// end at the smaller angle belongs to it, the one at the larger doesn't. So arcs side by side make the ring,
// each pixel once, and with the pie of the inner radius one makes the pie of the outer radius.
//
// Only what is visible is visited. Bit budget and error: none beyond those of ring.hpp and sector.hpp.
// Textbook: section 2.4, exercise 4. Worst known inputs: see sector.hpp.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/raster/ring.hpp>
#include <intaglio/raster/sector.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

namespace intaglio::raster {

namespace detail {

/// A sink that nothing is drawn on: what is left of a primitive is its check of the arguments.
struct SeesNothing {
  [[nodiscard]] static constexpr linear::Rect clip() noexcept { return {}; }
  static void span(int /*y*/, int /*x_begin*/, int /*x_end*/) noexcept {}
};

}  // namespace detail

/// Fills the arc of the ring around the pixel `centre` (|c| <= 2^20), 0 <= inner_radius <= outer_radius <=
/// 2^20 pixels, from `start` through `sweep` steps of 1/65536 turn, clockwise on the screen; negative ones go
/// the other way, a turn or more is the whole ring. Its ends are cut along the directions of the angles.
/// Errors: as `fill_ring`; nothing is drawn then. Cost: that of a ring, and some thousand instructions a
/// visible run of pixels.
template <SpanSink S>
Status fill_ring_arc(S&& sink, linear::Point centre, int inner_radius, int outer_radius, number::Angle start,
                     int sweep) {
  if (sweep >= number::Angle::turn || sweep <= -number::Angle::turn)
    return fill_ring(sink, centre, inner_radius, outer_radius);
  if (sweep == 0) return fill_ring(detail::SeesNothing{}, centre, inner_radius, outer_radius);
  return fill_ring(detail::PartSink(sink, centre, detail::Sector(start, sweep)), centre, inner_radius,
                   outer_radius);
}

}  // namespace intaglio::raster
