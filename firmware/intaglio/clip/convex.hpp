// SPDX-License-Identifier: MIT
//
// A polygon clipped to a convex polygon: Sutherland and Hodgman's pipeline.
//
// Rule: each edge of the clipper is a stage that sees the polygon's vertices in order and hands on what is on
// its inner side, new vertices included. A vertex on the edge's line is inside and makes no new vertex. All
// stages run at once, each vertex passing through as far as it gets, so no stage stores a polygon: the memory
// is one small record an edge, and the result is written once.
//
// A new vertex is the exact crossing of the edge that reached the stage with the clipper's line, rounded once
// to the nearest 1/256, ties towards +x and +y. That depends on the line alone, not on its direction: two
// polygons that share an edge get the same new vertices on it. Where edges of the polygon ran outside, pieces
// of the clipper's edges take their place; a concave polygon that falls apart stays in one contour, its parts
// joined by bridges without area along them, which fills ignore.
//
// Error: half a sub-pixel on each axis for each edge of the clipper that cuts the same place, so no vertex
// lies further than 0.71 * edges sub-pixels outside the clipper or from the polygon's edge that it was cut
// from. Against an upright rectangle nothing lies outside at all. Bit budget: differences within 2^29, so
// sides of a line within 2^59 and their difference within 2^60; the crossing's product of 90 bits is
// mul_div.hpp's. Textbook: sections 2.9.3 and, for the pipeline, exercise 12 of chapter 2. Worst known
// inputs: vertices on the clipper's lines, polygons that fall apart.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/status.hpp>

#include <cstdint>
#include <span>

namespace intaglio::clip {

namespace detail {
class ConvexPipeline;
}

/// One edge of a clipper in the workspace of `clip_to_convex`: 56 bytes. Its content is that function's
/// business.
class ClipStage {
 private:
  friend class detail::ConvexPipeline;
  linear::SubPoint from_;
  linear::SubPoint along_;  // the edge as a vector; turned so that the inner side is the positive one
  linear::SubPoint first_;
  linear::SubPoint last_;
  linear::SubPoint waiting_;
  std::int64_t last_side_ = 0;
  bool begun_ = false;
  bool has_waiting_ = false;
};
static_assert(sizeof(ClipStage) == 56);

/// What of `polygon` is inside `clipper`, as one contour written to `out`; the answer is the part of `out`
/// that is used, empty if nothing is inside. `polygon` may be any contour (in 1/256 pixel, |c| <= 2^28);
/// `clipper` must be convex and have area, either way round, collinear and repeated vertices allowed.
/// `workspace` has one entry for each vertex of the clipper and holds nothing of value afterwards. Errors:
/// vertices (one of either is outside the domain), contours (the clipper isn't convex: malformed; has no
/// area: empty), workspace and buffer (too small: `needed()` entries; what `out` holds then is of no value).
/// Cost: about 40 instructions a vertex and stage, and about 1,500 for each new vertex.
[[nodiscard]] Result<std::span<linear::SubPoint>> clip_to_convex(
    const std::span<const linear::SubPoint>& polygon, const std::span<const linear::SubPoint>& clipper,
    const std::span<linear::SubPoint>& out, const std::span<ClipStage>& workspace) noexcept;

}  // namespace intaglio::clip
