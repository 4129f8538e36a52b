// SPDX-License-Identifier: MIT
//
// A dial: bezel, face, glowing arc, ticks, numbers and needle.
//
// Rule: the scale runs clockwise over 270 degrees, from the lower left to the lower right. Everything is
// placed by sine and cosine in 1/256 px around the middle of the centre pixel, in shares of the radius, and
// drops out by itself where the radius leaves no room for it. The arc is made of segments that each have an
// ink: which of them glow is told by the palette, not drawn.
//
// Bit budget: radii at most 2^11 px, so 2^19 sub-pixels, times a sine of 2^15 in 64 bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/apps/canvas.hpp>
#include <firmware/apps/fonts.hpp>
#include <firmware/apps/gauges/digits.hpp>
#include <firmware/apps/gauges/drive.hpp>
#include <firmware/apps/gauges/inks.hpp>
#include <firmware/apps/gauges/knobs.hpp>
#include <firmware/apps/gauges/layout.hpp>
#include <firmware/apps/gauges/smooth.hpp>
#include <string_view>

namespace apps::gauges {

/// What stands on a dial. Values are in the units of the scale.
struct Scale {
  int limit = 0;        ///< The value at the end.
  int major = 0;        ///< From a long tick to the next.
  int minor = 0;        ///< From a short tick to the next; divides `major`.
  int red = 0;          ///< Where the red zone begins.
  int number_unit = 1;  ///< A value is written divided by this.
  int arc = 0;          ///< First ink of the arc.
  std::string_view label{};
  std::string_view short_label{};  ///< Where the label is too wide.
};

inline constexpr Scale speed_scale{speed_limit, 20, 10, speed_red, 1, ink::arcs, "km/h", "km/h"};
inline constexpr Scale rpm_scale{rpm_limit,   1000,   250, rpm_red, 1000, ink::arcs + ink::arc_segments,
                                 "rpm x1000", "x1000"};

/// Where a value stands on a scale, clockwise from straight up. 0 <= value <= limit < 2^15.
[[nodiscard]] constexpr Angle angle_of(int value, int limit) noexcept {
  constexpr int start = -135 * Angle::turn / 360;
  constexpr int sweep = 270 * Angle::turn / 360;
  return Angle::from_steps(start + static_cast<int>(static_cast<std::int64_t>(sweep) * value / limit));
}

/// A number as text, without the heap.
class Number {
 public:
  explicit constexpr Number(int value) noexcept {
    do {
      text_[--begin_] = static_cast<char>('0' + value % 10);
      value /= 10;
    } while (value != 0 && begin_ > 0);
  }
  [[nodiscard]] constexpr std::string_view text() const noexcept {
    return {text_.data() + begin_, text_.size() - begin_};
  }

 private:
  std::array<char, 10> text_{};
  std::size_t begin_ = 10;
};

/// Draws one dial; `value` is in 1/16 of the scale's unit.
template <class Canvas, class Knobs = DefaultKnobs>
class DialPainter {
 public:
  DialPainter(Canvas& canvas, const DialPlace& place, const Scale& scale) noexcept
      : canvas_(canvas),
        place_(place),
        scale_(scale),
        centre_(intaglio::linear::to_subpixel(place.centre)),
        rim_(place.radius < 20 ? 1 : place.radius / 11),
        face_((place.radius - rim_) * one),
        arc_(place.radius >= 34) {}

  /// What doesn't move.
  void draw_face() {
    draw_bezel();
    draw_disc_ramp(ink::faces, ink::face_steps, place_.radius - rim_, ink::face, Knobs::face_steps);
    if (arc_)
      draw_arc();
    else
      draw_red_zone();
    draw_ticks();
    draw_numbers();
    if (place_.radius >= 52) {
      const intaglio::text::Font& font = place_.radius >= 110 ? text_font() : small_font();
      const bool fits = intaglio::text::measure(font, scale_.label).width < place_.radius * 5 / 8;
      canvas_.label(ink::dim, font, {place_.centre.x, below(34)}, Align::centre,
                    fits ? scale_.label : scale_.short_label);
    }
  }

