// SPDX-License-Identifier: MIT
//
// Single edges, for measuring how far levels of coverage are from the exact area.
#pragma once

#include <intaglio/linear/rect.hpp>
#include <tests/oracle/coverage.hpp>
#include <tests/oracle/level_sink.hpp>
#include <tests/oracle/random.hpp>

#include <algorithm>
#include <cstdint>
#include <gmpxx.h>
#include <utility>

namespace tests {

using intaglio::linear::SubPoint;

/// A large quadrilateral of which only the side from a to b comes near the middle; the inside is to its
/// right.
inline oracle::Contour half_plane(SubPoint a, SubPoint b) {
  return {a, b, {b.x + a.y - b.y, b.y + b.x - a.x}, {a.x + a.y - b.y, a.y + b.x - a.x}};
}

/// An edge through the middle of the picture, at any angle, some along rows, columns and diagonals.
inline std::pair<SubPoint, SubPoint> random_edge(oracle::Random& random, int i) {
  SubPoint a{9000, random.between(-9000, 9000)};
  if (i % 4 == 0) a.y = 0;
  if (i % 4 == 1) a.y = a.x;
  if (i % 3 == 0) std::swap(a.x, a.y);
  if (i % 2 == 0) a = {-a.x, -a.y};
  const SubPoint off{random.between(-300, 300), random.between(-300, 300)};
  return {{a.x + off.x, a.y + off.y}, {off.x - a.x, off.y - a.y}};
}

/// How far from the exact area the levels of a way of drawing edges are at most, in levels.
template <class Levels>
mpq_class worst_edge(int seed, int edges, Levels levels) {
  oracle::Random random(static_cast<std::uint32_t>(seed));
  mpq_class worst = 0;
  for (int i = 0; i < edges; ++i) {
    const auto [a, b] = random_edge(random, i);
    const oracle::LevelSink sink = levels(half_plane(a, b), intaglio::linear::Rect{-4, -4, 9, 9});
    for (int y = -4; y < 5; ++y)
      for (int x = -4; x < 5; ++x)
        worst = std::max<mpq_class>(worst, abs(255 * oracle::half_plane_area(a, b, x, y) - sink.level(x, y)));
  }
  return worst;
}

}  // namespace tests
