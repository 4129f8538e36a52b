// SPDX-License-Identifier: MIT
//
// How much of a pixel's square a polygon covers, as an exact rational: the contours are cut to the square
// side by side (Sutherland-Hodgman) and the signed areas of what is left added up. For a polygon that doesn't
// cross itself that is its area in the pixel, but for the sign.
#pragma once

#include <intaglio/linear/point.hpp>
#include <tests/oracle/polygon.hpp>

#include <cstddef>
#include <gmpxx.h>
#include <utility>
#include <vector>

namespace oracle {

/// Vertices (x, y) in 1/256 pixel.
using CutContour = std::vector<std::pair<mpq_class, mpq_class>>;

/// Cuts a contour to the places where side * (coordinate - at) >= 0; coordinates as (x, y).
inline CutContour cut(const CutContour& contour, bool along_x, int at, int side) {
  CutContour out;
  const auto distance = [&](const auto& p) {
    return mpq_class(((along_x ? p.first : p.second) - at) * side);
  };
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const auto& a = contour[i];
    const auto& b = contour[(i + 1) % contour.size()];
    const mpq_class from = distance(a);
    const mpq_class to = distance(b);
    if (from >= 0) out.push_back(a);
    if ((from > 0 && to < 0) || (from < 0 && to > 0)) {
      const mpq_class part = from / (from - to);
      out.emplace_back(a.first + part * (b.first - a.first), a.second + part * (b.second - a.second));
    }
  }
  return out;
}

/// The signed area of a contour in the square of pixel (x, y), in pixels.
inline mpq_class signed_area(CutContour part, int x, int y) {
  part = cut(part, true, 256 * x - 128, 1);
  part = cut(part, true, 256 * x + 128, -1);
  part = cut(part, false, 256 * y - 128, 1);
  part = cut(part, false, 256 * y + 128, -1);
  mpq_class twice = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const auto& a = part[i];
    const auto& b = part[(i + 1) % part.size()];
    twice += a.first * b.second - b.first * a.second;
  }
  return twice / (2 * 256 * 256);
}

/// The integral of the winding number over the square of pixel (x, y), in pixels.
inline mpq_class winding_area(const Contours& contours, int x, int y) {
  mpq_class sum = 0;
  for (const Contour& contour : contours) {
    CutContour part;
    for (const auto p : contour) part.emplace_back(p.x, p.y);
    sum += signed_area(std::move(part), x, y);
  }
  return sum;
}

/// The same folded by the rule: min(|w|, 1), or the distance from the nearest even number.
inline mpq_class coverage(const Contours& contours, bool even_odd, int x, int y) {
  mpq_class area = abs(winding_area(contours, x, y));
  if (!even_odd) return area > 1 ? mpq_class(1) : area;
  while (area > 2) area -= 2;
  return area > 1 ? mpq_class(2 - area) : area;
}

/// How much of the square of pixel (x, y) lies to the right of the line from a to b (going along it on a
/// screen), in closed form: a corner of the square is cut off, less what sticks out of it on two sides.
inline mpq_class half_plane_area(intaglio::linear::SubPoint a, intaglio::linear::SubPoint b, int x, int y) {
  const mpz_class dx = mpz_class(b.x) - a.x;
  const mpz_class dy = mpz_class(b.y) - a.y;
  const mpq_class distance = dx * (mpz_class(256) * y - a.y) - dy * (mpz_class(256) * x - a.x);
  const mpq_class across = 256 * abs(dy);
  const mpq_class down = 256 * abs(dx);
  const mpq_class reach = distance + (across + down) / 2;
  if (across == 0 || down == 0) {
    const mpq_class part = reach / (across + down);
    return part < 0 ? mpq_class(0) : part > 1 ? mpq_class(1) : part;
  }
  const auto square = [](const mpq_class& t) { return t > 0 ? mpq_class(t * t) : mpq_class(0); };
  return (square(reach) - square(reach - across) - square(reach - down) + square(reach - across - down)) /
         (2 * across * down);
}

}  // namespace oracle
