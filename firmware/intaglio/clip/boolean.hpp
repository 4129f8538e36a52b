// SPDX-License-Identifier: MIT
//
// Intersection, union and differences of two polygons, exactly, whatever they touch.
//
// Rule: operands are sets of places, by the even-odd rule, with any number of contours that may cross
// themselves and each other. The result is the boundary of the combined set: contours with the set on their
// left as they are walked on a screen (y down), holes the other way round, vertices as exact fractions.
//
// All edges are cut wherever another edge crosses them or has an end on them. What is left are pieces that
// coincide or meet only at their ends, so each has one answer on each side: a count of the operands' edges
// above its first end says what lies on one side, the pieces that coincide with it what lies on the other. A
// piece is boundary if the answers differ. There are no special cases for shared vertices, edges that overlap
// or vertices on edges: those give pieces like any others, and an edge drawn twice cancels by itself. The
// results are those of Greiner and Hormann's walk (greiner_hormann.hpp) where that is defined, as sets.
//
// Bit budget: |c| <= 2^19 sub-pixels (2,048 pixels), so differences have 21 bits, denominators 42 and
// numerators 61; products of a numerator and a denominator or a difference stay in 128 bits, kept as two
// words. Error: none; `nearest` rounds a vertex by half a sub-pixel on each axis.
// Textbook: section 2.9.3 and exercise 11 of chapter 2. Worst known inputs: hard cases 23 to 28, shared edges
// and corners on which others lose regions.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/number/division.hpp>
#include <intaglio/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::clip {

/// Largest magnitude of a coordinate of an operand, in 1/256 pixel.
inline constexpr int boolean_limit = 1 << 19;

/// Which places of two sets are taken.
enum class BooleanRule : std::uint8_t {
  intersection,  ///< Those in both.
  join,          ///< Those in either: the union.
  a_minus_b,     ///< Those in the first and not in the second.
  b_minus_a,     ///< Those in the second and not in the first.
};

/// True if the rule takes places that are in the one and the other set or not. A rule that isn't one takes
/// none.
[[nodiscard]] constexpr bool taken(BooleanRule rule, bool in_a, bool in_b) noexcept {
  switch (rule) {
    case BooleanRule::intersection:
      return in_a && in_b;
    case BooleanRule::join:
      return in_a || in_b;
    case BooleanRule::a_minus_b:
      return in_a && !in_b;
    case BooleanRule::b_minus_a:
      return in_b && !in_a;
  }
  return false;
}

/// The place (x / denominator, y / denominator), in 1/256 pixel; the fractions needn't be in lowest terms.
struct BooleanVertex {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t denominator = 1;  ///< Above zero.
};

/// The nearest sub-pixel place, ties towards +x and +y.
[[nodiscard]] constexpr linear::SubPoint nearest(const BooleanVertex& v) noexcept {
  return {static_cast<int>(number::round_div(v.x, v.denominator)),
          static_cast<int>(number::round_div(v.y, v.denominator))};
}

/// Contours, one after the other in `vertices`, as long as `contour_lengths` says.
struct BooleanOperand {
  std::span<const linear::SubPoint> vertices;
  std::span<const int> contour_lengths;
};

namespace detail {
class BooleanWork;
}

/// One piece of an edge in the workspace of `combine`: 64 bytes. Its content is that function's business.
class BooleanPiece {
 private:
  friend class detail::BooleanWork;
  BooleanVertex from_;
  BooleanVertex to_;
  linear::SubPoint way_;  // the direction from `from_` to `to_`, of any length
  bool of_b_ = false;
  bool used_ = false;
};
static_assert(sizeof(BooleanPiece) == 64);

/// How much of the memory given to `combine` the result takes.
struct BooleanResult {
  std::size_t vertices = 0;
  std::size_t contours = 0;
};

/// Combines two polygons by even-odd. The contours of the result are written to `vertices` and
/// `contour_lengths`; none has fewer than three vertices, none has a vertex in the middle of a straight side,
/// and no two cross. `workspace` has one entry for each piece of an edge, one for each repeated cut, and one
/// more; it holds nothing of value afterwards.
/// Errors: out_of_domain vertices (one beyond `boolean_limit`), mismatched contours (lengths that are
/// negative or don't add up), rule, too_small workspace, vertices or contours (`needed()` entries; what was
/// written is of no value then). Cost: for n edges cut into p pieces, n*n tests of pairs, n*p tests above an
/// end (two 64-bit products each, four when close), and two sorts of p pieces.
[[nodiscard]] Result<BooleanResult> combine(BooleanRule rule, const BooleanOperand& a,
                                            const BooleanOperand& b, const std::span<BooleanVertex>& vertices,
                                            const std::span<int>& contour_lengths,
                                            const std::span<BooleanPiece>& workspace) noexcept;

}  // namespace intaglio::clip
