// SPDX-License-Identifier: MIT
//
// Counted: circles, ellipses and what is cut from them.
#include <intaglio/raster/arc.hpp>
#include <intaglio/raster/chord.hpp>
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/ellipse.hpp>
#include <intaglio/raster/ring.hpp>
#include <intaglio/raster/round_rect.hpp>

#include <firmware/boards/mps2/count/rig.hpp>

namespace boards::mps2 {

namespace {

constexpr Point middle{160, 120};
constexpr number::Angle start = number::Angle::from_degrees(30);
constexpr int sweep = number::Angle::turn / 3;

constexpr Row rows[] = {
    {"circle r=50", [](const Pen& pen) { use(raster::draw_circle(pen, opaque(middle), opaque(50))); }},
    {"disc r=50", [](const Pen& pen) { use(raster::fill_disc(pen, opaque(middle), opaque(50))); }},
    {"circle d=100",
     [](const Pen& pen) {
       use(raster::draw_circle_in(pen, opaque(Point{110, 70}), opaque(100)));
     }},
    {"disc d=100",
     [](const Pen& pen) {
       use(raster::fill_disc_in(pen, opaque(Point{110, 70}), opaque(100)));
     }},
    {"ellipse 80x40",
     [](const Pen& pen) { use(raster::draw_ellipse(pen, opaque(middle), opaque(40), opaque(20))); }},
    {"ellipse 80x40 filled",
     [](const Pen& pen) { use(raster::fill_ellipse(pen, opaque(middle), opaque(40), opaque(20))); }},
    {"ellipse 160x80 filled",
     [](const Pen& pen) { use(raster::fill_ellipse(pen, opaque(middle), opaque(80), opaque(40))); }},
    {"ring r=40..50",
     [](const Pen& pen) { use(raster::fill_ring(pen, opaque(middle), opaque(40), opaque(50))); }},
    {"arc r=50, a third",
     [](const Pen& pen) { use(raster::draw_arc(pen, opaque(middle), opaque(50), start, opaque(sweep))); }},
    {"pie r=50, a third",
     [](const Pen& pen) { use(raster::fill_pie(pen, opaque(middle), opaque(50), start, opaque(sweep))); }},
    {"chord r=50, a third",
     [](const Pen& pen) { use(raster::fill_chord(pen, opaque(middle), opaque(50), start, opaque(sweep))); }},
    {"round rect 100x60",
     [](const Pen& pen) {
       use(raster::draw_round_rect(pen, opaque(Rect{101, 77, 100, 60}),
                                   raster::CornerRadii::all(opaque(10))));
     }},
    {"round rect 100x60 filled",
     [](const Pen& pen) {
       use(raster::fill_round_rect(pen, opaque(Rect{101, 77, 100, 60}),
                                   raster::CornerRadii::all(opaque(10))));
     }},
};

}  // namespace

constinit const std::span<const Row> curve_rows = rows;

}  // namespace boards::mps2
