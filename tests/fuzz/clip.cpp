// SPDX-License-Identifier: MIT
//
// The three line clippers, Sutherland-Hodgman, the stack of clips, and drawing through a polygon.
#include <intaglio/clip/clip_stack.hpp>
#include <intaglio/clip/convex.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/polygon_clip.hpp>
#include <tests/clip/line_window_difference.hpp>
#include <tests/fuzz/polygon_input.hpp>

namespace fuzz {
namespace {

using intaglio::clip::clip_to_convex;
using intaglio::clip::ClipStage;
using Points = std::vector<SubPoint>;
__extension__ using Int = __int128;

void line_window(Input& in, const Scene& scene) {
  using namespace intaglio::clip;
  const SubPoint a = scene.sub_point(in);
  const SubPoint b = scene.sub_point(in);
  const SubPoint corner = scene.sub_point(in);
  const int width = in.sub_coordinate(16, 32);
  const int height = in.sub_coordinate(16, 32);
  const intaglio::linear::SubRect window{corner.x, corner.y, width, height};
  const Status status = liang_barsky(a, b, window).status();
  require(cohen_sutherland(a, b, window).status() == status && skala(a, b, window).status() == status,
          "the line clippers answer differently");
  if (status.ok()) require(tests::difference(a, b, window).empty(), tests::difference(a, b, window));
}

Int side(SubPoint from, SubPoint to, SubPoint p) {
  return (Int{to.x} - from.x) * (Int{p.y} - from.y) - (Int{to.y} - from.y) * (Int{p.x} - from.x);
}

/// No vertex further outside than the roundings explain: 0.71 sub-pixels an edge of the clipper.
void require_inside(const Points& clipper, std::span<const SubPoint> result) {
  Int area = 0;
  for (std::size_t e = 0; e < clipper.size(); ++e)
    area += side(clipper[0], clipper[e], clipper[(e + 1) % clipper.size()]);
  const auto edges = static_cast<int>(clipper.size());
  for (const SubPoint p : result)
    for (std::size_t e = 0; e < clipper.size(); ++e) {
      const SubPoint a = clipper[e];
      const SubPoint b = clipper[(e + 1) % clipper.size()];
      const Int distance = area < 0 ? -side(a, b, p) : side(a, b, p);
      const Int dx = Int{b.x} - a.x;
      const Int dy = Int{b.y} - a.y;
      // By quotients: the squares have up to 118 bits.
      if (distance < 0 && distance * distance / (dx * dx + dy * dy) > edges * edges / 2 + 1)
        report("clip_to_convex: a vertex outside the clipper");
    }
}

void convex(Input& in, const Scene& scene) {
  Points polygon(static_cast<std::size_t>(in.choice(10)));
  for (SubPoint& p : polygon) p = scene.sub_point(in);
  Points clipper;
  const bool upright = in.choice(2) == 0;
  if (upright) {
    const SubPoint a = scene.sub_point(in);
    const SubPoint b = scene.sub_point(in);
    clipper = {a, {b.x, a.y}, b, {a.x, b.y}};
  } else {
    clipper.resize(static_cast<std::size_t>(in.choice(8)));
    for (SubPoint& p : clipper) p = scene.sub_point(in);
  }
  Points out;
  std::vector<ClipStage> workspace;
  auto result = clip_to_convex(polygon, clipper, out, workspace);
  for (int call = 0; result.status().error() == intaglio::Error::too_small; ++call) {
    require(call < 64, "clip_to_convex never has enough");
    const std::size_t needed = result.status().needed();
    if (result.status().argument() == intaglio::Argument::workspace) {
      require(needed > workspace.size(), "clip_to_convex needs no more than it has");
      workspace.resize(needed);
    } else {
      require(needed > out.size(), "clip_to_convex needs no more than it has");
      out.resize(needed);
    }
    result = clip_to_convex(polygon, clipper, out, workspace);
  }
  if (!result.ok()) return;
  require_inside(clipper, result.value());
  if (!upright) return;
  for (const SubPoint p : result.value())
    require(p.x >= std::min(clipper[0].x, clipper[2].x) && p.x <= std::max(clipper[0].x, clipper[2].x) &&
                p.y >= std::min(clipper[0].y, clipper[2].y) && p.y <= std::max(clipper[0].y, clipper[2].y),
            "clip_to_convex: a vertex outside the rectangle");
}

void stack(Input& in, const Scene& scene) {
  intaglio::clip::ClipStack<4> clips(scene.window);
  std::vector<Rect> tops{scene.window};
  while (!in.empty()) {
    if (in.choice(3) == 0) {
      require(clips.pop().ok() == (tops.size() > 1), "ClipStack: pop");
      if (tops.size() > 1) tops.pop_back();
    } else {
      const Point corner = scene.point(in);
      const int width = in.length();
      const int height = in.length();
      const Rect area{corner.x, corner.y, width, height};
      if (clips.push(area).ok()) {
        require(tops.size() <= 4, "ClipStack: more levels than it has");
        const Rect common = clips.top();
        for_pixels(scene.window, [&](int x, int y) {
          const bool expected = tops.back().contains({x, y}) && area.contains({x, y});
          require(common.contains({x, y}) == expected, "ClipStack: not what the rectangles have in common");
        });
        tops.push_back(common);
      }
    }
    require(clips.top() == tops.back() && clips.depth() == static_cast<int>(tops.size()) - 1,
            "ClipStack: another top");
    require(clips.top().width >= 0 && clips.top().height >= 0, "ClipStack: negative extent");
  }
}

void through_polygon(Input& in, const Scene& scene) {
  using namespace intaglio::raster;
  const Polygon polygon(in, scene, 12);
  const auto over = [&](std::span<PolygonEdge> edges, std::span<RowSpan> spans) {
    return PolygonClip::over(polygon.rule, polygon.vertices, polygon.lengths, scene.window, edges, spans);
  };
  auto edges =
      exact_workspace<PolygonEdge>([&](std::span<PolygonEdge> space) { return over(space, {}).status(); });
  std::vector<RowSpan> spans;
  auto made = over(edges, spans);
  if (made.status().error() == intaglio::Error::too_small) {
    require(made.status().argument() == intaglio::Argument::table, "PolygonClip: too little of what?");
    spans.resize(made.status().needed());
    made = over(edges, spans);
  }
  const Drawn filled = drawn(scene.window, [&](auto& sink) {
    return fill_polygon(sink, polygon.rule, polygon.vertices, polygon.lengths, edges);
  });
  require(made.status() == filled.status, "PolygonClip and fill_polygon answer differently");
  if (!made.ok()) return;
  const PolygonClip& clip = made.value();
  const Point a = scene.point(in);
  const Point b = scene.point(in);
  const int radius = in.length();
  const bool line = in.choice(2) == 0;
  const auto draw = [&](auto& sink) { return line ? draw_line(sink, a, b) : fill_disc(sink, a, radius); };
  const auto inside = [&](auto& sink) {
    PolygonClipped clipped(sink, clip);
    return draw(clipped);
  };
  const Drawn all = drawn(scene.window, draw);
  const Drawn some = check(scene, in, inside);
  for_pixels(scene.window, [&](int x, int y) {
    require(some.has(x, y) == (all.has(x, y) && filled.has(x, y)), "not what lies inside the polygon");
  });
}

}  // namespace

void run(Input in) {
  const int what = in.choice(4);
  const Scene scene(in);
  if (what == 0) return line_window(in, scene);
  if (what == 1) return convex(in, scene);
  if (what == 2) return through_polygon(in, scene);
  stack(in, scene);
}

}  // namespace fuzz
