// SPDX-License-Identifier: MIT
//
// Triangles and polygons: every way to fill them draws the same pixels, and those that the point tests say.
#include <intaglio/raster/convex.hpp>
#include <intaglio/raster/inside.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/polygon_basic.hpp>
#include <intaglio/raster/polygon_critical.hpp>
#include <intaglio/raster/triangle.hpp>
#include <intaglio/raster/triangle_box.hpp>
#include <tests/fuzz/polygon_input.hpp>

#include <array>

namespace fuzz {
namespace {

using namespace intaglio::raster;

void triangle(Input& in, const Scene& scene) {
  const SubPoint a = scene.sub_point(in);
  const SubPoint b = scene.sub_point(in);
  const SubPoint c = scene.sub_point(in);
  const auto walk = [&](auto& sink) { return fill_triangle(sink, a, b, c); };
  const auto box = [&](auto& sink) { return fill_triangle_box(sink, b, c, a); };
  const auto blocks = [&](auto& sink) { return fill_triangle_blocks(sink, c, b, a); };
  const int first = in.choice(3);
  const Drawn whole = first == 0   ? check(scene, in, walk)
                      : first == 1 ? check(scene, in, box)
                                   : check(scene, in, blocks);
  for (const Drawn& other :
       {drawn(scene.window, walk), drawn(scene.window, box), drawn(scene.window, blocks)}) {
    require_same(whole, other, "the ways to fill a triangle differ");
    require(other.status == whole.status, "the ways to fill a triangle answer differently");
  }
  if (!whole.status.ok()) return;
  const std::array<SubPoint, 3> corners{a, b, c};
  std::array<PolygonEdge, 3> workspace{};
  require_same(whole,
               drawn(scene.window,
                     [&](auto& sink) { return fill_polygon(sink, FillRule::even_odd, corners, workspace); }),
               "a triangle isn't the polygon of its corners");
  if (!scene.small()) return;
  for_pixels(scene.window, [&](int x, int y) {
    require(whole.has(x, y) == oracle::in_triangle(a, b, c, x, y), "fill_triangle: not the triangle");
  });
}

void pixel_triangle(Input& in, const Scene& scene) {
  const Point a = scene.point(in);
  const Point b = scene.point(in);
  const Point c = scene.point(in);
  const Drawn whole = check(scene, in, [&](auto& sink) { return fill_triangle(sink, a, b, c); });
  if (!whole.status.ok()) return;
  using intaglio::linear::to_subpixel;
  require_same(whole,
               drawn(scene.window,
                     [&](auto& sink) {
                       return fill_triangle_blocks(sink, to_subpixel(b), to_subpixel(a), to_subpixel(c));
                     }),
               "a triangle between pixels isn't that between sub-pixels");
}

void compare_with_point_tests(const Scene& scene, const Polygon& polygon, const Drawn& whole) {
  if (!scene.small()) return;
  const auto contours = polygon.contours();
  for_pixels(scene.window, [&](int x, int y) {
    const auto inside = inside_polygon(polygon.rule, polygon.vertices, polygon.lengths,
                                       intaglio::linear::to_subpixel(Point{x, y}));
    require(inside.ok() && inside.value() == whole.has(x, y), "inside_polygon isn't fill_polygon");
    require(inside.value() == oracle::in_polygon(contours, polygon.even_odd(), x, y),
            "fill_polygon: not the polygon's pixels");
  });
}

void compare_with_convex(Input& in, const Scene& scene, const Polygon& polygon, const Drawn& whole) {
  if (polygon.lengths.size() != 1) return;
  const bool convex = is_convex(polygon.vertices);
  const Drawn filled = check(scene, in, [&](auto& sink) { return fill_convex(sink, polygon.vertices); });
  require(filled.status.ok() == convex, "fill_convex and is_convex disagree");
  if (!convex) return;
  require_same(whole, filled, "fill_convex isn't fill_polygon");
  if (!scene.small()) return;
  for_pixels(scene.window, [&](int x, int y) {
    const auto inside = inside_convex(polygon.vertices, intaglio::linear::to_subpixel(Point{x, y}));
    require(inside.ok() && inside.value() == whole.has(x, y), "inside_convex isn't fill_convex");
  });
}

void polygon(Input& in, const Scene& scene) {
  const Polygon polygon(in, scene, 24);
  const auto rule = polygon.rule;
  const auto& vertices = polygon.vertices;
  const auto& lengths = polygon.lengths;
  oracle::RecordingSink probe(scene.window);
  auto edges = exact_workspace<PolygonEdge>(
      [&](std::span<PolygonEdge> space) { return fill_polygon(probe, rule, vertices, lengths, space); });
  auto crossings = exact_workspace<PolygonCrossing>([&](std::span<PolygonCrossing> space) {
    return fill_polygon_basic(probe, rule, vertices, lengths, space);
  });
  auto chains = exact_workspace<PolygonChain>([&](std::span<PolygonChain> space) {
    return fill_polygon_critical(probe, rule, vertices, lengths, space);
  });
  const auto active = [&](auto& sink) { return fill_polygon(sink, rule, vertices, lengths, edges); };
  const auto basic = [&](auto& sink) { return fill_polygon_basic(sink, rule, vertices, lengths, crossings); };
  const auto critical = [&](auto& sink) {
    return fill_polygon_critical(sink, rule, vertices, lengths, chains);
  };
  const int first = in.choice(3);
  const Drawn whole = first == 0   ? check(scene, in, active)
                      : first == 1 ? check(scene, in, basic)
                                   : check(scene, in, critical);
  for (const Drawn& other :
       {drawn(scene.window, active), drawn(scene.window, basic), drawn(scene.window, critical)}) {
    require_same(whole, other, "the ways to fill a polygon differ");
    require(other.status == whole.status, "the ways to fill a polygon answer differently");
  }
  const auto needed = polygon_workspace(vertices, lengths, scene.window);
  if (!whole.status.ok()) return;
  require(needed.ok() && needed.value() == edges.size(), "polygon_workspace isn't what fill_polygon needs");
  compare_with_point_tests(scene, polygon, whole);
  compare_with_convex(in, scene, polygon, whole);
}

}  // namespace

void run(Input in) {
  const int what = in.choice(4);
  const Scene scene(in);
  if (what == 0) return triangle(in, scene);
  if (what == 1) return pixel_triangle(in, scene);
  polygon(in, scene);
}

}  // namespace fuzz
