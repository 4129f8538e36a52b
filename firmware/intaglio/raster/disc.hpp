// SPDX-License-Identifier: MIT
//
// Discs: filled circles.
//
// Rule: the pixels of the circle's outline (circle.hpp) and everything inside it, so that a disc is the
// outline and its filling at every radius. r = 0 is one pixel.
//
// Row y reaches half_chord(r, |y - centre.y|) to both sides. Rows near the centre are steps of an octant's
// walk, rows near the poles the ends of its runs; rows that fill the window from side to side need no walk,
// and rows that don't reach it aren't visited: the work is bounded by the visible rows and columns.
// Bit budget: as for circles. Error: none. Textbook: sections 2.4 and 2.6. Worst known inputs: peers whose
// outline sticks out of the disc (r = 3, 4), rows with both ends outside the window skipped.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/octant.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

namespace intaglio::raster {

namespace detail {
/// Which rows of a disc are visible, as distances from its centre.
struct DiscRows {
  int first = 0;  ///< Nearest row; rows first .. full-1 fill the window from side to side.
  int full = 0;
  int last = -1;       ///< Furthest row.
  int last_reach = 0;  ///< half_chord of the furthest row.
};
[[nodiscard]] DiscRows disc_rows(linear::Point centre, int radius, const linear::Rect& clip) noexcept;
}  // namespace detail

/// Fills the disc around the pixel `centre` (|c| <= 2^20), radius 0..2^20 pixels; it is 2*radius + 1 wide.
/// Errors: point, radius (outside the domain); nothing is drawn then.
/// Cost: up to three roots, and about 20 instructions a visible row on top of what the sink takes.
template <SpanSink S>
Status fill_disc(S&& sink, linear::Point centre, int radius) {
  if (!linear::in_domain(centre)) return {Error::out_of_domain, Argument::point};
  if (!radius_in_domain(radius)) return {Error::out_of_domain, Argument::radius};
  const linear::Rect clip = sink.clip();
  const int clip_left = clip.x;
  const int clip_right = clip.right();
  const auto rows_at = [&](int distance, int reach) {
    const int left = centre.x - reach;
    const int right = centre.x + reach + 1;
    const int x_begin = left > clip_left ? left : clip_left;
    const int x_end = right < clip_right ? right : clip_right;
    const auto row = [&](int y) {
      if (static_cast<unsigned>(y - clip.y) < static_cast<unsigned>(clip.height))
        sink.span(y, x_begin, x_end);
    };
    row(centre.y + distance);
    if (distance > 0) row(centre.y - distance);
  };

  const detail::DiscRows rows = detail::disc_rows(centre, radius, clip);
  int distance = rows.first;
  for (; distance < rows.full; ++distance) rows_at(distance, radius);
  if (distance > rows.last) return {};
  // Rows beyond the diagonal, from the furthest inwards: each is a run of the walk, complete when v falls.
  for (Octant run(radius, rows.last_reach); run.v() > run.t() && run.v() >= distance;) {
    const int v = run.v();
    if (run.next()) rows_at(v, run.t() - 1);
  }
  // Rows up to the diagonal, from the nearest outwards: each is a step of the walk.
  for (Octant step(radius, distance); step.t() <= step.v() && step.t() <= rows.last; step.next())
    rows_at(step.t(), step.v());
  return {};
}

}  // namespace intaglio::raster
