// SPDX-License-Identifier: MIT
//
// Filled triangles by edge functions: the same pixels as `fill_triangle`, found another way.
//
// Rule: a pixel of the bounding box belongs to the triangle iff all three edge functions own its centre
// (edge_function.hpp). `fill_triangle_box` steps them from pixel to pixel. `fill_triangle_blocks` looks at
// the corners of blocks of 8x8 pixels first: a block outside one edge is skipped, one inside all three is
// taken whole, and only those between are looked at by pixel.
//
// Bit budget: edge_function.hpp: int32 for triangles whose bounding box has no side longer than 2032 pixels,
// int64 for others, up to the edge of the domain. Error: none. Textbook: section 2.6.5, with erratum E4 (as
// printed it compares a truth value with a sign, and no edge has an owner). Worst known input: a long sliver
// along a diagonal, whose bounding box is nearly empty; `fill_triangle` has no such case.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/edge_function.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace intaglio::raster {

namespace detail {

/// The visible part of a triangle's bounding box, and its edge functions at the first pixel of it.
struct TriangleBox {
  linear::Rect box;  // none of the rest counts if it is empty
  bool narrow;       // int32 holds the functions
  std::array<EdgeFunction<std::int64_t>, 3> edges;
};

/// Errors: as `fill_triangle`; the box is empty then, or if nothing is visible.
[[nodiscard]] Status triangle_box(const std::array<linear::SubPoint, 3>& vertices, const linear::Rect& clip,
                                  TriangleBox& out) noexcept;

/// Three edge functions side by side.
template <class Int>
class EdgeTriple {
 public:
  explicit EdgeTriple(const std::array<EdgeFunction<std::int64_t>, 3>& edges) noexcept {
    for (std::size_t i = 0; i < 3; ++i)
      edges_[i] = {static_cast<Int>(edges[i].value), static_cast<Int>(edges[i].per_column),
                   static_cast<Int>(edges[i].per_row)};
  }
  /// True if the pixel belongs to the triangle.
  [[nodiscard]] bool inside() const noexcept {
    return (edges_[0].value | edges_[1].value | edges_[2].value) >= 0;
  }
  void right(int pixels) noexcept {
    for (EdgeFunction<Int>& edge : edges_) edge.value += pixels * edge.per_column;
  }
  void down(int pixels) noexcept {
    for (EdgeFunction<Int>& edge : edges_) edge.value += pixels * edge.per_row;
  }
  /// How much of the square of `side` pixels whose first pixel this is belongs to the triangle: nothing (-1),
  /// everything (1) or perhaps something (0).
  [[nodiscard]] int square(int side) const noexcept {
    int answer = 1;
    for (const EdgeFunction<Int>& edge : edges_) {
      const Int across = (side - 1) * edge.per_column;
      const Int along = (side - 1) * edge.per_row;
      const Int least = edge.value + std::min<Int>(across, 0) + std::min<Int>(along, 0);
      const Int most = edge.value + std::max<Int>(across, 0) + std::max<Int>(along, 0);
      if (most < 0) return -1;
      if (least < 0) answer = 0;
    }
    return answer;
  }

 private:
  std::array<EdgeFunction<Int>, 3> edges_;
};

/// Pixels begin .. end-1 of a row.
struct TriangleRun {
  int begin = 0;
  int end = 0;
};

/// Those of begin .. end-1 that belong to the triangle; `pixel` is the first of them.
template <class Int>
[[nodiscard]] TriangleRun run_inside(EdgeTriple<Int> pixel, int begin, int end) noexcept {
  int x = begin;
  for (; x < end && !pixel.inside(); ++x) pixel.right(1);
  begin = x;
  for (; x < end && pixel.inside(); ++x) pixel.right(1);
  return {begin, x};
}

template <class Int, SpanSink S>
void triangle_by_pixels(S& sink, const TriangleBox& triangle) {
  const linear::Rect& box = triangle.box;
  EdgeTriple<Int> row(triangle.edges);
  for (int y = box.y; y < box.bottom(); ++y, row.down(1)) {
    const TriangleRun run = run_inside(row, box.x, box.right());
    if (run.begin < run.end) sink.span(y, run.begin, run.end);
  }
}

template <class Int, SpanSink S>
void triangle_by_blocks(S& sink, const TriangleBox& triangle) {
  constexpr int side = 8;
  const linear::Rect& box = triangle.box;
  EdgeTriple<Int> row(triangle.edges);
  for (int y = box.y; y < box.bottom(); y += side, row.down(side)) {
    // A row's pixels lie side by side, so one span grows over the blocks in each.
    std::array<TriangleRun, side> spans{};
    const int rows = std::min(side, box.bottom() - y);
    EdgeTriple<Int> block = row;
    for (int x = box.x; x < box.right(); x += side, block.right(side)) {
      const int kind = block.square(side);
      if (kind < 0) continue;
      const int x_end = std::min(x + side, box.right());
      EdgeTriple<Int> first = block;
      for (int i = 0; i < rows; ++i, first.down(1)) {
        const TriangleRun run = kind == 0 ? run_inside(first, x, x_end) : TriangleRun{x, x_end};
        if (run.begin == run.end) continue;
        TriangleRun& span = spans[static_cast<std::size_t>(i)];
        if (span.begin == span.end) span.begin = run.begin;
        span.end = run.end;
      }
    }
    for (int i = 0; i < rows; ++i) {
      const TriangleRun& span = spans[static_cast<std::size_t>(i)];
      if (span.begin < span.end) sink.span(y + i, span.begin, span.end);
    }
  }
}

/// Calls fill.operator()<Int>(triangle) with a type that holds the edge functions. Errors: as
/// `fill_triangle`.
template <class Fill>
Status fill_in_box(const std::array<linear::SubPoint, 3>& vertices, const linear::Rect& clip, Fill fill) {
  TriangleBox triangle;
  const Status status = triangle_box(vertices, clip, triangle);
  if (triangle.narrow)
    fill.template operator()<std::int32_t>(triangle);
  else
    fill.template operator()<std::int64_t>(triangle);
  return status;
}

}  // namespace detail

/// Fills the triangle a, b, c (in 1/256 pixel, |c| <= 2^28), vertices in any order, pixel by pixel.
/// Errors: point (outside the domain); nothing is drawn then.
/// Cost: about 8 instructions for each visible pixel of the bounding box up to the triangle's right edge.
template <SpanSink S>
Status fill_triangle_box(S&& sink, linear::SubPoint a, linear::SubPoint b, linear::SubPoint c) {
  return detail::fill_in_box({a, b, c}, sink.clip(), [&]<class Int>(const detail::TriangleBox& triangle) {
    detail::triangle_by_pixels<Int>(sink, triangle);
  });
}

/// The same by blocks of 8x8 pixels. Cost: about 40 instructions a block of the visible bounding box, and
/// about 8 a pixel of the blocks that an edge crosses.
template <SpanSink S>
Status fill_triangle_blocks(S&& sink, linear::SubPoint a, linear::SubPoint b, linear::SubPoint c) {
  return detail::fill_in_box({a, b, c}, sink.clip(), [&]<class Int>(const detail::TriangleBox& triangle) {
    detail::triangle_by_blocks<Int>(sink, triangle);
  });
}

}  // namespace intaglio::raster