  /// A number of `digits` digits in the open part of the scale.
  void draw_digits(int on, int digits, int value) {
    const int height = place_.radius * 20 / 100;
    if (height < 5) return;
    const int width = digits_width(height, digits);
    draw_number(canvas_, on, place_.radius >= 34 ? ink::ghost : no_ink,
                {place_.centre.x - width / 2, below(56) - height / 2 + 1}, height, digits, value);
  }

  void draw_needle(int value) {
    const int limit = scale_.limit << value_bits;
    const Angle to = angle_of(value < 0 ? 0 : value > limit ? limit : value, limit);
    const int tip = share(arc_ ? 84 : 90);
    const int width = place_.radius * one / 24 + one / 2;
    const int tail = share(20);
    if (place_.radius >= 30) {
      const int drop = place_.radius * one / 30;
      draw_blade(ink::shadow, {centre_.x + drop, centre_.y + drop * 3 / 2}, to, tip, tail, width);
    } else {
      draw_blade(ink::shadow, centre_, to, tip, tail, width + one);
    }
    draw_blade(ink::needle, centre_, to, tip, tail, width);
    if (place_.radius >= 40) draw_half_blade(to, tip, tail, width);
    const int cap = place_.radius / 8 > 2 ? place_.radius / 8 : 2;
    draw_disc_ramp(ink::hub, ink::hub_steps, cap, ink::steel_light, ink::hub_steps);
  }

 private:
  using Sine = typename Knobs::Sine;
  static constexpr int one = intaglio::linear::subpixel_one;

  // So many hundredths of the face's radius, in 1/256 px.
  [[nodiscard]] int share(int percent) const noexcept { return face_ / 100 * percent; }
  // The row so many hundredths of the face's radius below the centre.
  [[nodiscard]] int below(int percent) const noexcept {
    return place_.centre.y + (place_.radius - rim_) * percent / 100;
  }
  [[nodiscard]] SubPoint at(int radius, Angle angle) const noexcept {
    return around<Sine>(centre_, radius, angle);
  }

  // Metal lit from the upper left: a ring of wedges whose ink follows the cosine of their angle to the light.
  void draw_bezel() {
    if (place_.radius < 24) {
      canvas_.disc(ink::steel_light, place_.centre, place_.radius);
      return;
    }
    if (canvas_.theme().two_tone()) {
      canvas_.circle(ink::text, place_.centre, place_.radius);
      return;
    }
    canvas_.disc(ink::steel_dark, place_.centre, place_.radius);
    const int outer = (place_.radius - 1) * one + one / 2;
    const int face = (place_.radius - rim_) * one;
    if (rim_ < 4) {
      draw_metal(outer, face - one, 1);
      return;
    }
    const int ridge = (place_.radius - rim_ / 2) * one;
    draw_metal(outer, ridge - one, 1);
    draw_metal(ridge, face, -1);
    canvas_.disc(ink::shadow, place_.centre, place_.radius - rim_ + 1);
  }

  // A ring of metal between these radii; slope 1 rises towards the middle, -1 falls. What is drawn over it
  // has to hide its inner edge.
  void draw_metal(int outer, int inner, int slope) {
    const int wedges = Knobs::wedges;
    const int step = Angle::turn / wedges;
    std::array<SubPoint, 2> begin{at(inner, {}), at(outer, {})};
    for (int i = 0; i < wedges; ++i) {
      // Bright where the light comes from, and a little again on the far side, as turned metal is.
      const Angle middle = Angle::from_steps(i * step + step / 2 + Angle::turn / 8);
      const int facing = slope * intaglio::number::cosine<Sine>(middle).raw();
      const int glow = facing > 0 ? facing : -facing / 3;
      const Angle to = Angle::from_steps((i + 1) * step);
      const std::array<SubPoint, 2> end{at(inner, to), at(outer, to)};
      canvas_.quadrangle(ink::bezel + (glow * (ink::bezel_steps - 1) >> 15),
                         {begin[0], begin[1], end[1], end[0]});
      begin = end;
    }
  }

