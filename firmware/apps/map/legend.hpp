// SPDX-License-Identifier: MIT
//
// What stands over the map: where one looks, and how far a thumb's width reaches.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/apps/canvas.hpp>
#include <firmware/apps/fonts.hpp>
#include <firmware/apps/map/inks.hpp>
#include <firmware/apps/map/tour.hpp>
#include <string_view>

namespace apps::map {

/// A short text, put together without the heap; what is too long for it is cut.
class Line {
 public:
  [[nodiscard]] std::string_view text() const noexcept { return {text_.data(), length_}; }
  Line& operator<<(std::string_view part) noexcept;
  /// At least `digits` digits, 0 <= value.
  Line& number(int value, int digits = 1) noexcept;

 private:
  std::array<char, 40> text_{};
  std::size_t length_ = 0;
};

/// The camera's place in degrees and minutes: 41°54'N 12°30'E.
[[nodiscard]] Line place_text(const Camera& camera) noexcept;

/// Degrees between lines of the graticule: the least of 1, 2, 5, 10, 15, 30 that leaves 24 pixels between.
[[nodiscard]] int graticule_step(const Camera& camera) noexcept;

/// A length on the map.
struct ScaleBar {
  int kilometres = 0;
  int pixels = 0;  ///< 0: no round length fits
};
/// The greatest round length of at most so many pixels.
[[nodiscard]] ScaleBar scale_bar(const Camera& camera, int most_pixels) noexcept;

/// Draws place, scale and cross-hairs where the panel has room for them.
template <class Canvas>
void draw_legend(Canvas& canvas, Size size, const Camera& camera) {
  if (size.height < 40 || size.width < 60) return;
  if (!canvas.theme().two_tone()) {
    const Point middle{(size.width - 1) / 2, (size.height - 1) / 2};
    const int arm = size.height >= 200 ? 5 : 3;
    canvas.fill(ink::aim, {middle.x - 2 - arm, middle.y, arm, 1});
    canvas.fill(ink::aim, {middle.x + 3, middle.y, arm, 1});
    canvas.fill(ink::aim, {middle.x, middle.y - 2 - arm, 1, arm});
    canvas.fill(ink::aim, {middle.x, middle.y + 3, 1, arm});
  }
  const bool large = size.width >= 240 && size.height >= 160;
  const intaglio::text::Font& font = large ? text_font() : small_font();
  const int pad = large ? 4 : 1;
  const Line place = place_text(camera);
  const Size box = intaglio::text::measure(font, place.text());
  const int height = box.height + (large ? 4 : 1);
  const int inset = large ? 4 : 0;
  const int y = size.height - inset - height;
  canvas.fill(ink::panel, {inset, y, box.width + 2 * pad, height});
  canvas.text(ink::text, font, {inset + pad, y + (large ? 2 : 1)}, place.text());

  const int room = size.width - 2 * inset - box.width - 2 * pad - 4;
  const ScaleBar bar = scale_bar(camera, room < size.width / 4 ? room : size.width / 4);
  if (bar.pixels < 8) return;
  Line length;
  length.number(bar.kilometres) << std::string_view(" km", 3);
  const int wide = intaglio::text::measure(font, length.text()).width;
  const int width = (wide > bar.pixels ? wide : bar.pixels) + 2 * pad + 2;
  if (width > room) return;
  const int tall = height + 4;
  const int left = size.width - inset - width;
  const int top = size.height - inset - tall;
  canvas.fill(ink::panel, {left, top, width, tall});
  canvas.text(ink::text, font, {left + (width - wide + 1) / 2, top + (large ? 2 : 1)}, length.text());
  const int bar_x = left + (width - bar.pixels) / 2;
  canvas.fill(ink::text, {bar_x, top + tall - 2, bar.pixels, 1});
  canvas.fill(ink::text, {bar_x, top + tall - 4, 1, 2});
  canvas.fill(ink::text, {bar_x + bar.pixels - 1, top + tall - 4, 1, 2});
}

}  // namespace apps::map
