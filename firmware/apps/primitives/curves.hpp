// SPDX-License-Identifier: MIT
//
// Fields with circles, ellipses and what is cut from them.
#pragma once

#include <intaglio/raster/arc.hpp>
#include <intaglio/raster/chord.hpp>
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/ellipse.hpp>
#include <intaglio/raster/ellipse_arc.hpp>
#include <intaglio/raster/ring.hpp>
#include <intaglio/raster/round_rect.hpp>

#include <firmware/apps/primitives/field.hpp>

namespace apps::primitives {

/// A number that goes up and down with the turn: low .. high.
[[nodiscard]] inline int swing(Angle turn, int low, int high) {
  const int steps = turn.steps();
  const int half = Angle::turn / 2;
  return low + (high - low) * (steps < half ? steps : Angle::turn - steps) / half;
}

template <image::PixelFormat F>
void draw_circles(const Field<F>& field) {
  const int r = swing(field.turn, 0, field.unit());
  for (int i = r; i > 0; i -= 3) field.keep(draw_circle(field.pen(12), field.middle(), i));
  // One far larger than the field.
  field.keep(
      draw_circle(field.pen(4), {field.middle().x, field.middle().y + 500'000}, 500'000 + field.unit() / 2));
}

template <image::PixelFormat F>
void draw_discs(const Field<F>& field) {
  const raster::Xor<F> ink(field.target, F::max_index, field.area);
  const SubPoint p = field.place(50, 0);
  field.keep(fill_disc(field.pen(7), {p.x / 256, p.y / 256}, field.unit() / 2));
  field.keep(fill_disc(ink, field.middle(), swing(field.turn, 0, field.unit())));
  field.keep(fill_disc(ink, {field.middle().x - 300'000, field.middle().y}, 300'000));
}

template <image::PixelFormat F>
void draw_rings(const Field<F>& field) {
  const int r = field.unit();
  field.keep(fill_ring(field.pen(11), field.middle(), swing(field.turn, 0, r * 3 / 4), r - 1));
  field.keep(fill_ring(field.pen(5), {field.middle().x + 90'000, field.middle().y}, 90'000, 90'000 + r / 4));
}

template <image::PixelFormat F>
void draw_arcs(const Field<F>& field) {
  for (int i = 0; i < 4; ++i)
    field.keep(draw_arc(field.pen(static_cast<unsigned>(3 + 4 * i)), field.middle(), field.unit() - i,
                        field.turn * (i % 2 == 0 ? 1 : -1) + number::quarter_turn * i,
                        (i + 1) * (i % 2 == 0 ? 9'000 : -9'000)));
}

template <image::PixelFormat F>
void draw_pies(const Field<F>& field) {
  // Four that share the disc out, none of them taking a pixel of another.
  const int sweeps[] = {5'000, 30'000, 20'000, Angle::turn - 55'000};
  int start = field.turn.steps();
  for (int i = 0; i < 4; ++i) {
    field.keep(fill_pie(field.pen(static_cast<unsigned>(2 + 4 * i)), field.middle(), field.unit() - 1,
                        Angle::from_steps(start), sweeps[i]));
    start += sweeps[i];
  }
}

template <image::PixelFormat F>
void draw_chords(const Field<F>& field) {
  field.keep(fill_chord(field.pen(6), field.middle(), field.unit() - 1, field.turn, 25'000));
  field.keep(fill_chord(field.pen(13), field.middle(), field.unit() - 1, field.turn, 25'000 - Angle::turn));
}

template <image::PixelFormat F>
void draw_ellipses(const Field<F>& field) {
  const int a = field.area.width / 2 + 1;
  const int b = field.area.height / 2 + 1;
  field.keep(fill_ellipse(field.pen(4), field.middle(), swing(field.turn, 0, a), b - 1));
  field.keep(draw_ellipse(field.pen(14), field.middle(), a - 1, swing(field.turn, 0, b)));
  field.keep(draw_ellipse(field.pen(9), {field.middle().x, field.middle().y + 400'000}, 1'000, 400'000));
}

template <image::PixelFormat F>
void draw_circles_by_diameter(const Field<F>& field) {
  const int d = swing(field.turn, 0, 2 * field.unit());
  field.keep(fill_disc_in(field.pen(8), {field.area.x, field.area.y}, d));
  field.keep(draw_circle_in(field.pen(15), {field.area.x + 1, field.area.y + 1}, 2 * field.unit() - d));
  field.keep(draw_circle_in(field.pen(3), {field.middle().x, field.middle().y - 700'000}, 1'400'001));
}

template <image::PixelFormat F>
void draw_round_rectangles(const Field<F>& field) {
  const int r = swing(field.turn, 0, field.unit());
  field.keep(fill_round_rect(field.pen(6), field.area, {r, 2, r / 2, r / 3}));
  field.keep(draw_round_rect(field.pen(15),
                             {field.area.x + 1, field.area.y + 1, field.area.width - 2, field.area.height},
                             raster::CornerRadii::all(r)));
}

template <image::PixelFormat F>
void draw_parts_of_ellipses(const Field<F>& field) {
  const int a = field.area.width / 2;
  const int b = field.area.height / 3;
  field.keep(fill_ellipse_pie(field.pen(5), field.middle(), a, b, field.turn, 17'000));
  field.keep(fill_ellipse_chord(field.pen(10), field.middle(), a, b, field.turn, -12'000));
  field.keep(draw_ellipse_arc(field.pen(15), field.middle(), b, a, -field.turn, 40'000));
}

}  // namespace apps::primitives
