// SPDX-License-Identifier: MIT
//
// A drawing of someone who uses Intaglio.
#pragma once

#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/line.hpp>

/// A clock of radius 3 that shows three, in the square of 7 pixels at the origin; no pixel twice.
template <intaglio::raster::SpanSink S>
intaglio::Status draw_badge(S&& sink) {
  if (const auto status = intaglio::raster::draw_circle(sink, {3, 3}, 3); !status.ok()) return status;
  if (const auto status = intaglio::raster::draw_line(sink, {3, 3}, {5, 3}); !status.ok()) return status;
  return intaglio::raster::draw_line(sink, {3, 1}, {3, 2});
}
