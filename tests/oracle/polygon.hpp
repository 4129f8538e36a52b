// SPDX-License-Identifier: MIT
//
// Which pixel centres are inside a polygon or a triangle, each answered by itself in 128-bit integers:
// winding numbers for polygons, edge functions for triangles, the top-left rule for centres on an edge.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <tests/oracle/integer.hpp>
#include <tests/oracle/span_list.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace oracle {

using Contour = std::vector<intaglio::linear::SubPoint>;
using Contours = std::vector<Contour>;

/// How often the contours wind around the centre of pixel (x, y): a half-line to the left meets the edges
/// that are closed at their upper and open at their lower end. A crossing at the centre itself counts: such
/// an edge has the centre to its right.
inline int winding(const Contours& contours, int x, int y) {
  __extension__ using Int = __int128;
  const Int px = Int{x} * 256;
  const Int py = Int{y} * 256;
  int turns = 0;
  for (const Contour& contour : contours)
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const auto a = contour[i];
      const auto b = contour[(i + 1) % contour.size()];
      if (a.y <= py && py < b.y && (px - a.x) * (b.y - a.y) >= (py - a.y) * (b.x - a.x)) ++turns;
      if (b.y <= py && py < a.y && (px - b.x) * (a.y - b.y) >= (py - b.y) * (a.x - b.x)) --turns;
    }
  return turns;
}

/// The same for a whole row: the winding numbers of pixels (left, y) .. (left + width - 1, y). From the first
/// pixel on that has a crossing to its left, the number is one more or less.
inline std::vector<int> winding_row(const Contours& contours, int left, int width, int y) {
  const Wide py = Wide{y} * 256;
  std::vector<int> turns(static_cast<std::size_t>(width) + 1);
  for (const Contour& contour : contours)
    for (std::size_t i = 0; i < contour.size(); ++i) {
      auto a = contour[i];
      auto b = contour[(i + 1) % contour.size()];
      const int direction = a.y < b.y ? 1 : -1;
      if (b.y < a.y) std::swap(a, b);
      if (py < a.y || py >= b.y) continue;
      const Wide height = Wide{b.y} - a.y;
      // 256 * height * x >= what the edge has there.
      const Wide first = ceil_quotient(a.x * height + (py - a.y) * (Wide{b.x} - a.x), 256 * height);
      turns[static_cast<std::size_t>(std::clamp<Wide>(first - left, 0, width))] += direction;
    }
  turns.pop_back();
  for (std::size_t i = 1; i < turns.size(); ++i) turns[i] += turns[i - 1];
  return turns;
}

inline bool in_polygon(const Contours& contours, bool even_odd, int x, int y) {
  const int turns = winding(contours, x, y);
  return even_odd ? turns % 2 != 0 : turns != 0;
}

/// The window's pixels row by row, 1 inside and 0 outside.
inline std::vector<int> polygon_pixels(const Contours& contours, bool even_odd,
                                       const intaglio::linear::Rect& clip) {
  std::vector<int> pixels;
  for (int y = clip.y; y < clip.y + clip.height; ++y)
    for (const int turns : winding_row(contours, clip.x, clip.width, y))
      pixels.push_back((even_odd ? turns % 2 : turns) != 0 ? 1 : 0);
  return pixels;
}

/// By three edge functions: positive inside; zero belongs to an edge that runs upwards or, level, to the
/// right (y grows downwards; vertices turned so that the area is positive).
inline bool in_triangle(intaglio::linear::SubPoint a, intaglio::linear::SubPoint b,
                        intaglio::linear::SubPoint c, int x, int y) {
  __extension__ using Int = __int128;
  const auto side = [](auto from, auto to, Int px, Int py) {
    return (Int{to.x} - from.x) * (py - from.y) - (Int{to.y} - from.y) * (px - from.x);
  };
  const Int area = side(a, b, c.x, c.y);
  if (area == 0) return false;
  if (area < 0) {
    const auto swapped = b;
    b = c;
    c = swapped;
  }
  const auto owns = [&](auto from, auto to) {
    const Int distance = side(from, to, Int{x} * 256, Int{y} * 256);
    const bool top_left = to.y < from.y || (to.y == from.y && to.x > from.x);
    return distance > 0 || (distance == 0 && top_left);
  };
  return owns(a, b) && owns(b, c) && owns(c, a);
}

/// The triangle's pixels in a window, a span a row. Each edge function is a line along the row: it leaves a
/// half-line of pixels, and the row is what all three leave.
inline std::vector<Span> triangle_spans(intaglio::linear::SubPoint a, intaglio::linear::SubPoint b,
                                        intaglio::linear::SubPoint c, const intaglio::linear::Rect& clip) {
  const Wide area = (Wide{b.x} - a.x) * (Wide{c.y} - a.y) - (Wide{b.y} - a.y) * (Wide{c.x} - a.x);
  std::vector<Span> spans;
  if (area == 0) return spans;
  if (area < 0) std::swap(b, c);
  for (int y = clip.y; y < clip.y + clip.height; ++y) {
    Wide begin = clip.x;
    Wide end = Wide{clip.x} + clip.width;
    const auto cut = [&](auto from, auto to) {
      const Wide dx = Wide{to.x} - from.x;
      const Wide dy = Wide{to.y} - from.y;
      // dx * (256 * y - from.y) - dy * (256 * x - from.x) >= 0, or 1 where the edge doesn't own its centres.
      const bool top_left = dy < 0 || (dy == 0 && dx > 0);
      const Wide rest = dx * (Wide{256} * y - from.y) + dy * from.x - (top_left ? 0 : 1);
      if (dy == 0 && rest < 0) end = begin;
      if (dy > 0) end = std::min(end, floor_quotient(rest, 256 * dy) + 1);
      if (dy < 0) begin = std::max(begin, ceil_quotient(rest, 256 * dy));
    };
    cut(a, b);
    cut(b, c);
    cut(c, a);
    if (begin < end) spans.push_back({y, static_cast<int>(begin), static_cast<int>(end)});
  }
  return spans;
}

}  // namespace oracle
