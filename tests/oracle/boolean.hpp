// SPDX-License-Identifier: MIT
//
// Two polygons combined by even-odd, in rational numbers of any length: areas by slabs between all the
// heights at which anything begins, ends or crosses, where every edge is straight and in order; membership of
// places one by one.
#pragma once

#include <intaglio/linear/point.hpp>

#include <algorithm>
#include <cstddef>
#include <gmpxx.h>
#include <utility>
#include <vector>

namespace oracle {

struct RationalPoint {
  mpq_class x, y;
};
using RationalContour = std::vector<RationalPoint>;
using RationalContours = std::vector<RationalContour>;

inline RationalContours rational(const std::vector<std::vector<intaglio::linear::SubPoint>>& contours) {
  RationalContours result;
  for (const auto& contour : contours) {
    result.emplace_back();
    for (const auto p : contour) result.back().push_back({p.x, p.y});
  }
  return result;
}

/// Half the sum of the cross products of neighbours.
inline mpq_class signed_area(const RationalContours& contours) {
  mpq_class sum = 0;
  for (const RationalContour& contour : contours)
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const RationalPoint& p = contour[i];
      const RationalPoint& q = contour[(i + 1) % contour.size()];
      sum += p.x * q.y - p.y * q.x;
    }
  return sum / 2;
}

/// The area of the places that `taken(in_a, in_b)` says.
template <class Taken>
mpq_class combined_area(const RationalContours& a, const RationalContours& b, Taken taken) {
  struct Edge {
    RationalPoint top, bottom;
    mpq_class slope;  // of x over y
    bool of_b;
  };
  std::vector<Edge> edges;
  std::vector<mpq_class> heights;
  for (const bool of_b : {false, true})
    for (const RationalContour& contour : of_b ? b : a)
      for (std::size_t i = 0; i < contour.size(); ++i) {
        RationalPoint p = contour[i];
        RationalPoint q = contour[(i + 1) % contour.size()];
        heights.push_back(p.y);
        if (p.y == q.y) continue;
        if (q.y < p.y) std::swap(p, q);
        mpq_class slope = (q.x - p.x) / (q.y - p.y);
        edges.push_back({p, q, slope, of_b});
      }
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Edge& e = edges[i];
      const Edge& f = edges[j];
      if (e.slope == f.slope) continue;
      // e.x + e.slope * (y - e.y) = f.x + f.slope * (y - f.y)
      mpq_class y = (f.top.x - f.slope * f.top.y - e.top.x + e.slope * e.top.y) / (e.slope - f.slope);
      if (y > e.top.y && y > f.top.y && y < e.bottom.y && y < f.bottom.y) heights.push_back(std::move(y));
    }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  mpq_class area = 0;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const mpq_class middle = (heights[i] + heights[i + 1]) / 2;
    std::vector<std::pair<mpq_class, bool>> crossings;
    for (const Edge& e : edges)
      if (e.top.y < middle && middle < e.bottom.y)
        crossings.emplace_back(e.top.x + e.slope * (middle - e.top.y), e.of_b);
    std::sort(crossings.begin(), crossings.end());
    bool in_a = false;
    bool in_b = false;
    mpq_class width = 0;
    for (const auto& [x, of_b] : crossings) {
      const bool before = taken(in_a, in_b);
      (of_b ? in_b : in_a) ^= true;
      if (before && !taken(in_a, in_b)) width += x;
      if (!before && taken(in_a, in_b)) width -= x;
    }
    area += width * (heights[i + 1] - heights[i]);
  }
  return area;
}

/// True if an odd number of turns winds around the place; places on an edge belong to what lies to their
/// right, on a level edge to what lies below.
inline bool in_rational(const RationalContours& contours, const mpq_class& x, const mpq_class& y) {
  bool in = false;
  for (const RationalContour& contour : contours)
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const RationalPoint* p = &contour[i];
      const RationalPoint* q = &contour[(i + 1) % contour.size()];
      if (q->y < p->y) std::swap(p, q);
      if (p->y <= y && y < q->y && (x - p->x) * (q->y - p->y) >= (y - p->y) * (q->x - p->x)) in = !in;
    }
  return in;
}

}  // namespace oracle
