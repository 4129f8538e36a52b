// SPDX-License-Identifier: MIT
//
// Edges of polygons that are combined: which side, which crossing, which order; all of it exactly.
//
// Rule and bit budget: boolean.hpp. Error: none.
#pragma once

#include <intaglio/clip/boolean.hpp>
#include <intaglio/linear/point.hpp>
#include <intaglio/number/mul_div.hpp>
#include <intaglio/status.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace intaglio::clip::detail {

using linear::SubPoint;

[[nodiscard]] constexpr int sign(std::int64_t v) noexcept { return v < 0 ? -1 : v > 0 ? 1 : 0; }

/// The sign of a*b - c*d, exactly.
[[nodiscard]] inline int compare_products(std::int64_t a, std::int64_t b, std::int64_t c,
                                          std::int64_t d) noexcept {
  const int left = sign(a) * sign(b);
  const int right = sign(c) * sign(d);
  if (left != right || left == 0) return sign(left - right);
  using number::detail::magnitude;
  const auto p = number::detail::multiply_wide(magnitude(a), magnitude(b));
  const auto q = number::detail::multiply_wide(magnitude(c), magnitude(d));
  if (p.high != q.high) return p.high > q.high ? left : -left;
  return p.low == q.low ? 0 : p.low > q.low ? left : -left;
}

[[nodiscard]] constexpr SubPoint between(SubPoint from, SubPoint to) noexcept {
  return {to.x - from.x, to.y - from.y};
}
[[nodiscard]] constexpr std::int64_t cross(SubPoint u, SubPoint v) noexcept {
  return std::int64_t{u.x} * v.y - std::int64_t{u.y} * v.x;
}
[[nodiscard]] constexpr BooleanVertex whole(SubPoint p) noexcept { return {p.x, p.y, 1}; }

/// The order of places by x, then y.
[[nodiscard]] inline int compare(const BooleanVertex& p, const BooleanVertex& q) noexcept {
  const int by_x = compare_products(p.x, q.denominator, q.x, p.denominator);
  return by_x != 0 ? by_x : compare_products(p.y, q.denominator, q.y, p.denominator);
}

struct Segment {
  SubPoint a;
  SubPoint b;
};

/// Calls `visit(segment)` for each edge that has a length.
template <class Visit>
void for_each_edge(const BooleanOperand& operand, Visit visit) noexcept {
  const SubPoint* first = operand.vertices.data();
  for (const int length : operand.contour_lengths) {
    for (int i = 0; i < length; ++i) {
      const Segment edge{first[i], first[i + 1 == length ? 0 : i + 1]};
      if (!(edge.a == edge.b)) visit(edge);
    }
    first += length;
  }
}

/// True if p, on the line of `edge`, lies between its ends.
[[nodiscard]] constexpr bool inside(SubPoint p, const Segment& edge) noexcept {
  const SubPoint to_a = between(p, edge.a);
  const SubPoint to_b = between(p, edge.b);
  return std::int64_t{to_a.x} * to_b.x + std::int64_t{to_a.y} * to_b.y < 0;
}

/// Calls `visit(place)` for each place strictly inside `edge` at which `other` begins or crosses it.
template <class Visit>
void for_each_cut(const Segment& edge, const Segment& other, Visit visit) noexcept {
  const SubPoint way = between(edge.a, edge.b);
  const std::int64_t side_a = cross(way, between(edge.a, other.a));
  if (side_a == 0) {
    if (inside(other.a, edge)) visit(whole(other.a));
    return;
  }
  const std::int64_t side_b = cross(way, between(edge.a, other.b));
  if (sign(side_a) * sign(side_b) >= 0) return;
  const SubPoint other_way = between(other.a, other.b);
  std::int64_t denominator = cross(way, other_way);
  std::int64_t along = cross(between(edge.a, other.a), other_way);
  if (denominator < 0) {
    denominator = -denominator;
    along = -along;
  }
  if (along <= 0 || along >= denominator) return;
  visit(BooleanVertex{edge.a.x * denominator + way.x * along, edge.a.y * denominator + way.y * along,
                      denominator});
}

/// True if `edge` is above the place right after p on the way from p (to the right, or straight down). Right
/// and left of a vertical line's places: those right of it are meant.
[[nodiscard]] inline bool is_above(Segment edge, const BooleanVertex& p, SubPoint way) noexcept {
  if (edge.b.x < edge.a.x) std::swap(edge.a, edge.b);
  const auto right_of_or_at = [&p](int x) { return p.x >= x * p.denominator; };
  if (!right_of_or_at(edge.a.x) || right_of_or_at(edge.b.x)) return false;
  const SubPoint edge_way = between(edge.a, edge.b);
  const int side = compare_products(edge_way.x, p.y - edge.a.y * p.denominator, edge_way.y,
                                    p.x - edge.a.x * p.denominator);
  return side > 0 || (side == 0 && cross(edge_way, way) > 0);
}

/// Errors: vertices (one beyond `boolean_limit`), contours (lengths that are negative or don't add up).
[[nodiscard]] inline Status check(const BooleanOperand& operand) noexcept {
  for (const SubPoint p : operand.vertices)
    if (p.x < -boolean_limit || p.x > boolean_limit || p.y < -boolean_limit || p.y > boolean_limit)
      return {Error::out_of_domain, Argument::vertices};
  std::size_t left = operand.vertices.size();
  for (const int length : operand.contour_lengths) {
    if (length < 0 || static_cast<std::size_t>(length) > left) return {Error::mismatched, Argument::contours};
    left -= static_cast<std::size_t>(length);
  }
  return left == 0 ? Status{} : Status{Error::mismatched, Argument::contours};
}

}  // namespace intaglio::clip::detail
