// SPDX-License-Identifier: MIT
//
// Pixels, straight runs, rectangles, lines by every rung, dashes, thick lines and polylines.
#include <intaglio/raster/dash.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/line_rungs.hpp>
#include <intaglio/raster/pixel.hpp>
#include <intaglio/raster/polyline.hpp>
#include <intaglio/raster/rectangle.hpp>
#include <intaglio/raster/thick_line.hpp>
#include <intaglio/raster/thick_line_rungs.hpp>
#include <tests/fuzz/workspace.hpp>
#include <tests/oracle/line.hpp>

#include <algorithm>
#include <cstdlib>

namespace fuzz {
namespace {

using namespace intaglio::raster;

void rectangles(Input& in, const Scene& scene) {
  const Point corner = scene.point(in);
  const int width = in.length();
  const int height = in.length();
  const Rect r{corner.x, corner.y, width, height};
  switch (in.choice(5)) {
    case 0:
      check(scene, in, [&](auto& sink) { return draw_pixel(sink, corner); });
      break;
    case 1:
      check(scene, in, [&](auto& sink) { return draw_horizontal(sink, corner, width); });
      break;
    case 2:
      check(scene, in, [&](auto& sink) { return draw_vertical(sink, corner, height); });
      break;
    case 3:
      check(scene, in, [&](auto& sink) { return draw_rect(sink, r); });
      break;
    default: {
      const Drawn filled = check(scene, in, [&](auto& sink) { return fill_rect(sink, r); });
      for_pixels(scene.window, [&](int x, int y) {
        const bool in_r =
            x >= r.x && y >= r.y && x - std::int64_t{r.x} < r.width && y - std::int64_t{r.y} < r.height;
        require(!filled.status.ok() || filled.has(x, y) == in_r, "fill_rect: not the rectangle's pixels");
      });
    }
  }
}

void line(Input& in, const Scene& scene) {
  const Point a = scene.point(in);
  const Point b = scene.point(in);
  const Drawn whole = check(scene, in, [&](auto& sink) { return draw_line(sink, a, b); });
  const Drawn back = drawn(scene.window, [&](auto& sink) { return draw_line(sink, b, a); });
  require_same(whole, back, "draw_line: from B to A isn't from A to B");
  if (!whole.status.ok() || !scene.small()) return;
  for_pixels(scene.window, [&](int x, int y) {
    require(whole.has(x, y) == oracle::on_line(a.x, a.y, b.x, b.y, x, y), "draw_line: not the nearest");
  });
}

/// A rung has the pixels of the exact line as long as it says that none can be wrong.
template <class Rung>
void line_by(Input& in, const Scene& scene) {
  const Point a = scene.point(in);
  const Point b = scene.point(in);
  const auto forth = [&](auto& sink) { return draw_line_by<Rung>(sink, a, b); };
  const Drawn whole = check(scene, in, forth);
  require_same(whole, drawn(scene.window, [&](auto& sink) { return draw_line_by<Rung>(sink, b, a); }),
               "draw_line_by: from B to A isn't from A to B");
  const Drawn exact = drawn(scene.window, [&](auto& sink) { return draw_line(sink, a, b); });
  require(whole.status == exact.status, "draw_line_by and draw_line answer differently");
  if (whole.status.ok() && Rung::wrong_pixels(std::max(std::abs(a.x - b.x), std::abs(a.y - b.y))) == 0)
    require_same(whole, exact, "draw_line_by: a pixel wrong where none can be");
}

void sub_line(Input& in, const Scene& scene) {
  const SubPoint a = scene.sub_point(in);
  const SubPoint b = scene.sub_point(in);
  const Drawn whole = check(scene, in, [&](auto& sink) { return draw_line(sink, a, b); });
  const Drawn back = drawn(scene.window, [&](auto& sink) { return draw_line(sink, b, a); });
  require_same(whole, back, "draw_line (sub-pixels): from B to A isn't from A to B");
  if (!whole.status.ok() || !scene.small()) return;
  for_pixels(scene.window, [&](int x, int y) {
    require(whole.has(x, y) == oracle::on_sub_line(a.x, a.y, b.x, b.y, x, y),
            "draw_line (sub-pixels): not the nearest");
  });
}

void dashes(Input& in, const Scene& scene) {
  const Point a = scene.point(in);
  const Point b = scene.point(in);
  const int on = in.length();
  const int off = in.length();
  const Drawn whole = check(scene, in, [&](auto& sink) { return draw_dashed_line(sink, a, b, on, off); });
  if (!whole.status.ok() || !scene.small()) return;
  for_pixels(scene.window, [&](int x, int y) {
    require(whole.has(x, y) == oracle::on_dash(a.x, a.y, b.x, b.y, on, off, x, y),
            "draw_dashed_line: not the dashes");
  });
}

/// One beyond those that there are, too.
Cap cap(Input& in) { return static_cast<Cap>(in.choice(4)); }

void thick(Input& in, const Scene& scene) {
  const Cap ends = cap(in);
  if (in.choice(2) == 0) {
    const SubPoint a = scene.sub_point(in);
    const SubPoint b = scene.sub_point(in);
    const int width = in.sub_coordinate(0, 32);
    const Drawn whole =
        check(scene, in, [&](auto& sink) { return draw_thick_line(sink, a, b, width, ends); });
    const Drawn back =
        drawn(scene.window, [&](auto& sink) { return draw_thick_line(sink, b, a, width, ends); });
    require_same(whole, back, "draw_thick_line: from B to A isn't from A to B");
    return;
  }
  const Point a = scene.point(in);
  const Point b = scene.point(in);
  const int width = in.length();
  check(scene, in, [&](auto& sink) { return draw_thick_line(sink, a, b, width, ends); });
}

void minor_thick(Input& in, const Scene& scene) {
  const SubPoint a = scene.sub_point(in);
  const SubPoint b = scene.sub_point(in);
  const int thickness = in.length();
  const Drawn whole =
      check(scene, in, [&](auto& sink) { return draw_minor_thick_line(sink, a, b, thickness); });
  require_same(whole,
               drawn(scene.window, [&](auto& sink) { return draw_minor_thick_line(sink, b, a, thickness); }),
               "draw_minor_thick_line: from B to A isn't from A to B");
  if (thickness == 1)
    require_same(whole, drawn(scene.window, [&](auto& sink) { return draw_line(sink, a, b); }),
                 "draw_minor_thick_line: one pixel thick it isn't the line");
}

void polyline(Input& in, const Scene& scene) {
  Stroke stroke;
  stroke.width = in.sub_coordinate(0, 32);
  stroke.join = static_cast<Join>(in.choice(4));
  stroke.cap = cap(in);
  stroke.closed = in.choice(2) == 1;
  stroke.miter_limit = in.sub_coordinate(18, 1);
  std::vector<SubPoint> points(static_cast<std::size_t>(in.choice(8)));
  for (SubPoint& p : points) p = scene.sub_point(in);
  oracle::RecordingSink probe(scene.window);
  auto edges = exact_workspace<StrokeEdge>(
      [&](std::span<StrokeEdge> space) { return draw_polyline(probe, points, stroke, space); });
  const Drawn whole =
      check(scene, in, [&](auto& sink) { return draw_polyline(sink, points, stroke, edges); });
  if (!whole.status.ok()) return;
  const auto needed = polyline_workspace(points, stroke, scene.window);
  require(needed.ok() && needed.value() == edges.size(), "polyline_workspace isn't what draw_polyline needs");
  // The way back may take other edges; 4 a segment and 6 a miter always do.
  std::reverse(points.begin(), points.end());
  edges.resize(10 * points.size() + 4);
  require_same(whole,
               drawn(scene.window, [&](auto& sink) { return draw_polyline(sink, points, stroke, edges); }),
               "draw_polyline: from the last point to the first isn't from the first to the last");
}

}  // namespace

void run(Input in) {
  const int what = in.choice(10);
  const Scene scene(in);
  switch (what) {
    case 0:
      return rectangles(in, scene);
    case 1:
      return line(in, scene);
    case 2:
      return sub_line(in, scene);
    case 3:
      return dashes(in, scene);
    case 4:
      return thick(in, scene);
    case 5:
      return polyline(in, scene);
    case 6:
      return line_by<RoundedLine>(in, scene);
    case 7:
      return line_by<SplitErrorLine>(in, scene);
    case 8:
      return line_by<DistanceLine>(in, scene);
    default:
      return minor_thick(in, scene);
  }
}

}  // namespace fuzz
