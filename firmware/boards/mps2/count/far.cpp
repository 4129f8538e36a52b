// SPDX-License-Identifier: MIT
//
// Counted in pairs: a primitive that just fills the window, and the same a million pixels large and across
// the window's middle. What can't be seen must cost next to nothing: tests/target/bounded_work reads these.
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/dash.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/ellipse.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/ring.hpp>
#include <intaglio/raster/ring_arc.hpp>
#include <intaglio/raster/round_rect.hpp>
#include <intaglio/raster/thick_line.hpp>
#include <intaglio/raster/triangle.hpp>

#include <firmware/boards/mps2/count/rig.hpp>

namespace boards::mps2 {

namespace {

using raster::FillRule;

constexpr int reach = 500'000;  // from the window's middle: a million from end to end
constexpr Point middle{160, 120};

constexpr auto filling_wheel = gear<20>({160 * 256, 120 * 256}, 119 * 256, 60 * 256);
constexpr auto far_wheel = gear<20>({160 * 256, 120 * 256}, reach * 256, reach * 128);
// Its rim passes through the window.
constexpr auto grazing_wheel = gear<20>({(160 - reach) * 256, 120 * 256}, reach * 256, reach * 255);

raster::PolygonEdge edges[32];
raster::CoverageCell cells[raster::coverage_cells(20, 320)];

void cover(const Pen& pen, std::span<const SubPoint> polygon) {
  const auto sink = raster::RampCoverage<Format>::over(pen.surface(), 0, opaque(256));
  use(sink.ok() ? raster::fill_coverage(sink.value(), FillRule::even_odd, polygon, cells) : sink.status());
}

constexpr Pair all[] = {
    {"line",
     [](const Pen& pen) {
       use(raster::draw_line(pen, opaque(Point{0, 0}), opaque(Point{319, 239})));
     },
     [](const Pen& pen) {
       use(raster::draw_line(pen, opaque(Point{160 - reach, 120 - reach / 4 * 3}),
                             opaque(Point{160 + reach, 120 + reach / 4 * 3})));
     }},
    {"dashed line",
     [](const Pen& pen) {
       use(raster::draw_dashed_line(pen, opaque(Point{0, 0}), opaque(Point{319, 239}), 4, 4));
     },
     [](const Pen& pen) {
       use(raster::draw_dashed_line(pen, opaque(Point{160 - reach, 120 - reach / 4 * 3}),
                                    opaque(Point{160 + reach, 120 + reach / 4 * 3}), 4, 4));
     }},
    {"thick line",
     [](const Pen& pen) {
       use(raster::draw_thick_line(pen, opaque(Point{5, 5}), opaque(Point{314, 234}), 9));
     },
     [](const Pen& pen) {
       use(raster::draw_thick_line(pen, opaque(Point{160 - reach, 120 - reach / 4 * 3}),
                                   opaque(Point{160 + reach, 120 + reach / 4 * 3}), 9));
     }},
    {"circle", [](const Pen& pen) { use(raster::draw_circle(pen, opaque(middle), opaque(119))); },
     [](const Pen& pen) {
       use(raster::draw_circle(pen, opaque(Point{160 - reach, 120}), opaque(reach)));
     }},
    {"circle from its top",
     [](const Pen& pen) { use(raster::draw_circle(pen, opaque(middle), opaque(119))); },
     [](const Pen& pen) {
       use(raster::draw_circle(pen, opaque(Point{160, 120 + reach}), opaque(reach)));
     }},
    {"disc", [](const Pen& pen) { use(raster::fill_disc(pen, opaque(middle), opaque(119))); },
     [](const Pen& pen) {
       use(raster::fill_disc(pen, opaque(Point{160 - reach, 120}), opaque(reach)));
     }},
    {"even circle",
     [](const Pen& pen) {
       use(raster::draw_circle_in(pen, opaque(Point{41, 1}), opaque(238)));
     },
     [](const Pen& pen) {
       use(raster::draw_circle_in(pen, opaque(Point{160, 120 - reach}), opaque(2 * reach)));
     }},
    {"ring", [](const Pen& pen) { use(raster::fill_ring(pen, opaque(middle), opaque(100), opaque(119))); },
     [](const Pen& pen) {
       use(raster::fill_ring(pen, opaque(Point{160 - reach, 120}), opaque(reach - 19), opaque(reach)));
     }},
    {"ring arc",
     [](const Pen& pen) {
       use(raster::fill_ring_arc(pen, opaque(middle), opaque(100), opaque(119), {}, opaque(40000)));
     },
     [](const Pen& pen) {
       use(raster::fill_ring_arc(pen, opaque(Point{160 - reach, 120}), opaque(reach - 19), opaque(reach), {},
                                 opaque(40000)));
     }},
    {"ellipse",
     [](const Pen& pen) { use(raster::draw_ellipse(pen, opaque(middle), opaque(159), opaque(119))); },
     [](const Pen& pen) {
       use(raster::draw_ellipse(pen, opaque(Point{160 - reach, 120}), opaque(reach), opaque(reach / 4 * 3)));
     }},
    {"filled ellipse",
     [](const Pen& pen) { use(raster::fill_ellipse(pen, opaque(middle), opaque(159), opaque(119))); },
     [](const Pen& pen) {
       use(raster::fill_ellipse(pen, opaque(Point{160, 120 + reach}), opaque(reach / 4 * 3), opaque(reach)));
     }},
    {"round rect",
     [](const Pen& pen) {
       use(raster::fill_round_rect(pen, opaque(Rect{0, 0, 320, 240}), raster::CornerRadii::all(opaque(100))));
     },
     [](const Pen& pen) {
       use(raster::fill_round_rect(pen, opaque(Rect{160 - reach, 120, 2 * reach, 2 * reach}),
                                   raster::CornerRadii::all(opaque(reach))));
     }},
    {"triangle",
     [](const Pen& pen) {
       use(raster::fill_triangle(pen, opaque(Point{0, 0}), opaque(Point{319, 120}), opaque(Point{160, 239})));
     },
     [](const Pen& pen) {
       use(raster::fill_triangle(pen, opaque(Point{-reach, -reach}), opaque(Point{reach, 120}),
                                 opaque(Point{160, reach})));
     }},
    {"polygon",
     [](const Pen& pen) { use(raster::fill_polygon(pen, FillRule::even_odd, filling_wheel, edges)); },
     [](const Pen& pen) { use(raster::fill_polygon(pen, FillRule::even_odd, far_wheel, edges)); }},
    {"polygon's rim",
     [](const Pen& pen) { use(raster::fill_polygon(pen, FillRule::even_odd, filling_wheel, edges)); },
     [](const Pen& pen) { use(raster::fill_polygon(pen, FillRule::even_odd, grazing_wheel, edges)); }},
    {"coverage", [](const Pen& pen) { cover(pen, filling_wheel); },
     [](const Pen& pen) { cover(pen, far_wheel); }},
    {"coverage's rim", [](const Pen& pen) { cover(pen, filling_wheel); },
     [](const Pen& pen) { cover(pen, grazing_wheel); }},
};

}  // namespace

constinit const std::span<const Pair> pairs = all;

}  // namespace boards::mps2
