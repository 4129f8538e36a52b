// SPDX-License-Identifier: MIT
//
// Circles and discs by definition, in 128-bit integers.
#pragma once

#include <tests/oracle/span_list.hpp>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace oracle {

__extension__ using Wide = __int128;

/// True if the outline of radius r around (0, 0) has the pixel (dx, dy): seen from the nearer axis the larger
/// coordinate is the integer nearest to sqrt(r^2 - smaller^2).
inline bool on_circle(int r, int dx, int dy) {
  const Wide t = std::min(std::abs(dx), std::abs(dy));
  const Wide v = std::max(std::abs(dx), std::abs(dy));
  const Wide square = Wide{r} * r - t * t;
  if (v == 0) return square == 0;
  return (2 * v - 1) * (2 * v - 1) < 4 * square && 4 * square < (2 * v + 1) * (2 * v + 1);
}

/// The largest n with n*n <= square, bit by bit.
inline int floor_root(Wide square) {
  int root = 0;
  for (int bit = 1 << 22; bit > 0; bit /= 2)
    if (Wide{root + bit} * (root + bit) <= square) root += bit;
  return root;
}

/// How far the outline of radius r reaches on row dy; -1 if it isn't there. Looked for pixel by pixel from
/// outside: an outline pixel is at most half a pixel further out than the circle.
inline int outline_reach(int r, int dy) {
  const int row = std::abs(dy);
  if (row > r) return -1;
  const int inner = row > 0 ? row - 1 : 0;
  int x = floor_root(Wide{r} * r - Wide{inner} * inner) + 2;
  while (!on_circle(r, x, row)) --x;
  return x;
}

/// The outline around (0, 0), row by row: a run on either side, or one where they meet.
inline std::vector<Span> circle_runs(int r) {
  std::vector<Span> runs;
  for (int y = -r; y <= r; ++y) {
    const int reach = outline_reach(r, y);
    int begin = reach;
    while (begin > 0 && on_circle(r, begin - 1, y)) --begin;
    if (begin == 0) {
      runs.push_back({y, -reach, reach + 1});
    } else {
      runs.push_back({y, -reach, -begin + 1});
      runs.push_back({y, begin, reach + 1});
    }
  }
  return runs;
}

}  // namespace oracle