  // Discs one in another, the ramp's first ink outermost, `shown` of its inks; one flat disc where the
  // palette has no ramps.
  void draw_disc_ramp(int first, int steps, int radius, int flat, int shown) {
    if (!canvas_.theme().owns_entry(first)) {
      canvas_.disc(flat, place_.centre, radius);
      return;
    }
    for (int i = 0; i < shown; ++i) {
      const int step = shown == steps ? i : shown == 1 ? steps / 2 : i * (steps - 1) / (shown - 1);
      canvas_.disc(first + step, place_.centre, radius * (shown - i) / shown);
    }
  }

  void draw_arc() {
    const int outer = share(97);
    const int inner = share(90);
    constexpr int part = 16;  // of 18: the rest is the gap to the next segment
    for (int i = 0; i < ink::arc_segments; ++i) {
      const Angle from = angle_of(i * 18 + 1, ink::arc_segments * 18);
      const Angle to = angle_of(i * 18 + 1 + part, ink::arc_segments * 18);
      canvas_.quadrangle(scale_.arc + i, {at(outer, from), at(outer, to), at(inner, to), at(inner, from)});
    }
  }

  // Where there is no arc: a band from the red line to the end.
  void draw_red_zone() {
    constexpr int parts = 8;
    const int outer = share(99);
    const int inner = share(88);
    for (int i = 0; i < parts; ++i) {
      const int span = scale_.limit - scale_.red;
      const Angle from = angle_of(scale_.red + span * i / parts, scale_.limit);
      const Angle to = angle_of(scale_.red + span * (i + 1) / parts, scale_.limit);
      canvas_.polygon(
          ink::red, std::array<SubPoint, 4>{at(outer, from), at(outer, to), at(inner, to), at(inner, from)});
    }
  }

  void draw_ticks() {
    const int outer = share(arc_ ? 86 : 97);
    const int long_end = share(arc_ ? 76 : 80);
    const int short_end = share(arc_ ? 81 : 88);
    const int step = place_.radius >= 44   ? scale_.minor
                     : place_.radius >= 24 ? scale_.major
                                           : scale_.major * 2;
    const int width = place_.radius * one / 44;
    for (int value = 0; value <= scale_.limit; value += step) {
      const bool is_long = value % scale_.major == 0;
      const bool red = value >= scale_.red;
      const Angle angle = angle_of(value, scale_.limit);
      const SubPoint from = at(outer, angle);
      const SubPoint to = at(is_long ? long_end : short_end, angle);
      const int tick_ink = red ? ink::red : is_long ? ink::text : ink::dim;
      const bool smooth = edges() != Edges::hard;
      if (smooth || (is_long && width >= one)) {
        const int half = is_long && width >= one ? width / 2 : one / 2;
        const SubPoint side = around<Sine>({0, 0}, half, angle + intaglio::number::quarter_turn);
        shape(tick_ink, std::array<SubPoint, 4>{SubPoint{from.x - side.x, from.y - side.y},
                                                SubPoint{from.x + side.x, from.y + side.y},
                                                SubPoint{to.x + side.x, to.y + side.y},
                                                SubPoint{to.x - side.x, to.y - side.y}});
      } else {
        canvas_.line(tick_ink, nearest(from), nearest(to));
      }
    }
  }

