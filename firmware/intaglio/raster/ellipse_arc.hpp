// SPDX-License-Identifier: MIT
//
// Arcs, pies and chords of ellipses with axes along rows and columns.
//
// Rule: as arc.hpp and chord.hpp, of the ellipse (ellipse.hpp) in place of the circle. An angle is the
// direction from the centre as it is seen on the screen, not the parameter of the curve: on any ellipse an
// eighth of a turn is the diagonal. So the end at the smaller angle belongs to an arc, the one at the larger
// doesn't, four adjacent quarters make the ellipse, each pixel once, and an ellipse with equal half axes
// gives the arcs, pies and chords of the circle.
//
// Only what is visible is visited. Bit budget: as arc.hpp and oval.hpp.
// Error: none for arcs and pies. A chord's line goes between the pixels nearest to the arc's ends, which are
// known to 1/256 pixel; the two chords of a line share no pixel and make the ellipse all the same.
// Textbook: section 2.4, exercise 4. Worst known inputs: half axes of 1 by 2^20 (the ends' directions all but
// agree), half axes of 0 (a straight line).
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/raster/chord.hpp>
#include <intaglio/raster/ellipse.hpp>
#include <intaglio/raster/sector.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

namespace intaglio::raster {

/// Draws the arc of the ellipse around the pixel `centre` (|c| <= 2^20) with half axes of 0..2^20 pixels
/// along x and y, from `start` through `sweep` steps of 1/65536 turn, clockwise on the screen; negative ones
/// go the other way, a turn or more is the whole ellipse. Errors: point, radius (outside the domain); nothing
/// is drawn then. Cost: that of the ellipse, and some 500 instructions a visible run of pixels.
template <SpanSink S>
Status draw_ellipse_arc(S&& sink, linear::Point centre, int x_radius, int y_radius, number::Angle start,
                        int sweep) {
  const Status status = detail::check_ellipse(centre, x_radius, y_radius);
  if (!status.ok() || sweep == 0) return status;
  if (sweep >= number::Angle::turn || sweep <= -number::Angle::turn)
    return draw_ellipse(sink, centre, x_radius, y_radius);
  return draw_ellipse(detail::PartSink(sink, centre, detail::Sector(start, sweep)), centre, x_radius,
                      y_radius);
}

/// Fills the pie (sector) between the centre and the arc that `draw_ellipse_arc` draws. Errors as there.
/// Cost: that of the filled ellipse, and some thousand instructions a visible row.
template <SpanSink S>
Status fill_ellipse_pie(S&& sink, linear::Point centre, int x_radius, int y_radius, number::Angle start,
                        int sweep) {
  const Status status = detail::check_ellipse(centre, x_radius, y_radius);
  if (!status.ok() || sweep == 0) return status;
  if (sweep >= number::Angle::turn || sweep <= -number::Angle::turn)
    return fill_ellipse(sink, centre, x_radius, y_radius);
  return fill_ellipse(detail::PartSink(sink, centre, detail::Sector(start, sweep)), centre, x_radius,
                      y_radius);
}

/// Fills the chord that the arc cuts off the ellipse. Arguments and errors as of `draw_ellipse_arc`.
/// Cost: that of the filled ellipse, and some hundred instructions a visible row.
template <SpanSink S>
Status fill_ellipse_chord(S&& sink, linear::Point centre, int x_radius, int y_radius, number::Angle start,
                          int sweep) {
  const Status status = detail::check_ellipse(centre, x_radius, y_radius);
  if (!status.ok() || sweep == 0) return status;
  if (sweep >= number::Angle::turn || sweep <= -number::Angle::turn)
    return fill_ellipse(sink, centre, x_radius, y_radius);
  const auto end_at = [&](number::Angle angle) { return detail::Ray(angle).on_ellipse(x_radius, y_radius); };
  const detail::ChordSide side(end_at(start), end_at(start + number::Angle::from_steps(sweep)), start, sweep);
  return fill_ellipse(detail::PartSink(sink, centre, side), centre, x_radius, y_radius);
}

}  // namespace intaglio::raster
