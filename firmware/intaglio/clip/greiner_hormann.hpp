// SPDX-License-Identifier: MIT
//
// Polygons combined by the walk of Greiner and Hormann: the rung of the book beside `combine`, for operands
// that touch nowhere but where they cross.
//
// Rule: as boolean.hpp, places by even-odd. Each contour is a ring of nodes, into which the crossings with
// the other operand's edges are put, in order. Along a ring every crossing leads into the other operand or
// out of it, in turn, beginning with what its first vertex is. From a crossing the walk follows the part of
// the ring that belongs to the result to the next crossing, changes there to the other operand's ring, and so
// on until it is back. Rings without crossings belong to the result as a whole or not at all. The result is a
// set by even-odd: its contours have no direction to rely on, and keep the operands' vertices, those in the
// middle of a straight side too.
//
// Domain: no vertex of one operand may lie on an edge of the other, and no edge meet two of the other's in
// one place, since then a crossing doesn't say in or out any more. That is found exactly, and refused;
// `combine` takes everything.
//
// Bit budget: boolean.hpp. Error: none. Textbook: section 2.9.3, with exercise 11 of chapter 2 for what it
// refuses. Worst known inputs: random vertices on a small grid, which touch more often than not.
#pragma once

#include <intaglio/clip/boolean.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::clip {

namespace detail {
class GreinerHormannWork;
}

/// One vertex or crossing of a ring in the workspace of `combine_greiner_hormann`: 40 bytes. Its content is
/// that function's business.
class RingNode {
 private:
  friend class detail::GreinerHormannWork;
  BooleanVertex place_;
  int next_ = 0;
  int previous_ = 0;
  bool kept_ahead_ = false;  // the way to the next crossing belongs to the result
  bool used_ = false;
  int neighbour_ = -1;  // the same crossing in the other operand's ring; below 0 for a vertex
};
static_assert(sizeof(RingNode) == 40);

/// Combines two polygons; arguments as `combine`. `workspace` has a node for each vertex and two for each
/// crossing. Contours of fewer than three vertices are empty.
/// Errors: as `combine`; unsupported vertices (the operands touch, see the head of this file; nothing was
/// written then). Cost: for n and m edges n*m tests of pairs, twice; for each crossing a place in the order
/// along two edges; for each contour a look at all edges of the other operand.
[[nodiscard]] Result<BooleanResult> combine_greiner_hormann(BooleanRule rule, const BooleanOperand& a,
                                                            const BooleanOperand& b,
                                                            const std::span<BooleanVertex>& vertices,
                                                            const std::span<int>& contour_lengths,
                                                            const std::span<RingNode>& workspace) noexcept;

}  // namespace intaglio::clip
