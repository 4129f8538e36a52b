// SPDX-License-Identifier: MIT
//
// Which pixel centres are inside a polygon or a triangle, each answered by itself in 128-bit integers:
// winding numbers for polygons, edge functions for triangles, the top-left rule for centres on an edge.
#pragma once

#include <intaglio/linear/point.hpp>

#include <cstddef>
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

inline bool in_polygon(const Contours& contours, bool even_odd, int x, int y) {
  const int turns = winding(contours, x, y);
  return even_odd ? turns % 2 != 0 : turns != 0;
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

}  // namespace oracle
