// SPDX-License-Identifier: MIT
//
// Rings: a disc without a smaller one.
//
// Rule: the pixels of the disc of the outer radius that aren't in the disc of the inner radius around the
// same pixel (disc.hpp). The outer outline belongs to the ring, the inner one to what is left out: so a disc
// and the ring around it share no pixel and make the larger disc.
//
// Only visible rows are visited. Bit budget: as for ovals (oval.hpp). Error: none. Textbook: section 2.4.
// Worst known inputs: equal radii (no pixel), inner radius 0 (only the middle is missing).
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/raster/oval.hpp>
#include <intaglio/raster/row_shape.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

namespace intaglio::raster {

/// Fills the ring around the pixel `centre` (|c| <= 2^20), 0 <= inner_radius <= outer_radius <= 2^20 pixels.
/// Errors: out_of_domain point, radius; mismatched radius if the inner one is the larger. Nothing is drawn
/// then. Cost: twice that of `fill_ellipse`.
template <SpanSink S>
Status fill_ring(S&& sink, linear::Point centre, int inner_radius, int outer_radius) {
  const Status status = detail::check_ellipse(centre, inner_radius, outer_radius);
  if (!status.ok()) return status;
  if (inner_radius > outer_radius) return {Error::mismatched, Argument::radius};
  detail::fill_rows_around(sink, detail::Oval::around(centre, outer_radius, outer_radius),
                           detail::Oval::around(centre, inner_radius, inner_radius));
  return {};
}

}  // namespace intaglio::raster
