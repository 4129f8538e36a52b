// SPDX-License-Identifier: MIT
//
// Fields with points, rectangles, lines and strokes.
#pragma once

#include <intaglio/clip/line_window.hpp>
#include <intaglio/raster/dash.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/line_rungs.hpp>
#include <intaglio/raster/pixel.hpp>
#include <intaglio/raster/polyline.hpp>
#include <intaglio/raster/rectangle.hpp>
#include <intaglio/raster/thick_line.hpp>
#include <intaglio/raster/thick_line_rungs.hpp>

#include <firmware/apps/primitives/field.hpp>

namespace apps::primitives {

template <image::PixelFormat F>
void draw_points(const Field<F>& field) {
  for (int i = 0; i < 24; ++i) {
    const SubPoint p = field.place(20 + 5 * i, i * 75);
    field.keep(draw_pixel(field.pen(static_cast<unsigned>(i & 15)), {p.x / 256, p.y / 256}));
  }
  field.keep(draw_horizontal(field.pen(9), {field.area.x - 5, field.middle().y}, field.unit() + 5));
  field.keep(draw_vertical(field.pen(9), {field.middle().x, field.middle().y}, 1000));
}

template <image::PixelFormat F>
void draw_rectangles(const Field<F>& field) {
  const SubPoint corner = field.place(70, 0);
  const Rect box{corner.x / 256, corner.y / 256, field.unit(), field.unit() * 3 / 4};
  field.keep(fill_rect(field.pen(5), box));
  field.keep(draw_rect(field.pen(15), box));
  field.keep(fill_rect(raster::Xor<F>(field.target, F::max_index, field.area),
                       {field.middle().x, field.area.y - 9, field.unit(), 300}));
}

/// Lines whose ends lie near the domain's edge.
template <image::PixelFormat F>
void draw_long_lines(const Field<F>& field) {
  for (int i = 0; i < 12; ++i) {
    const SubPoint end = around({}, 65'000, field.turn + Angle::from_degrees(30 * i));
    field.keep(draw_line(field.pen(static_cast<unsigned>(i)), field.middle(), Point{end.x * 16, end.y * 16}));
  }
}

template <image::PixelFormat F>
void draw_sub_pixel_lines(const Field<F>& field) {
  for (int i = 0; i < 9; ++i)
    field.keep(draw_line(field.pen(static_cast<unsigned>(15 - i)), field.place(15, 40 * i),
                         field.place(60 + 10 * i, 40 * i + 3)));
}

/// The book's other lines.
template <image::PixelFormat F>
void draw_line_rungs(const Field<F>& field) {
  for (int i = 0; i < 9; ++i) {
    const SubPoint end = around({}, 50'000, field.turn + Angle::from_degrees(40 * i));
    const auto pen = field.pen(static_cast<unsigned>(5 + i));
    const Point far{field.middle().x + end.x / 4, field.middle().y + end.y / 4};
    field.keep(i % 3 == 0   ? raster::draw_line_by<raster::RoundedLine>(pen, field.middle(), far)
               : i % 3 == 1 ? raster::draw_line_by<raster::SplitErrorLine>(pen, field.middle(), far)
                            : raster::draw_line_by<raster::DistanceLine>(pen, field.middle(), far));
  }
}

template <image::PixelFormat F>
void draw_dashes(const Field<F>& field) {
  for (int i = 0; i < 6; ++i) {
    const SubPoint end = around({}, 60'000, field.turn + Angle::from_degrees(60 * i));
    field.keep(draw_dashed_line(field.pen(static_cast<unsigned>(4 + 2 * i)), field.middle(),
                                {field.middle().x + end.x, field.middle().y + end.y}, 1 + i, 1 + i / 2));
  }
}

template <image::PixelFormat F>
void draw_thick_lines(const Field<F>& field) {
  const int width = field.unit() * linear::subpixel_one / 3;
  constexpr raster::Cap caps[] = {raster::Cap::butt, raster::Cap::square, raster::Cap::round};
  for (int i = 0; i < 3; ++i)
    field.keep(draw_thick_line(field.pen(static_cast<unsigned>(6 + 4 * i)), field.place(75, 120 * i),
                               field.place(20, 120 * i + 30), width, caps[i]));
  field.keep(draw_thick_line(field.pen(2), field.middle(), Point{field.middle().x + 900'000, -700'000}, 2));
  field.keep(
      draw_minor_thick_line(field.pen(14), field.place(95, 60), field.place(80, 190), field.unit() / 4));
}

template <image::PixelFormat F>
void draw_polylines(const Field<F>& field) {
  std::array<raster::StrokeEdge, 40> workspace;
  constexpr raster::Join joins[] = {raster::Join::miter, raster::Join::bevel, raster::Join::round};
  for (int i = 0; i < 3; ++i) {
    raster::Stroke stroke;
    stroke.width = field.unit() * linear::subpixel_one / 4;
    stroke.join = joins[i];
    stroke.cap = i == 1 ? raster::Cap::square : raster::Cap::round;
    stroke.closed = i == 0;
    const std::array<SubPoint, 3> points{field.place(95, 120 * i), field.place(30, 120 * i + 70),
                                         field.place(90, 120 * i + 100)};
    field.keep(draw_polyline(field.pen(static_cast<unsigned>(5 + 5 * i)), points, stroke, workspace));
  }
}

/// The part of a line in a window, by three clippers, each a third of the answer.
template <image::PixelFormat F>
void draw_clipped_lines(const Field<F>& field) {
  constexpr int one = linear::subpixel_one;
  const int side = field.unit();
  const linear::SubRect window{(field.middle().x - side / 2) * one, (field.middle().y - side / 2) * one,
                               side * one, side * one};
  for (int i = 0; i < 9; ++i) {
    const SubPoint a = field.place(100, 40 * i);
    const SubPoint b = field.place(90, 40 * i + 170);
    const auto part = i % 3 == 0   ? intaglio::clip::cohen_sutherland(a, b, window)
                      : i % 3 == 1 ? intaglio::clip::skala(a, b, window)
                                   : intaglio::clip::liang_barsky(a, b, window);
    field.keep(part.status());
    if (part.ok() && part.value().visible)
      field.keep(draw_line(field.pen(static_cast<unsigned>(i + 3)), nearest(part.value().from),
                           nearest(part.value().to)));
  }
}

}  // namespace apps::primitives
