// SPDX-License-Identifier: MIT
//
// Arcs and pies: the part of a circle or a disc that lies in a sweep of binary angles.
//
// Rule: the pixels of the circle (circle.hpp) or disc (disc.hpp) whose direction from the centre is in the
// sweep (sector.hpp): the end at the smaller angle belongs to it, the one at the larger doesn't. Four
// adjacent quarters so make the circle or the disc, each pixel once. The centre belongs to the pie that holds
// three o'clock.
//
// Only what is visible is visited. Bit budget and error: none beyond those of sector.hpp.
// Textbook: section 2.4, exercise 4. Worst known inputs: see sector.hpp.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/sector.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

namespace intaglio::raster {

/// Draws the arc of the circle around the pixel `centre` (|c| <= 2^20) with radius 0..2^20 from `start`
/// through `sweep` steps of 1/65536 turn, clockwise on the screen; negative ones go the other way, a turn or
/// more is the whole circle. Errors: point, radius (outside the domain); nothing is drawn then. Cost: that of
/// a clipped circle, and some 500 instructions a visible run of pixels.
template <SpanSink S>
Status draw_arc(S&& sink, linear::Point centre, int radius, number::Angle start, int sweep) {
  const Status status = detail::check_circle(centre, radius);
  if (!status.ok() || sweep == 0) return status;
  if (sweep >= number::Angle::turn || sweep <= -number::Angle::turn) return draw_circle(sink, centre, radius);
  return draw_circle(detail::PartSink(sink, centre, detail::Sector(start, sweep)), centre, radius);
}

/// Fills the pie (sector) between the centre and the arc that `draw_arc` draws. Errors as there.
/// Cost: that of a disc, and some thousand instructions a visible row.
template <SpanSink S>
Status fill_pie(S&& sink, linear::Point centre, int radius, number::Angle start, int sweep) {
  const Status status = detail::check_circle(centre, radius);
  if (!status.ok() || sweep == 0) return status;
  if (sweep >= number::Angle::turn || sweep <= -number::Angle::turn) return fill_disc(sink, centre, radius);
  return fill_disc(detail::PartSink(sink, centre, detail::Sector(start, sweep)), centre, radius);
}

}  // namespace intaglio::raster
