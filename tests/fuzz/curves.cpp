// SPDX-License-Identifier: MIT
//
// Circles, ellipses, rings, round rectangles, and arcs, pies and chords of them.
#include <intaglio/raster/arc.hpp>
#include <intaglio/raster/chord.hpp>
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/ellipse.hpp>
#include <intaglio/raster/ellipse_arc.hpp>
#include <intaglio/raster/ring.hpp>
#include <intaglio/raster/ring_arc.hpp>
#include <intaglio/raster/round_rect.hpp>
#include <tests/fuzz/scene.hpp>
#include <tests/oracle/circle.hpp>
#include <tests/oracle/oval.hpp>

namespace fuzz {
namespace {

using namespace intaglio::raster;
using intaglio::number::Angle;

/// The outline is what of the filled shape has a neighbour outside; told where all neighbours are seen.
void require_outline(const Rect& window, const Drawn& outline, const Drawn& filled) {
  require(outline.status == filled.status, "outline and filled shape disagree on the arguments");
  for_pixels({window.x + 1, window.y + 1, window.width - 2, window.height - 2}, [&](int x, int y) {
    const bool inner =
        filled.has(x - 1, y) && filled.has(x + 1, y) && filled.has(x, y - 1) && filled.has(x, y + 1);
    require(outline.has(x, y) == (filled.has(x, y) && !inner), "the outline isn't that of the filled shape");
  });
}

/// Compares with an oval of (a + 1) x (b + 1) pixels around a place in half pixels.
void require_oval(const Scene& scene, const Drawn& filled, std::int64_t middle_x, std::int64_t middle_y,
                  int a, int b) {
  if (!scene.small()) return;
  for_pixels(scene.window, [&](int x, int y) {
    const auto dx = static_cast<int>(2 * std::int64_t{x} - middle_x);
    const auto dy = static_cast<int>(2 * std::int64_t{y} - middle_y);
    require(filled.has(x, y) == oracle::in_oval(a, b, dx, dy), "not the oval's pixels");
  });
}

void circle(Input& in, const Scene& scene) {
  const Point centre = scene.point(in);
  const int radius = in.length();
  const auto outline = [&](auto& sink) { return draw_circle(sink, centre, radius); };
  const auto filled = [&](auto& sink) { return fill_disc(sink, centre, radius); };
  if (in.choice(2) == 0) {
    const Drawn whole = check(scene, in, outline);
    if (!whole.status.ok() || !scene.small()) return;
    for_pixels(scene.window, [&](int x, int y) {
      require(whole.has(x, y) == oracle::on_circle(radius, x - centre.x, y - centre.y),
              "draw_circle: not the circle's pixels");
    });
  } else {
    const Drawn whole = check(scene, in, filled);
    if (whole.status.ok())
      require_oval(scene, whole, 2 * std::int64_t{centre.x}, 2 * std::int64_t{centre.y}, 2 * radius,
                   2 * radius);
  }
}

void diametric(Input& in, const Scene& scene) {
  const Point corner = scene.point(in);
  const int diameter = in.length();
  const auto outline = [&](auto& sink) { return draw_circle_in(sink, corner, diameter); };
  const auto filled = [&](auto& sink) { return fill_disc_in(sink, corner, diameter); };
  const bool first = in.choice(2) == 0;
  const Drawn a = first ? check(scene, in, outline) : drawn(scene.window, outline);
  const Drawn b = first ? drawn(scene.window, filled) : check(scene, in, filled);
  require_outline(scene.window, a, b);
  if (b.status.ok() && diameter > 0)
    require_oval(scene, b, 2 * std::int64_t{corner.x} + diameter - 1,
                 2 * std::int64_t{corner.y} + diameter - 1, diameter - 1, diameter - 1);
}

void ellipse(Input& in, const Scene& scene) {
  const Point centre = scene.point(in);
  const int rx = in.length();
  const int ry = in.length();
  const auto outline = [&](auto& sink) { return draw_ellipse(sink, centre, rx, ry); };
  const auto filled = [&](auto& sink) { return fill_ellipse(sink, centre, rx, ry); };
  const bool first = in.choice(2) == 0;
  const Drawn a = first ? check(scene, in, outline) : drawn(scene.window, outline);
  const Drawn b = first ? drawn(scene.window, filled) : check(scene, in, filled);
  require_outline(scene.window, a, b);
  if (b.status.ok())
    require_oval(scene, b, 2 * std::int64_t{centre.x}, 2 * std::int64_t{centre.y}, 2 * rx, 2 * ry);
}

void ring(Input& in, const Scene& scene) {
  const Point centre = scene.point(in);
  const int inner = in.length();
  const int outer = in.length();
  const Drawn whole = check(scene, in, [&](auto& sink) { return fill_ring(sink, centre, inner, outer); });
  if (!whole.status.ok()) return;
  const Drawn sum = drawn(scene.window, [&](auto& sink) {
    const Status status = fill_ring(sink, centre, inner, outer);
    return status.ok() ? fill_disc(sink, centre, inner) : status;
  });
  require_same(sum, drawn(scene.window, [&](auto& sink) { return fill_disc(sink, centre, outer); }),
               "a ring and the disc inside aren't the disc");
}

/// A part in a sweep, and the part in the rest of the turn, make the whole. `size` is a radius or two.
template <class Part, class Whole, class... Size>
void swept(Input& in, const Scene& scene, Part part, Whole whole, Size... size) {
  const Point centre = scene.point(in);
  const auto start = Angle::from_steps(in.byte() * 256 + in.choice(3));
  const int kind = in.byte();
  const int sweep = kind < 0x80 ? kind * 1024 - 65536 : kind < 0xC0 ? in.medium() * 2 : in.any();
  const Drawn one = check(scene, in, [&](auto& sink) { return part(sink, centre, size..., start, sweep); });
  if (!one.status.ok() || sweep <= 0 || sweep >= Angle::turn) return;
  const Drawn both = drawn(scene.window, [&](auto& sink) {
    part(sink, centre, size..., start, sweep).ignore();
    return part(sink, centre, size..., start + Angle::from_steps(sweep), Angle::turn - sweep);
  });
  require_same(both, drawn(scene.window, [&](auto& sink) { return whole(sink, centre, size...); }),
               "a sweep and the rest of the turn aren't the whole");
}

void circle_arcs(Input& in, const Scene& scene) {
  const int what = in.choice(3);
  const int radius = in.length();
  const auto arc = [](auto& sink, auto... arguments) { return draw_arc(sink, arguments...); };
  const auto circle = [](auto& sink, auto... arguments) { return draw_circle(sink, arguments...); };
  const auto pie = [](auto& sink, auto... arguments) { return fill_pie(sink, arguments...); };
  const auto chord = [](auto& sink, auto... arguments) { return fill_chord(sink, arguments...); };
  const auto disc = [](auto& sink, auto... arguments) { return fill_disc(sink, arguments...); };
  if (what == 0) return swept(in, scene, arc, circle, radius);
  if (what == 1) return swept(in, scene, pie, disc, radius);
  swept(in, scene, chord, disc, radius);
}

void ring_arcs(Input& in, const Scene& scene) {
  const int inner = in.length();
  const int outer = in.length();
  const auto arc = [](auto& sink, auto... arguments) { return fill_ring_arc(sink, arguments...); };
  const auto whole = [](auto& sink, auto... arguments) { return fill_ring(sink, arguments...); };
  swept(in, scene, arc, whole, inner, outer);
}

void ellipse_arcs(Input& in, const Scene& scene) {
  const int what = in.choice(3);
  const int rx = in.length();
  const int ry = in.length();
  const auto arc = [](auto& sink, auto... arguments) { return draw_ellipse_arc(sink, arguments...); };
  const auto outline = [](auto& sink, auto... arguments) { return draw_ellipse(sink, arguments...); };
  const auto pie = [](auto& sink, auto... arguments) { return fill_ellipse_pie(sink, arguments...); };
  const auto chord = [](auto& sink, auto... arguments) { return fill_ellipse_chord(sink, arguments...); };
  const auto filled = [](auto& sink, auto... arguments) { return fill_ellipse(sink, arguments...); };
  if (what == 0) return swept(in, scene, arc, outline, rx, ry);
  if (what == 1) return swept(in, scene, pie, filled, rx, ry);
  swept(in, scene, chord, filled, rx, ry);
}

void round_rect(Input& in, const Scene& scene) {
  const Point corner = scene.point(in);
  const int width = in.length();
  const int height = in.length();
  const Rect r{corner.x, corner.y, width, height};
  CornerRadii radii = CornerRadii::all(in.length());
  if (in.choice(2) == 0) {
    radii.top_right = in.length();
    radii.bottom_right = in.length();
    radii.bottom_left = in.length();
  }
  const auto outline = [&](auto& sink) { return draw_round_rect(sink, r, radii); };
  const auto filled = [&](auto& sink) { return fill_round_rect(sink, r, radii); };
  const bool first = in.choice(2) == 0;
  const Drawn a = first ? check(scene, in, outline) : drawn(scene.window, outline);
  const Drawn b = first ? drawn(scene.window, filled) : check(scene, in, filled);
  require_outline(scene.window, a, b);
  for_pixels(scene.window, [&](int x, int y) {
    if (b.has(x, y))
      require(x >= r.x && y >= r.y && x < r.x + r.width && y < r.y + r.height, "outside the rectangle");
  });
}

}  // namespace

void run(Input in) {
  const int what = in.choice(8);
  const Scene scene(in);
  switch (what) {
    case 0:
      return circle(in, scene);
    case 1:
      return diametric(in, scene);
    case 2:
      return ellipse(in, scene);
    case 3:
      return ring(in, scene);
    case 4:
      return round_rect(in, scene);
    case 5:
      return circle_arcs(in, scene);
    case 6:
      return ring_arcs(in, scene);
    default:
      return ellipse_arcs(in, scene);
  }
}

}  // namespace fuzz
