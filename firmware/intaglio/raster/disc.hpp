// SPDX-License-Identifier: MIT
//
// Discs: filled circles.
//
// Rule: the pixels of the circle's outline (circle.hpp) and everything inside it, so that a disc is the
// outline and its filling at every radius. r = 0 is one pixel.
//
// Rows and their reach come from disc_scan.hpp: the work is bounded by what is visible, at any radius.
//
// Bit budget: as for circles. Error: none. Textbook: sections 2.4 and 2.6.
// Worst known inputs: r = 3 and r = 4, where peers draw pixels twice and outlines stick out of discs; rows
// with both ends outside the window, which others skip.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/disc_scan.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

namespace intaglio::raster {

/// Fills the disc around the pixel `centre` (|c| <= 2^20), radius 0..2^20 pixels; it is 2*radius + 1 wide.
/// Errors: point, radius (outside the domain); nothing is drawn then.
/// Cost: five `half_chord`, and about 40 instructions a visible row on top of what the sink takes.
template <SpanSink S>
Status fill_disc(S&& sink, linear::Point centre, int radius) {
  const Status status = detail::check_circle(centre, radius);
  if (!status.ok()) return status;
  const linear::Rect clip = sink.clip();
  const int clip_left = clip.x;
  const int clip_right = clip.right();
  detail::scan_disc(centre, radius, clip, detail::Part::disc, [&](int y, const detail::DiscRow& row) {
    const int left = centre.x - row.outer;
    const int right = centre.x + row.outer + 1;
    sink.span(y, left > clip_left ? left : clip_left, right < clip_right ? right : clip_right);
  });
  return {};
}

}  // namespace intaglio::raster
