// SPDX-License-Identifier: MIT
//
// Contours for the tests of polygons and of what covers them: random ones, as text, and as the library takes
// them.
#pragma once

#include <tests/oracle/polygon.hpp>
#include <tests/oracle/random.hpp>
#include <tests/raster/text.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace tests {

/// All vertices in a row, and how many belong to each contour.
struct FlatContours {
  std::vector<intaglio::linear::SubPoint> vertices;
  std::vector<int> lengths;
};

inline FlatContours flat(const oracle::Contours& contours) {
  FlatContours out;
  for (const auto& contour : contours) {
    out.vertices.insert(out.vertices.end(), contour.begin(), contour.end());
    out.lengths.push_back(static_cast<int>(contour.size()));
  }
  return out;
}

inline std::string text(const oracle::Contours& contours) {
  std::string out;
  for (const auto& contour : contours) {
    out += "[";
    for (const auto p : contour) out += text(p);
    out += "]";
  }
  return out;
}

/// Vertices that are multiples of `step`, not further than `bound` from (0, 0) along either axis.
inline oracle::Contour random_contour(oracle::Random& random, int vertices, int bound, int step) {
  oracle::Contour contour;
  for (int i = 0; i < vertices; ++i) {
    const int x = random.between(-bound, bound) / step * step;
    contour.push_back({x, random.between(-bound, bound) / step * step});
  }
  return contour;
}

/// Steps along an axis or a diagonal of a coarse grid of 9 x 9 pixels: plateaus, several minima on one row,
/// collinear runs, repeated vertices and edges.
inline oracle::Contour random_walk(oracle::Random& random, int vertices) {
  oracle::Contour contour;
  intaglio::linear::SubPoint p{random.between(0, 8) * 256, random.between(0, 8) * 256};
  for (int i = 0; i < vertices; ++i) {
    contour.push_back(p);
    const int x = std::clamp(p.x + random.between(-1, 1) * 512, 0, 2048);
    p = {x, std::clamp(p.y + random.between(-1, 1) * 512, 0, 2048)};
  }
  return contour;
}

/// A small window around a place on the way from a to b; `along` of 1024 parts.
inline intaglio::linear::Rect window_on_edge(intaglio::linear::SubPoint a, intaglio::linear::SubPoint b,
                                             int along, int width, int height) {
  const auto x = static_cast<int>((a.x + (std::int64_t{b.x} - a.x) * along / 1024) / 256);
  const auto y = static_cast<int>((a.y + (std::int64_t{b.y} - a.y) * along / 1024) / 256);
  constexpr int limit = 1 << 20;
  return {std::clamp(x - width / 2, -limit, limit), std::clamp(y - height / 2, -limit, limit), width, height};
}

}  // namespace tests
