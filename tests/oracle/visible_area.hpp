// SPDX-License-Identifier: MIT
//
// Sets of places as disjoint convex pieces with rational corners: cut by lines, subtracted, joined. The area
// of what is visible of polygons one behind the other, as Catmull has it: cut to the pixel, the ones in front
// taken away.
#pragma once

#include <tests/oracle/coverage.hpp>

#include <cstddef>
#include <gmpxx.h>
#include <utility>
#include <vector>

namespace oracle {

using Pieces = std::vector<CutContour>;

/// Twice the signed area.
inline mpq_class twice_area(const CutContour& contour) {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const auto& a = contour[i];
    const auto& b = contour[(i + 1) % contour.size()];
    sum += a.first * b.second - b.first * a.second;
  }
  return sum;
}

/// The part of a convex piece to the left (-1) or right (1) of the line from a to b.
inline CutContour part_of(const CutContour& piece, const std::pair<mpq_class, mpq_class>& a,
                          const std::pair<mpq_class, mpq_class>& b, int side) {
  CutContour out;
  const auto distance = [&](const auto& p) {
    return mpq_class(
        side * ((b.first - a.first) * (p.second - a.second) - (b.second - a.second) * (p.first - a.first)));
  };
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const auto& p = piece[i];
    const auto& q = piece[(i + 1) % piece.size()];
    const mpq_class from = distance(p);
    const mpq_class to = distance(q);
    if (from >= 0) out.push_back(p);
    if ((from > 0 && to < 0) || (from < 0 && to > 0)) {
      const mpq_class part = from / (from - to);
      out.emplace_back(p.first + part * (q.first - p.first), p.second + part * (q.second - p.second));
    }
  }
  return out;
}

/// The pieces without a convex contour.
inline Pieces without(const Pieces& pieces, const CutContour& hole) {
  const mpq_class turn = twice_area(hole);
  if (turn == 0) return pieces;
  const int inner = turn > 0 ? 1 : -1;
  Pieces out;
  for (CutContour rest : pieces)
    for (std::size_t i = 0; i < hole.size() && !rest.empty(); ++i) {
      const auto& a = hole[i];
      const auto& b = hole[(i + 1) % hole.size()];
      CutContour outer = part_of(rest, a, b, -inner);
      if (twice_area(outer) != 0) out.push_back(std::move(outer));
      rest = part_of(rest, a, b, inner);
    }
  return out;
}

inline Pieces without(Pieces pieces, const Pieces& holes) {
  for (const CutContour& hole : holes) pieces = without(pieces, hole);
  return pieces;
}

/// The set of the places in an odd number of convex contours, or in any of them.
inline Pieces combined(const std::vector<CutContour>& contours, bool odd) {
  Pieces all;
  for (const CutContour& contour : contours) {
    if (twice_area(contour) == 0) continue;
    Pieces added = without(Pieces{contour}, all);
    if (odd) all = without(all, contour);
    all.insert(all.end(), added.begin(), added.end());
  }
  return all;
}

/// The area of the pieces, in pixels.
inline mpq_class area_of(const Pieces& pieces) {
  mpq_class sum = 0;
  for (const CutContour& piece : pieces) sum += abs(twice_area(piece));
  return sum / (2 * 256 * 256);
}

/// What of a convex contour lies in the square of pixel (x, y).
inline CutContour in_pixel(const Contour& contour, int x, int y) {
  CutContour part;
  for (const auto p : contour) part.emplace_back(p.x, p.y);
  part = cut(part, true, 256 * x - 128, 1);
  part = cut(part, true, 256 * x + 128, -1);
  part = cut(part, false, 256 * y - 128, 1);
  return cut(part, false, 256 * y + 128, -1);
}

/// The visible area, in pixels, of each layer in the square of pixel (x, y); the first layer is in front. A
/// layer has convex contours and is what an odd number of them, or any of them, has.
inline std::vector<mpq_class> visible_areas(const std::vector<std::pair<Contours, bool>>& layers, int x,
                                            int y) {
  std::vector<mpq_class> areas;
  std::vector<Pieces> front;
  for (const auto& [contours, odd] : layers) {
    std::vector<CutContour> parts;
    for (const Contour& contour : contours) parts.push_back(in_pixel(contour, x, y));
    const Pieces all = combined(parts, odd);
    Pieces seen = all;
    for (const Pieces& before : front) seen = without(seen, before);
    areas.push_back(area_of(seen));
    front.push_back(all);
  }
  return areas;
}

}  // namespace oracle
