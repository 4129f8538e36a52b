// SPDX-License-Identifier: MIT
#include <intaglio/raster/contours.hpp>
#include <intaglio/raster/convex.hpp>
#include <intaglio/raster/edge.hpp>
#include <intaglio/raster/edge_function.hpp>

#include <cstdint>

namespace intaglio::raster {

int detail::turning(const std::span<const linear::SubPoint>& vertices) noexcept {
  linear::SubPoint step{};  // the last edge that has a length
  linear::SubPoint from{};
  int turn = 0;
  int halves = 0;
  // Once around to find the last edge, and once more to look at the turns.
  for (int lap = 0; lap < 2; ++lap)
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (lap == 0 && i == 0) from = vertices.back();
      const linear::SubPoint to = vertices[i];
      if (to == from) continue;
      const linear::SubPoint next{to.x - from.x, to.y - from.y};
      from = to;
      if (lap == 1) {
        const std::int64_t right = std::int64_t{step.x} * next.y;
        const std::int64_t left = std::int64_t{step.y} * next.x;
        if (right != left) {
          const int here = right > left ? 1 : -1;
          if (turn != 0 && here != turn) return not_convex;
          turn = here;
        }
        // Once around passes from directions that go down to such that don't and back.
        const auto down = [](linear::SubPoint d) { return d.y > 0 || (d.y == 0 && d.x > 0); };
        if (down(step) != down(next)) ++halves;
      }
      step = next;
    }
  return halves > 2 ? not_convex : turn;
}

bool is_convex(const std::span<const linear::SubPoint>& vertices) noexcept {
  return detail::turning(vertices) != detail::not_convex;
}

namespace detail {

Status ConvexScan::prepare(const std::span<const linear::SubPoint>& vertices) noexcept {
  for (const linear::SubPoint& vertex : vertices)
    if (!linear::in_domain(vertex)) return {Error::out_of_domain, Argument::vertices};
  const int turn = turning(vertices);
  if (turn == not_convex) return {Error::malformed, Argument::vertices};
  if (turn == 0) box_ = {};
  if (box_.empty()) return {};
  const auto [least, most] = vertex_box(vertices);
  const int x = ceil_to_pixel(least.x);
  const int y = ceil_to_pixel(least.y);
  box_ = linear::intersect(box_, {x, y, ceil_to_pixel(most.x) - x, ceil_to_pixel(most.y) - y});
  vertices_ = vertices;
  clockwise_ = turn > 0;
  y_ = box_.y;
  return {};
}

bool ConvexScan::next(RowSpan& span) noexcept {
  if (box_.empty()) return false;
  while (y_ < box_.bottom()) {
    span = {y_++, box_.x, box_.right()};
    linear::SubPoint from = vertices_.back();
    for (const linear::SubPoint& to : vertices_) {
      if (to != from && span.x_begin < span.x_end) {
        const bool forwards = clockwise_;
        const bool moves_left_end = forwards == (to.y < from.y);
        const int x = moves_left_end ? span.x_begin : span.x_end - 1;
        EdgeFunction<std::int64_t> edge =
            edge_function(forwards ? from : to, forwards ? to : from, {x, span.y});
        if (edge.per_column == 0) {
          if (edge.value < 0) span.x_end = span.x_begin;  // a level edge: the whole row or nothing
        } else if (moves_left_end) {
          for (; span.x_begin < span.x_end && edge.value < 0; ++span.x_begin) edge.value += edge.per_column;
        } else {
          for (; span.x_begin < span.x_end && edge.value < 0; --span.x_end) edge.value -= edge.per_column;
        }
      }
      from = to;
    }
    if (span.x_begin < span.x_end) return true;
  }
  return false;
}

}  // namespace detail

}  // namespace intaglio::raster
