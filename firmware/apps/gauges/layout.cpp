// SPDX-License-Identifier: MIT
#include <firmware/apps/gauges/layout.hpp>

namespace apps::gauges {
namespace {

using intaglio::linear::Rect;
using intaglio::linear::Size;

constexpr int least(int a, int b) noexcept { return a < b ? a : b; }
constexpr int greatest(int a, int b) noexcept { return a > b ? a : b; }

constexpr int smallest_dial = 13;  // radius
constexpr int small_dial = 22;     // below this, one dial beats two

// The strip of lights: as large as whole dots allow in about a ninth of the height.
void place_lights(Layout& layout, Size size, int margin) noexcept {
  if (size.height < 170 || size.width < 160) return;
  layout.light_scale = greatest(1, least(size.height / 200, size.width / 300));
  const int side = 16 * layout.light_scale;
  layout.lights = {margin, margin, size.width - 2 * margin, side};
}

// Where two dials leave a gap at the top.
void place_arrows(Layout& layout, int middle, int y) noexcept {
  constexpr int width = 20;
  layout.arrows = {middle - width / 2, y, width, 7};
}

// Bars left and right in a strip, the odometer between them where it fits.
void fill_strip(Layout& layout, const Rect& strip) noexcept {
  if (strip.empty()) return;
  const int gap = greatest(2, strip.width / 24);
  const bool counts = strip.height >= 16 && strip.width >= 200;
  const int odometer = counts ? strip.width * 5 / 16 : 0;
  const int bar = (strip.width - odometer - (counts ? 2 : 1) * gap) / 2;
  const int height = least(strip.height, greatest(9, strip.width / 12));
  const int y = strip.y + (strip.height - height) / 2;
  layout.fuel = {strip.x, y, bar, height};
  layout.heat = {strip.right() - bar, y, bar, height};
  if (counts) layout.odometer = {strip.x + bar + gap, strip.y, odometer, strip.height};
}

Layout landscape(Size size) noexcept {
  Layout layout;
  const int margin = greatest(1, least(size.width, size.height) / 40);
  place_lights(layout, size, margin);
  const int top = layout.light_scale > 0 ? layout.lights.bottom() + margin : margin;
  // The strip below gets a fifth of a tall panel, and just a line of a low one.
  const int strip = size.height >= 170 ? size.height / 6 : size.height >= 90 ? 14 : 9;
  const int below = size.height - strip - margin;
  int radius = least((size.width - 3 * margin) / 4, (below - top - margin) / 2);
  const bool wide = size.width > 5 * size.height / 2 && size.height >= 48;
  if (wide) radius = (size.height - 2 * margin - 1) / 2;
  if (radius < smallest_dial && below - top - margin < 2 * smallest_dial) {
    layout.readout = {0, 0, size.width, size.height};
    return layout;
  }
  const int alone = least(size.width - 2 * margin - 1, below - top - margin) / 2;
  if (radius < small_dial && 2 * alone > 3 * radius) {
    layout.speed = {{size.width / 2, top + alone}, alone};
    fill_strip(layout, {margin, below, size.width - 2 * margin, strip});
    return layout;
  }
  const int diameter = 2 * radius + 1;
  if (wide) {
    const int y = size.height / 2;
    layout.lights = {};
    layout.light_scale = 0;
    layout.speed = {{margin + radius, y}, radius};
    layout.rpm = {{size.width - 1 - margin - radius, y}, radius};
    const int left = 2 * margin + diameter + radius / 8;
    layout.readout = {left, size.height / 6, size.width - 2 * left, size.height * 2 / 5};
    fill_strip(layout, {left, size.height * 2 / 3, size.width - 2 * left, size.height / 4});
    place_arrows(layout, size.width / 2, size.height * 3 / 32);
    return layout;
  }
  const int gap = (size.width - 2 * diameter) / 3;
  const int y = top + (below - top) / 2;
  layout.speed = {{gap + radius, y}, radius};
  layout.rpm = {{size.width - 1 - gap - radius, y}, radius};
  const int inset = size.height >= 170 ? 3 * margin : margin;
  fill_strip(layout, {inset, below, size.width - 2 * inset, strip});
  if (layout.light_scale == 0) place_arrows(layout, size.width / 2, margin);
  return layout;
}

Layout portrait(Size size) noexcept {
  Layout layout;
  const int margin = greatest(1, least(size.width, size.height) / 40);
  place_lights(layout, size, margin);
  const int top = layout.light_scale > 0 ? layout.lights.bottom() + margin : margin;
  const int rest = size.height - top;
  const int large = least((size.width - 2 * margin - 1) / 2, rest * 5 / 16);
  if (large < smallest_dial) {
    layout.readout = {0, 0, size.width, size.height};
    return layout;
  }
  layout.speed = {{size.width / 2, top + large}, large};
  const int second = top + 2 * large + 1 + margin;
  const int room = size.height - second - margin;
  int small = least((room - 1) / 2, (size.width - 2 * margin - 1) / 2);
  const bool beside = size.width - 2 * small - 1 - 4 * margin >= 56;
  if (!beside) small = least(small, (room - 13) / 2);
  if (small < smallest_dial) return layout;
  const int side = size.width - 2 * small - 1 - 4 * margin;
  layout.rpm = {{beside ? margin + small : size.width / 2, second + small}, small};
  if (!beside) {
    // Tall and narrow: the bars take what is left under both dials.
    const int free = size.height - (second + 2 * small + 1 + margin);
    if (free >= 9) fill_strip(layout, {margin, size.height - free, size.width - 2 * margin, free - margin});
    return layout;
  }
  const int x = 2 * small + 1 + 3 * margin;
  const int line = room / 3;
  const int height = least(line - 2, greatest(9, side / 6));
  layout.odometer = {x, second, side, line};
  layout.fuel = {x, second + line + (line - height) / 2, side, height};
  layout.heat = {x, second + 2 * line + (line - height) / 2, side, height};
  return layout;
}

}  // namespace

Layout layout_for(Size size) noexcept {
  // Beyond 4096 pixels nothing gets larger, so no product here passes 2^20.
  size = {least(size.width, 4096), least(size.height, 4096)};
  return size.height * 10 > size.width * 11 ? portrait(size) : landscape(size);
}

}  // namespace apps::gauges
