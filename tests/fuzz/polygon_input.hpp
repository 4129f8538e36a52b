// SPDX-License-Identifier: MIT
//
// Polygons as a fuzzer makes them: contours that touch, cross and repeat themselves, and lengths that don't
// add up.
#pragma once

#include <intaglio/raster/contours.hpp>
#include <tests/fuzz/workspace.hpp>
#include <tests/oracle/polygon.hpp>

#include <cstddef>
#include <vector>

namespace fuzz {

struct Polygon {
  intaglio::raster::FillRule rule{};
  std::vector<SubPoint> vertices;
  std::vector<int> lengths;

  Polygon(Input& in, const Scene& scene, int most_vertices) {
    const int kind = in.byte();
    // One rule beyond those that there are.
    rule = static_cast<intaglio::raster::FillRule>(kind % 16 == 15 ? 2 : kind % 2);
    const int contours = 1 + (kind >> 4 & 3);
    for (int c = 0; c < contours; ++c) {
      const int length = in.choice(most_vertices / contours + 1);
      for (int i = 0; i < length; ++i) vertices.push_back(vertex(in, scene));
      lengths.push_back(length);
    }
    if (kind >= 0xF0) lengths[0] = in.any();
  }

  [[nodiscard]] bool even_odd() const { return rule == intaglio::raster::FillRule::even_odd; }
  /// For oracles. Only for polygons that the library takes.
  [[nodiscard]] oracle::Contours contours() const {
    oracle::Contours result;
    auto next = vertices.begin();
    for (const int length : lengths) {
      result.emplace_back(next, next + length);
      next += length;
    }
    return result;
  }

 private:
  SubPoint vertex(Input& in, const Scene& scene) {
    const int back = in.byte();
    // Now and then a vertex that is there already, or one level with it.
    if (back >= 0xF0 && !vertices.empty()) {
      SubPoint old = vertices[static_cast<std::size_t>(back & 15) % vertices.size()];
      if (back >= 0xF8) old.x = scene.sub_point(in).x;
      return old;
    }
    return scene.sub_point(in);
  }
};

}  // namespace fuzz
