// SPDX-License-Identifier: MIT
//
// One pixel.
//
// Rule: the pixel is drawn iff it lies in the clip. Cost on Cortex-M3: see tests/target/speed_baseline.csv.
#pragma once

#include <intaglio/raster/cursor.hpp>
#include <intaglio/status.hpp>

namespace intaglio::raster {

/// Draws one pixel. Errors: out_of_domain point.
template <SpanSink S>
constexpr Status draw_pixel(S&& sink, linear::Point p) {
  // A clip lies in the domain, so a pixel inside it needs no second look.
  if (in_clip(sink.clip(), p)) {
    cursor_at(sink, p.x, p.y).put();
    return {};
  }
  return linear::in_domain(p) ? Status{} : Status{Error::out_of_domain, Argument::point};
}

}  // namespace intaglio::raster
