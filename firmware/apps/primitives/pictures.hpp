// SPDX-License-Identifier: MIT
//
// Fields with pictures: copied, scaled, turned.
#pragma once

#include <intaglio/image/blit.hpp>
#include <intaglio/image/rotozoom.hpp>
#include <intaglio/image/scale.hpp>
#include <intaglio/image/three_shear.hpp>
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/line.hpp>

#include <firmware/apps/primitives/field.hpp>

namespace apps::primitives {

/// A small picture, drawn by the library itself: a circle with a stroke, index 0 around it.
template <image::PixelFormat F>
class Sprite {
 public:
  static constexpr int side = 11;

  Sprite() {
    const auto own = image::Surface<F>::over(memory_, {side, side});
    if (!own.ok()) return;
    draw_circle(raster::Solid<F>(own.value(), F::max_index), {5, 5}, 5).ignore();
    draw_line(raster::Solid<F>(own.value(), 1U), Point{5, 5}, Point{9, 3}).ignore();
  }
  [[nodiscard]] image::Picture<F> picture() const {
    return image::Picture<F>::over(memory_, {side, side}).value();
  }

 private:
  std::array<std::uint8_t, static_cast<std::size_t>(F::row_bytes(side)) * side> memory_{};
};

template <image::PixelFormat F>
void draw_sprites(const Field<F>& field) {
  const Sprite<F> sprite;
  for (int i = 0; i < 3; ++i) {
    const SubPoint p = field.place(80, 120 * i);
    const Point corner{p.x / 256 - Sprite<F>::side / 2, p.y / 256 - Sprite<F>::side / 2};
    field.keep(i == 0 ? blit(field.target, corner, sprite.picture(), image::Everything{}, field.area)
                      : blit(field.target, corner, sprite.picture(), image::ColourKey{0}, field.area));
  }
}

template <image::PixelFormat F>
void draw_scaled(const Field<F>& field) {
  const Sprite<F> sprite;
  const SubPoint p = field.place(100, 0);
  const Rect destination{field.area.x, field.area.y, p.x / 256 - field.area.x + 2, field.area.height * 3 / 2};
  field.keep(blit_scaled(field.target, destination, sprite.picture(), image::ColourKey{0}, field.area));
}

template <image::PixelFormat F>
void draw_turned(const Field<F>& field) {
  const Sprite<F> sprite;
  const Point m = field.middle();
  const image::Rotozoom placement{
      .position = {m.x * 256, m.y * 256},
      .pivot = {128 * (Sprite<F>::side - 1), 128 * (Sprite<F>::side - 1)},
      .angle = field.turn,
      .scale = number::Fixed<16>::from_raw(field.unit() * 65536 / (Sprite<F>::side / 2))};
  field.keep(blit_rotozoom(field.target, placement, sprite.picture(), image::ColourKey{0}, field.area));
}

/// Turned without losing a pixel, and once more through the picture as a mask.
template <image::PixelFormat F>
void draw_sheared(const Field<F>& field) {
  const Sprite<F> sprite;
  const Point m = field.middle();
  constexpr int middle = 128 * (Sprite<F>::side - 1);
  const image::ThreeShear placement{
      .position = {m.x * 256, m.y * 256}, .pivot = {middle, middle}, .angle = field.turn};
  field.keep(blit_three_shear(field.target, placement, sprite.picture(), image::ColourKey{0}, field.area));
  const SubPoint p = field.place(90, 0);
  field.keep(blit(field.target, {p.x / 256 - 5, p.y / 256 - 5}, sprite.picture(),
                  image::Masked<F>{sprite.picture()}, field.area));
}

}  // namespace apps::primitives