  void draw_numbers() {
    if (place_.radius < 48) return;
    const intaglio::text::Font& font = number_font(place_.radius);
    const int radius = share(arc_ ? 62 : 66);
    // Every other number where they would touch.
    const int widest = intaglio::text::measure(font, Number(scale_.limit / scale_.number_unit).text()).width;
    const int count = scale_.limit / scale_.major;
    const bool crowded = radius / one * 4 * 7 / 6 < (widest + 6) * count * 7 / 8;
    for (int value = 0; value <= scale_.limit; value += scale_.major * (crowded ? 2 : 1)) {
      const Point p = nearest(at(radius, angle_of(value, scale_.limit)));
      canvas_.label(value >= scale_.red ? ink::red : ink::text, font, p, Align::centre,
                    Number(value / scale_.number_unit).text());
    }
  }

  // A blade from the tail over the centre to a fine tip.
  void draw_blade(int blade_ink, SubPoint centre, Angle to, int tip, int tail, int width) {
    using intaglio::number::quarter_turn;
    const SubPoint side = around<Sine>({0, 0}, width, to + quarter_turn);
    const SubPoint end = around<Sine>(centre, tip, to);
    const SubPoint back = around<Sine>(centre, -tail, to);
    const int fine = 3;  // the tip's share of the width
    shape(blade_ink, std::array<SubPoint, 4>{SubPoint{back.x - side.x, back.y - side.y},
                                             SubPoint{end.x - side.x / fine, end.y - side.y / fine},
                                             SubPoint{end.x + side.x / fine, end.y + side.y / fine},
                                             SubPoint{back.x + side.x, back.y + side.y}});
  }
  // The half that lies away from the light.
  void draw_half_blade(Angle to, int tip, int tail, int width) {
    using intaglio::number::quarter_turn;
    const Angle out = to + quarter_turn;
    // The light comes from the upper left: a flank is dark if it faces right and down.
    const SubPoint facing = around<Sine>({0, 0}, one, out);
    const int sign = facing.x + facing.y > 0 ? 1 : -1;
    // A blade with smooth edges reaches a pixel further, and is only tinted.
    const int reach = edges() == Edges::hard ? 0 : one;
    const SubPoint side = around<Sine>({0, 0}, sign * (width + 3 * reach), out);
    const SubPoint end = around<Sine>(centre_, tip + reach, to);
    const SubPoint back = around<Sine>(centre_, -tail - reach, to);
    const std::array<SubPoint, 4> half{back, end, SubPoint{end.x + side.x / 3, end.y + side.y / 3},
                                       SubPoint{back.x + side.x, back.y + side.y}};
    if constexpr (can_smooth) {
      if (edges() != Edges::hard) {
        tint_smooth(canvas_, half, Knobs::edge_steps);
        return;
      }
    }
    canvas_.polygon(ink::needle_dark, half);
  }

  static constexpr bool can_smooth = Knobs::edge_steps > 0 && Canvas::Format::bits == 8;

  // Edges can be smooth where all ramps have entries.
  [[nodiscard]] Edges edges() const noexcept {
    if constexpr (can_smooth) {
      if (canvas_.theme().owns_entry(ink::count_with(Knobs::edge_steps) - 1)) return Knobs::edges;
    }
    return Edges::hard;
  }

  // A polygon with edges as the knobs ask for; hard if its ink has no ramp.
  void shape(int shape_ink, const std::array<SubPoint, 4>& corners) {
    if constexpr (can_smooth) {
      if (edges() != Edges::hard && fill_smooth(canvas_, shape_ink, Knobs::edge_steps, edges(), corners))
        return;
    }
    canvas_.polygon(shape_ink, corners);
  }

  [[nodiscard]] static constexpr Point nearest(SubPoint p) noexcept {
    return {(p.x + one / 2) >> intaglio::linear::subpixel_bits,
            (p.y + one / 2) >> intaglio::linear::subpixel_bits};
  }

  Canvas& canvas_;
  const DialPlace& place_;
  const Scale& scale_;
  SubPoint centre_;
  int rim_;
  int face_;
  bool arc_;
};

}  // namespace apps::gauges
