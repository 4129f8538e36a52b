// SPDX-License-Identifier: MIT
//
// What isn't a dial: level bars with a symbol, the odometer's drums, and the readout of panels without dials.
//
// Rule: each is laid out inside the rectangle it is given and draws nothing outside it; what doesn't fit is
// left out, first the trimmings, then the thing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <firmware/apps/canvas.hpp>
#include <firmware/apps/fonts.hpp>
#include <firmware/apps/gauges/dial.hpp>
#include <firmware/apps/gauges/digits.hpp>
#include <firmware/apps/gauges/drive.hpp>
#include <firmware/apps/gauges/inks.hpp>
#include <firmware/apps/gauges/symbols.hpp>
#include <span>

namespace apps::gauges {

/// How a level is shown.
struct Level {
  std::span<const std::uint16_t> symbol;        ///< 16 by 16 dots
  std::span<const std::uint16_t> small_symbol;  ///< 7 by 7 dots
  int low = 0;                                  ///< Below this, everything is red.
  int high = 1000;                              ///< From here on, segments are red.
};

inline constexpr Level fuel_level{symbols::fuel, symbols::small_fuel, 125, 1001};
inline constexpr Level heat_level{symbols::heat, symbols::small_heat, 0, 800};

/// A symbol and a row of segments; `value` is 0 .. 1000.
template <class Canvas>
void draw_level(Canvas& canvas, const Rect& area, const Level& level, int value) {
  if (area.empty() || !canvas.sees(area)) return;
  const bool large = area.height >= 16;
  const int scale = large ? area.height / 16 : 1;
  const int dots = (large ? 16 : symbols::small_columns) * scale;
  const int middle = area.y + area.height / 2;
  int x = area.x;
  const bool alarm = value < level.low || value >= level.high;
  if (area.height >= 7 && area.width >= 3 * dots) {
    canvas.bitmap(alarm ? ink::red : ink::dim, {x, middle - dots / 2},
                  large ? level.symbol : level.small_symbol, large ? 16 : symbols::small_columns, scale);
    x += dots + dots / 4 + 1;
  }
  const int width = area.right() - x;
  const int count = width / 7 < 4 ? 4 : width / 7 > 16 ? 16 : width / 7;
  const int pitch = width / count;
  if (pitch < 2) return;
  const int gap = pitch / 5 > 1 ? pitch / 5 : 1;
  const int height = large ? area.height * 5 / 8 : area.height * 5 / 9 > 0 ? area.height * 5 / 9 : 1;
  for (int i = 0; i < count; ++i) {
    const bool lit = value * count >= i * 1000 + 500 || (i == 0 && value > 0);
    const bool red = alarm || i * 1000 >= level.high * count;
    const Rect segment{x + i * pitch, middle - height / 2, pitch - gap, height};
    canvas.fill(lit ? (red ? ink::red : ink::text) : (red ? ink::red_dark : ink::ghost), segment);
    // With on and off alone, the foot of each segment shows how far the scale goes.
    if (!lit && canvas.theme().two_tone())
      canvas.fill(ink::text, {segment.x, segment.bottom() - 1, segment.width, 1});
  }
}

/// Six drums of kilometres and one of tenths that turns.
template <class Canvas>
void draw_odometer(Canvas& canvas, const Rect& area, int metres) {
  constexpr int drums = 7;
  constexpr std::string_view unit = "km";
  if (area.empty() || !canvas.sees(area)) return;
  const intaglio::text::Font& font = counter_font(area.height);
  const Size digit = intaglio::text::measure(font, "0");
  const int pitch = digit.width + 4;
  const int height = digit.height + (area.height >= 56 ? 4 : 2);
  const intaglio::text::Font& unit_font = area.height >= 56 ? text_font() : small_font();
  const int note = intaglio::text::measure(unit_font, unit).width + 4;
  const int room = area.width >= drums * pitch + note ? note : 0;
  if (area.width < drums * pitch || area.height < height) return;
  int x = area.x + (area.width - drums * pitch - room) / 2;
  const int y = area.y + (area.height - height) / 2;
  int power = 100'000'000;  // metres in a step of the first drum
  canvas.frame(ink::steel_dark, {x - 2, y - 2, drums * pitch + 3, height + 4});
  for (int drum = 0; drum < drums; ++drum, power /= 10, x += pitch) {
    const bool tenths = drum == drums - 1;
    const Rect box{x, y, pitch - 1, height};
    canvas.fill(tenths ? ink::text : ink::shadow, box);
    const int value = metres / power % 10;
    // The tenths turn all the time, each other drum while all drums right of it go from 9 to 0.
    const int within = metres % power;
    const int turning = tenths ? within : within - (power - 100);
    const int roll = turning > 0 ? turning * height / 100 : 0;
    const int top = y + (height - digit.height) / 2 - roll;
    const int digit_ink = tenths ? ink::background : ink::text;
    const int left = x + (pitch - 1 - digit.width) / 2 + (digit.width == 6 ? 1 : 0);
    canvas.text_within(digit_ink, box, font, {left, top}, Number(value).text());
    if (roll > 0)
      canvas.text_within(digit_ink, box, font, {left, top + height}, Number((value + 1) % 10).text());
  }
  if (room > 0) canvas.label(ink::dim, unit_font, {x + 4, y + height / 2 + 1}, Align::left, unit);
}

/// Speed in digits beside the engine's speed as a rising row of bars, the tank below it.
template <class Canvas>
void draw_readout(Canvas& canvas, const Rect& area, const Readings& now) {
  constexpr int digits = 3;
  const int pad = area.height / 12 > 1 ? area.height / 12 : 1;
  int height = area.height - 2 * pad;
  while (height > 4 && digits_width(height, digits) * 5 > area.width * 2) --height;
  int x = area.x + pad;
  if (height >= 7) {
    draw_number(canvas, ink::text, ink::ghost, {x, area.y + (area.height - height) / 2}, height, digits,
                (now.speed + 8) >> value_bits);
    x += digits_width(height, digits) + 2 * pad + 1;
    const Size unit = intaglio::text::measure(small_font(), speed_scale.label);
    if (area.width >= 90 && area.width - (x - area.x) >= 2 * unit.width) {
      canvas.text(ink::dim, small_font(), {x, area.y + (area.height + height) / 2 - unit.height + 1},
                  speed_scale.label);
      if (now.gear > 0 && area.height >= 2 * unit.height)
        canvas.text(ink::amber, small_font(), {x, area.y + (area.height - height) / 2},
                    Number(now.gear).text());
      x += unit.width + 2 * pad;
    }
  }
  const int width = area.right() - pad - x;
  const int tank = area.height >= 14 ? (area.height / 10 > 2 ? area.height / 10 : 2) : 0;
  const int rise = area.height - 2 * pad - (tank > 0 ? tank + pad : 0);
  if (width < 4 || rise < 1) return;
  const int pitch = area.height / 10 > 3 ? area.height / 10 : 3;
  const int count = width / pitch > 0 ? width / pitch : 1;
  const int low = area.y + pad + rise;
  for (int i = 0; i < count; ++i) {
    const bool lit =
        static_cast<std::int64_t>(now.rpm) * count > static_cast<std::int64_t>(i) * (rpm_limit << value_bits);
    const bool red = i * rpm_limit >= rpm_red * count;
    const int full = rise * 2 / 5 + rise * 3 / 5 * (i + 1) / count;
    const int bar = lit || rise < 4 ? (full > 0 ? full : 1) : 1;
    if (!lit && full > bar)
      canvas.fill(red ? ink::red_dark : ink::ghost, {x + i * pitch, low - full, pitch - 1, full});
    canvas.fill(lit ? (red ? ink::red : ink::cyan) : ink::steel_light,
                {x + i * pitch, low - bar, pitch - 1, bar});
  }
  if (tank > 0) {
    const int span = count * pitch - 1;
    const int y = area.bottom() - pad - tank;
    canvas.fill(ink::ghost, {x, y, span, tank});
    canvas.fill(now.fuel < fuel_level.low ? ink::red : ink::amber, {x, y, span * now.fuel / 1000, tank});
  }
}

}  // namespace apps::gauges
