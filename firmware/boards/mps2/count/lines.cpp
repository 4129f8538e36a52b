// SPDX-License-Identifier: MIT
//
// Counted: lines and strokes, by their rungs, and the three geometric line clippers.
#include <intaglio/clip/line_window.hpp>
#include <intaglio/raster/dash.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/line_rungs.hpp>
#include <intaglio/raster/polyline.hpp>
#include <intaglio/raster/thick_line.hpp>
#include <intaglio/raster/thick_line_rungs.hpp>

#include <firmware/boards/mps2/count/rig.hpp>

namespace boards::mps2 {

namespace {

namespace clip = intaglio::clip;

// A line that both sides of the window cut, for the clippers.
template <auto clipper>
void clip_line(const Pen&) {
  const linear::SubRect window{opaque(0), opaque(0), opaque(320 * 256), opaque(240 * 256)};
  const auto line = clipper(opaque(SubPoint{-25600, 12800}), opaque(SubPoint{102400, 51300}), window);
  use(line.ok() && line.value().visible ? 1U : 0U);
  asm volatile("" : : "r"(&line) : "memory");
}

template <class Rung>
void draw_by(const Pen& pen) {
  use(raster::draw_line_by<Rung>(pen, opaque(Point{0, 0}), opaque(Point{319, 100})));
}

// A zigzag of ten points.
constexpr auto zigzag = [] {
  std::array<SubPoint, 10> points{};
  for (int i = 0; i < 10; ++i)
    points[static_cast<std::size_t>(i)] = {(10 + 33 * i) * 256, (i % 2 == 0 ? 60 : 190) * 256};
  return points;
}();
raster::StrokeEdge strokes[128];

template <raster::Join join>
void draw_zigzag(const Pen& pen) {
  raster::Stroke stroke;
  stroke.width = opaque(5 * 256);
  stroke.join = join;
  use(raster::draw_polyline(pen, zigzag, stroke, strokes));
}

constexpr Row rows[] = {
    {"line (0,0)-(319,100)",
     [](const Pen& pen) {
       use(raster::draw_line(pen, opaque(Point{0, 0}), opaque(Point{319, 100})));
     }},
    {"line (10,10)-(60,200)",
     [](const Pen& pen) {
       use(raster::draw_line(pen, opaque(Point{10, 10}), opaque(Point{60, 200})));
     }},
    {"line clipped",
     [](const Pen& pen) {
       use(raster::draw_line(pen, opaque(Point{-30000, -20000}), opaque(Point{30500, 20300})));
     }},
    {"line in 1/256 pixel",
     [](const Pen& pen) {
       use(raster::draw_line(pen, opaque(SubPoint{70, 30}), opaque(SubPoint{81690, 25670})));
     }},
    {"dashed line, 4 on, 4 off",
     [](const Pen& pen) {
       use(raster::draw_dashed_line(pen, opaque(Point{0, 0}), opaque(Point{319, 100}), opaque(4), opaque(4)));
     }},
    {"thick line, 5 wide",
     [](const Pen& pen) {
       use(raster::draw_thick_line(pen, opaque(Point{10, 10}), opaque(Point{60, 200}), opaque(5)));
     }},
    {"thick line, 5 wide, round caps",
     [](const Pen& pen) {
       use(raster::draw_thick_line(pen, opaque(Point{10, 10}), opaque(Point{60, 200}), opaque(5),
                                   raster::Cap::round));
     }},
    {"thick line, 5 on the minor axis",
     [](const Pen& pen) {
       use(raster::draw_minor_thick_line(pen, opaque(Point{10, 10}), opaque(Point{60, 200}), opaque(5)));
     }},
    {"polyline of 10, 5 wide, miter", draw_zigzag<raster::Join::miter>},
    {"polyline of 10, 5 wide, bevel", draw_zigzag<raster::Join::bevel>},
    {"polyline of 10, 5 wide, round", draw_zigzag<raster::Join::round>},
    {"line (0,0)-(319,100) by line1", draw_by<raster::RoundedLine>},
    {"line (0,0)-(319,100) by line2", draw_by<raster::SplitErrorLine>},
    {"line (0,0)-(319,100) by distance", draw_by<raster::DistanceLine>},
    {"clip by Cohen-Sutherland", clip_line<clip::cohen_sutherland>},
    {"clip by Skala", clip_line<clip::skala>},
    {"clip by Liang-Barsky", clip_line<clip::liang_barsky>},
};

}  // namespace

constinit const std::span<const Row> line_rows = rows;

}  // namespace boards::mps2
