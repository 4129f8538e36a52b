// SPDX-License-Identifier: MIT
//
// Seven-segment digits of any size.
//
// Rule: a digit fills the box width x height; a segment is a bar of one seventh of the height (at least a
// pixel). From 18 rows on, segments end in 45-degree points and stand a gap apart; below, they are plain
// rectangles. Segments that are off are drawn, too, in an ink of their own, or left out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/apps/canvas.hpp>

namespace apps::gauges {

/// Columns of a digit of so many rows.
[[nodiscard]] constexpr int digit_width(int height) noexcept { return (height * 9 + 8) / 16; }
/// Columns from a digit to the next.
[[nodiscard]] constexpr int digit_pitch(int height) noexcept {
  return digit_width(height) + (height / 7 > 1 ? height / 7 : 1);
}
/// Columns that a number of `digits` digits takes.
[[nodiscard]] constexpr int digits_width(int height, int digits) noexcept {
  return digits * digit_pitch(height) - (digit_pitch(height) - digit_width(height));
}

/// An ink that isn't drawn.
inline constexpr int no_ink = -1;

namespace detail {

/// Segments a (top), b, c (right), d (bottom), e, f (left), g (middle), as bits 0..6.
inline constexpr std::array<std::uint8_t, 10> segments_of{0x3F, 0x06, 0x5B, 0x4F, 0x66,
                                                          0x6D, 0x7D, 0x07, 0x7F, 0x6F};

/// A bar along x or y, `half` wide to each side, whose ends are points `gap` inside `from` and `to`; in 1/256
/// px. `from` is the left or upper end.
template <class Canvas>
void pointed_bar(Canvas& canvas, int ink, SubPoint from, SubPoint to, int half, int gap) {
  // Along the bar (1, 0) or (0, 1), and across it.
  const SubPoint along = from.y == to.y ? SubPoint{1, 0} : SubPoint{0, 1};
  const auto corner = [&](SubPoint end, int forward, int aside) {
    return SubPoint{end.x + along.x * forward + along.y * aside, end.y + along.y * forward + along.x * aside};
  };
  canvas.polygon(ink, std::array<SubPoint, 6>{corner(from, gap, 0), corner(from, gap + half, -half),
                                              corner(to, -gap - half, -half), corner(to, -gap, 0),
                                              corner(to, -gap - half, half), corner(from, gap + half, half)});
}

}  // namespace detail

/// Draws one digit, 0..9, in the box at `corner`; anything else draws all segments off.
template <class Canvas>
void draw_digit(Canvas& canvas, int on, int off, Point corner, int height, int value) {
  const int width = digit_width(height);
  if (!canvas.sees({corner.x, corner.y, width, height})) return;
  const unsigned lit = value >= 0 && value <= 9 ? detail::segments_of[static_cast<std::size_t>(value)] : 0U;
  const auto ink_of = [=](unsigned segment) { return (lit >> segment & 1U) != 0 ? on : off; };
  const int bar = height / 7 > 1 ? height / 7 : 1;
  if (height < 18) {
    const int middle = corner.y + (height - bar) / 2;
    const int right = corner.x + width - bar;
    const int low = corner.y + height - bar;
    const std::array<Rect, 7> bars{{{corner.x, corner.y, width, bar},
                                    {right, corner.y, bar, middle - corner.y + bar},
                                    {right, middle, bar, low - middle + bar},
                                    {corner.x, low, width, bar},
                                    {corner.x, middle, bar, low - middle + bar},
                                    {corner.x, corner.y, bar, middle - corner.y + bar},
                                    {corner.x, middle, width, bar}}};
    // Off first: neighbours share their corners.
    for (const bool pass : {false, true})
      for (unsigned s = 0; s < 7; ++s)
        if (((lit >> s & 1U) != 0) == pass && ink_of(s) != no_ink) canvas.fill(ink_of(s), bars[s]);
    return;
  }
  // Along the middle lines of the segments; pixel edges lie at odd multiples of 1/2.
  constexpr int one = intaglio::linear::subpixel_one;
  const int half = bar * one / 2;
  const int left = corner.x * one - one / 2 + half;
  const int right = left + (width - bar) * one;
  const int top = corner.y * one - one / 2 + half;
  const int low = top + (height - bar) * one;
  const int middle = (top + low) / 2;
  const int gap = height >= 40 ? one * 3 / 4 : one / 2;
  const std::array<std::array<SubPoint, 2>, 7> lines{{{{{left, top}, {right, top}}},
                                                      {{{right, top}, {right, middle}}},
                                                      {{{right, middle}, {right, low}}},
                                                      {{{left, low}, {right, low}}},
                                                      {{{left, middle}, {left, low}}},
                                                      {{{left, top}, {left, middle}}},
                                                      {{{left, middle}, {right, middle}}}}};
  for (unsigned s = 0; s < 7; ++s)
    if (ink_of(s) != no_ink) detail::pointed_bar(canvas, ink_of(s), lines[s][0], lines[s][1], half, gap);
}

/// Draws a number, right-aligned in `digits` places; leading zeros are off. `corner` is the top left.
template <class Canvas>
void draw_number(Canvas& canvas, int on, int off, Point corner, int height, int digits, int value) {
  const int pitch = digit_pitch(height);
  for (int place = digits - 1; place >= 0; --place) {
    const bool blank = value == 0 && place != digits - 1;
    draw_digit(canvas, on, off, {corner.x + place * pitch, corner.y}, height, blank ? -1 : value % 10);
    value /= 10;
  }
}

}  // namespace apps::gauges
