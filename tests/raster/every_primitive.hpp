// SPDX-License-Identifier: MIT
//
// Every primitive that draws spans, by name, with random figures for it: for what all of them must do.
#pragma once

#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/arc.hpp>
#include <intaglio/raster/chord.hpp>
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/convex.hpp>
#include <intaglio/raster/dash.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/ellipse.hpp>
#include <intaglio/raster/ellipse_arc.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/line_rungs.hpp>
#include <intaglio/raster/pixel.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/polygon_basic.hpp>
#include <intaglio/raster/polygon_critical.hpp>
#include <intaglio/raster/polyline.hpp>
#include <intaglio/raster/rectangle.hpp>
#include <intaglio/raster/ring.hpp>
#include <intaglio/raster/ring_arc.hpp>
#include <intaglio/raster/round_rect.hpp>
#include <intaglio/raster/thick_line.hpp>
#include <intaglio/raster/thick_line_rungs.hpp>
#include <intaglio/raster/triangle.hpp>
#include <intaglio/raster/triangle_box.hpp>
#include <tests/oracle/random.hpp>

#include <algorithm>
#include <array>

namespace tests {

/// Numbers from which every primitive takes what it needs.
struct Figure {
  std::array<intaglio::linear::Point, 3> points;
  std::array<intaglio::linear::SubPoint, 6> places;
  intaglio::linear::Point centre;  // of a circle whose outline passes the window
  int radius;
  int other_radius;
  int width;
  intaglio::number::Angle start;
  int sweep;
};

/// A figure that a window around (32, 24) most likely sees, of a size up to `reach`, 2^20 at most.
inline Figure random_figure(oracle::Random& random, int reach) {
  constexpr int limit = 1 << 20;
  const auto inside = [=](int c) { return std::clamp(c, -limit, limit); };
  const auto anywhere = [&] { return random.between(-reach, reach); };
  Figure f{};
  for (auto& p : f.points) p = {inside(32 + anywhere()), inside(24 + anywhere())};
  // The middle of two of them, or one, is near the window.
  if (random.between(0, 1) == 0)
    f.points[1] = {inside(64 - f.points[0].x + random.between(-9, 9)),
                   inside(48 - f.points[0].y + random.between(-9, 9))};
  else
    f.points[0] = {random.between(-5, 69), random.between(-5, 53)};
  for (std::size_t i = 0; i < f.places.size(); ++i) {
    const int x = i < 3 ? f.points[i].x : inside(32 + anywhere());
    const int y = i < 3 ? f.points[i].y : inside(24 + anywhere());
    f.places[i] = {std::clamp(x * 256 + random.between(-200, 200), -limit * 256, limit * 256),
                   std::clamp(y * 256 + random.between(-200, 200), -limit * 256, limit * 256)};
  }
  f.radius = random.between(0, reach);
  f.other_radius = random.between(0, 2) == 0 ? f.radius : random.between(0, reach);
  const std::array<std::array<int, 2>, 8> ways{
      {{5, 0}, {0, 5}, {-5, 0}, {0, -5}, {3, 4}, {-4, 3}, {-3, -4}, {4, -3}}};
  const auto way = ways[static_cast<std::size_t>(random.between(0, 7))];
  f.centre = {inside(random.between(0, 63) - f.radius / 5 * way[0]),
              inside(random.between(0, 47) - f.radius / 5 * way[1])};
  f.width = random.between(0, random.between(0, 3) == 0 ? reach : std::min(reach, 12));
  f.start = intaglio::number::Angle::from_steps(random.between(0, 65535));
  f.sweep = random.between(-70000, 70000);
  return f;
}

template <class S>
struct NamedPrimitive {
  const char* name;
  intaglio::Status (*draw)(S& sink, const Figure& f);
};

/// All of them; `S` is a span sink.
template <class S>
const auto& every_primitive() {
  using namespace intaglio::raster;
  using intaglio::linear::Point;
  using intaglio::linear::Rect;
  static constexpr auto box = [](const Figure& f) {
    constexpr int limit = 1 << 20;
    const int x = std::min(f.points[0].x, f.points[1].x);
    const int y = std::min(f.points[0].y, f.points[1].y);
    return Rect{x, y, std::min(std::max(f.points[0].x, f.points[1].x) - x, 2 * limit),
                std::min(std::max(f.points[0].y, f.points[1].y) - y, 2 * limit)};
  };
  static constexpr auto corner = [](const Figure& f) {
    return Point{std::max(f.centre.x - f.radius, -(1 << 20)), std::max(f.centre.y - f.radius, -(1 << 20))};
  };
  static constexpr std::array two_contours{4, 2};
  static constexpr std::array two_triangles{3, 3};
  static const std::array list{
      NamedPrimitive<S>{"pixel", [](S& s, const Figure& f) { return draw_pixel(s, f.points[0]); }},
      NamedPrimitive<S>{"horizontal",
                        [](S& s, const Figure& f) { return draw_horizontal(s, f.points[0], f.radius); }},
      NamedPrimitive<S>{"vertical",
                        [](S& s, const Figure& f) { return draw_vertical(s, f.points[0], f.radius); }},
      NamedPrimitive<S>{"rectangle", [](S& s, const Figure& f) { return draw_rect(s, box(f)); }},
      NamedPrimitive<S>{"filled rectangle", [](S& s, const Figure& f) { return fill_rect(s, box(f)); }},
      NamedPrimitive<S>{"line",
                        [](S& s, const Figure& f) { return draw_line(s, f.points[0], f.points[1]); }},
      NamedPrimitive<S>{"sub-pixel line",
                        [](S& s, const Figure& f) { return draw_line(s, f.places[0], f.places[1]); }},
      NamedPrimitive<S>{"dashed line",
                        [](S& s, const Figure& f) {
                          return draw_dashed_line(s, f.points[0], f.points[1], 1 + f.width % 7,
                                                  f.width % 5);
                        }},
      NamedPrimitive<S>{"thick line, butt",
                        [](S& s, const Figure& f) {
                          return draw_thick_line(s, f.places[0], f.places[1], f.width * 200, Cap::butt);
                        }},
      NamedPrimitive<S>{"thick line, square",
                        [](S& s, const Figure& f) {
                          return draw_thick_line(s, f.places[0], f.places[1], f.width * 200, Cap::square);
                        }},
      NamedPrimitive<S>{"thick line, round",
                        [](S& s, const Figure& f) {
                          return draw_thick_line(s, f.places[0], f.places[1], f.width * 200, Cap::round);
                        }},
      NamedPrimitive<S>{"line, rounded slope",
                        [](S& s, const Figure& f) {
                          return draw_line_by<RoundedLine>(s, f.points[0], f.points[1]);
                        }},
      NamedPrimitive<S>{"line, split error",
                        [](S& s, const Figure& f) {
                          return draw_line_by<SplitErrorLine>(s, f.points[0], f.points[1]);
                        }},
      NamedPrimitive<S>{"line thick along its minor axis",
                        [](S& s, const Figure& f) {
                          return draw_minor_thick_line(s, f.places[0], f.places[1], f.width);
                        }},
      NamedPrimitive<S>{"polyline",
                        [](S& s, const Figure& f) {
                          std::array<StrokeEdge, 80> workspace;
                          Stroke stroke;
                          stroke.width = f.width * 200;
                          stroke.join = static_cast<Join>(f.radius % 3);
                          stroke.cap = static_cast<Cap>(f.other_radius % 3);
                          stroke.closed = f.sweep % 2 == 0;
                          return draw_polyline(s, f.places, stroke, workspace);
                        }},
      NamedPrimitive<S>{"circle",
                        [](S& s, const Figure& f) { return draw_circle(s, f.centre, f.radius); }},
      NamedPrimitive<S>{"disc", [](S& s, const Figure& f) { return fill_disc(s, f.centre, f.radius); }},
      NamedPrimitive<S>{"circle by diameter",
                        [](S& s, const Figure& f) { return draw_circle_in(s, corner(f), 2 * f.radius); }},
      NamedPrimitive<S>{"disc by diameter",
                        [](S& s, const Figure& f) { return fill_disc_in(s, corner(f), 2 * f.radius); }},
      NamedPrimitive<S>{"ring",
                        [](S& s, const Figure& f) {
                          return fill_ring(s, f.centre, std::min(f.radius, f.other_radius), f.radius);
                        }},
      NamedPrimitive<S>{"arc of a ring",
                        [](S& s, const Figure& f) {
                          return fill_ring_arc(s, f.centre, std::min(f.radius, f.other_radius), f.radius,
                                               f.start, f.sweep);
                        }},
      NamedPrimitive<S>{"arc",
                        [](S& s, const Figure& f) {
                          return draw_arc(s, f.centre, f.radius, f.start, f.sweep);
                        }},
      NamedPrimitive<S>{"pie",
                        [](S& s, const Figure& f) {
                          return fill_pie(s, f.centre, f.radius, f.start, f.sweep);
                        }},
      NamedPrimitive<S>{"chord",
                        [](S& s, const Figure& f) {
                          return fill_chord(s, f.centre, f.radius, f.start, f.sweep);
                        }},
      NamedPrimitive<S>{"ellipse",
                        [](S& s, const Figure& f) {
                          return draw_ellipse(s, f.centre, f.radius, f.other_radius);
                        }},
      NamedPrimitive<S>{"filled ellipse",
                        [](S& s, const Figure& f) {
                          return fill_ellipse(s, f.centre, f.radius, f.other_radius);
                        }},
      NamedPrimitive<S>{"arc of an ellipse",
                        [](S& s, const Figure& f) {
                          return draw_ellipse_arc(s, f.centre, f.radius, f.other_radius, f.start, f.sweep);
                        }},
      NamedPrimitive<S>{"pie of an ellipse",
                        [](S& s, const Figure& f) {
                          return fill_ellipse_pie(s, f.centre, f.radius, f.other_radius, f.start, f.sweep);
                        }},
      NamedPrimitive<S>{"chord of an ellipse",
                        [](S& s, const Figure& f) {
                          return fill_ellipse_chord(s, f.centre, f.radius, f.other_radius, f.start,
                                                    f.sweep);
                        }},
      NamedPrimitive<S>{"round rectangle",
                        [](S& s, const Figure& f) {
                          return draw_round_rect(s, box(f), {f.radius, f.width, f.other_radius, 3});
                        }},
      NamedPrimitive<S>{"filled round rectangle",
                        [](S& s, const Figure& f) {
                          return fill_round_rect(s, box(f), {f.radius, f.width, f.other_radius, 3});
                        }},
      NamedPrimitive<S>{"triangle",
                        [](S& s, const Figure& f) {
                          return fill_triangle(s, f.places[0], f.places[1], f.places[2]);
                        }},
      NamedPrimitive<S>{"triangle by its box",
                        [](S& s, const Figure& f) {
                          return fill_triangle_box(s, f.places[0], f.places[1], f.places[2]);
                        }},
      NamedPrimitive<S>{"triangle by blocks",
                        [](S& s, const Figure& f) {
                          return fill_triangle_blocks(s, f.places[0], f.places[1], f.places[2]);
                        }},
      NamedPrimitive<S>{"polygon",
                        [](S& s, const Figure& f) {
                          std::array<PolygonEdge, 6> workspace;
                          return fill_polygon(s, FillRule::even_odd, f.places, two_triangles, workspace);
                        }},
      NamedPrimitive<S>{"polygon, basic",
                        [](S& s, const Figure& f) {
                          std::array<PolygonCrossing, 6> workspace;
                          return fill_polygon_basic(s, FillRule::non_zero, f.places, two_contours,
                                                    workspace);
                        }},
      NamedPrimitive<S>{"polygon by critical points",
                        [](S& s, const Figure& f) {
                          std::array<PolygonChain, 6> workspace;
                          return fill_polygon_critical(s, FillRule::non_zero, f.places, two_contours,
                                                       workspace);
                        }},
      NamedPrimitive<S>{"convex polygon", [](S& s, const Figure& f) {
                          return fill_convex(s, std::span(f.places).template first<3>());
                        }}};
  return list;
}

}  // namespace tests
