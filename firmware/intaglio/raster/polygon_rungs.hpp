// SPDX-License-Identifier: MIT
//
// Ways to fill a polygon, and those that only a convex one allows: rungs that draw the same pixels and differ
// in time and memory.
//
// Rule: each is one of the fills beside this header, called alike: a sink, the rule, vertices, and a
// workspace of the rung's `Cell`s, as many as vertices at most. Error: none. Bit budget, cost and worst known
// inputs: in polygon.hpp, polygon_critical.hpp, polygon_basic.hpp, convex.hpp. Textbook:
// sections 2.6.2, 2.6.3 and 2.6.6.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/raster/contours.hpp>
#include <intaglio/raster/convex.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/polygon_basic.hpp>
#include <intaglio/raster/polygon_critical.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

#include <span>
#include <string_view>

namespace intaglio::raster {

namespace detail {

/// A fill of any polygon, with one contour or several.
template <class R, class Entry>
struct PolygonRung {
  static constexpr number::Bound bound = number::exactly(number::Unit::wrong_pixel);
  using Cell = Entry;

  /// Arguments, errors as `fill_polygon`.
  template <SpanSink S>
  Status operator()(S&& sink, FillRule rule, const std::span<const linear::SubPoint>& vertices,
                    const std::span<const int>& contour_lengths, const std::span<Cell>& workspace) const {
    return R::fill(sink, rule, vertices, contour_lengths, workspace);
  }
  /// All vertices in one contour.
  template <SpanSink S>
  Status operator()(S&& sink, FillRule rule, const std::span<const linear::SubPoint>& vertices,
                    const std::span<Cell>& workspace) const {
    const int length = static_cast<int>(vertices.size());
    return R::fill(sink, rule, vertices, std::span<const int>(&length, 1), workspace);
  }
};

}  // namespace detail

/// An edge table and an active edge table: `fill_polygon`.
struct ScanlineFill : detail::PolygonRung<ScanlineFill, PolygonEdge> {
  template <SpanSink S>
  static Status fill(S& sink, FillRule rule, const std::span<const linear::SubPoint>& vertices,
                     const std::span<const int>& contour_lengths, const std::span<Cell>& workspace) {
    return fill_polygon(sink, rule, vertices, contour_lengths, workspace);
  }
};

/// Chains of edges from each local minimum: `fill_polygon_critical`.
struct CriticalPointsFill : detail::PolygonRung<CriticalPointsFill, PolygonChain> {
  template <SpanSink S>
  static Status fill(S& sink, FillRule rule, const std::span<const linear::SubPoint>& vertices,
                     const std::span<const int>& contour_lengths, const std::span<Cell>& workspace) {
    return fill_polygon_critical(sink, rule, vertices, contour_lengths, workspace);
  }
};

/// All crossings of each row, reckoned anew and sorted: `fill_polygon_basic`.
struct BasicFill : detail::PolygonRung<BasicFill, PolygonCrossing> {
  template <SpanSink S>
  static Status fill(S& sink, FillRule rule, const std::span<const linear::SubPoint>& vertices,
                     const std::span<const int>& contour_lengths, const std::span<Cell>& workspace) {
    return fill_polygon_basic(sink, rule, vertices, contour_lengths, workspace);
  }
};

/// Edge functions at each pixel of the bounding box: `fill_convex`. Takes one convex contour, which no rule
/// fills otherwise than another, and no workspace.
struct EdgeFunctionFill {
  static constexpr std::string_view domain = "one convex contour";
  static constexpr number::Bound bound = ScanlineFill::bound;
  struct Cell {};
  template <SpanSink S>
  Status operator()(S&& sink, FillRule /*rule*/, const std::span<const linear::SubPoint>& vertices,
                    const std::span<Cell>& /*workspace*/ = {}) const {
    return fill_convex(sink, vertices);
  }
};

/// The rungs of polygons, cheapest first.
using PolygonFamily = number::Family<ScanlineFill, CriticalPointsFill, BasicFill>;
/// The rungs of convex polygons of one contour, cheapest first.
using ConvexFamily = number::Family<ScanlineFill, CriticalPointsFill, EdgeFunctionFill, BasicFill>;

}  // namespace intaglio::raster
