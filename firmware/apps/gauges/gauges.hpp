// SPDX-License-Identifier: MIT
//
// An instrument cluster: two dials, digits, bars, an odometer and warning lights, on a panel of any size.
//
// Rule: the picture is a pure function of the panel and the frame number. A frame draws every pixel of the
// surface it is given, so bands and whole frames agree. What glows or blinks (arcs, lights, the fade at the
// start) has palette entries of its own wherever the panel has enough of them; elsewhere the same code picks
// another index (see `apps::Theme`).
#pragma once

#include <intaglio/image/surface.hpp>
#include <intaglio/present/screen_info.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/apps/canvas.hpp>
#include <firmware/apps/fonts.hpp>
#include <firmware/apps/gauges/bars.hpp>
#include <firmware/apps/gauges/dial.hpp>
#include <firmware/apps/gauges/drive.hpp>
#include <firmware/apps/gauges/inks.hpp>
#include <firmware/apps/gauges/knobs.hpp>
#include <firmware/apps/gauges/layout.hpp>
#include <firmware/apps/gauges/symbols.hpp>
#include <firmware/apps/theme.hpp>
#include <span>

namespace apps::gauges {

/// The program with its knobs turned (see `DefaultKnobs`). Follows the shape that `present::run` asks for.
template <intaglio::image::PixelFormat F, class Knobs>
class TunedGauges {
 public:
  /// For a screen of at least one pixel.
  explicit TunedGauges(const intaglio::present::ScreenInfo& screen) noexcept
      : size_(screen.size), layout_(layout_for(screen.size)), theme_(inks(), screen) {
    update(0);
  }

  /// Sets the state of a frame; frames may come in any order.
  void update(std::uint32_t frame) noexcept {
    now_ = readings_at(frame);
    light_arc(speed_scale, now_.speed);
    light_arc(rpm_scale, now_.rpm);
    for (int i = 0; i < light_count; ++i) light_lamp(i, (now_.lights >> static_cast<unsigned>(i) & 1U) != 0);
    theme_.fade(now_.brightness);
  }

  /// RGB bytes of this frame's palette; none where the screen's colours are fixed.
  [[nodiscard]] std::span<const std::uint8_t> palette() const noexcept { return theme_.palette(); }

  /// Draws all of `target.bounds()`, a frame or one band of it. Errors: those of the library; none is
  /// expected.
  [[nodiscard]] Status draw(intaglio::image::Surface<F> target) const {
    Paint canvas(target, theme_);
    draw_backdrop(canvas);
    if (layout_.speed.radius > 0) draw_dial(canvas, layout_.speed, speed_scale, now_.speed);
    if (layout_.rpm.radius > 0) draw_dial(canvas, layout_.rpm, rpm_scale, now_.rpm);
    if (!layout_.readout.empty()) draw_readout(canvas, layout_.readout, now_);
    draw_level(canvas, layout_.fuel, fuel_level, now_.fuel);
    draw_level(canvas, layout_.heat, heat_level, now_.heat);
    draw_odometer(canvas, layout_.odometer, now_.odometer);
    draw_lights(canvas);
    return canvas.status();
  }

 private:
  using Mixing = typename Knobs::Mixing;
  using Colours = Theme<ink::count_with(Knobs::edge_steps), static_cast<int>(F::max_index) + 1, Mixing>;
  using Paint = Canvas<F, Colours>;

  // Knobs that aren't constants name their table themselves.
  [[nodiscard]] static const auto& inks() noexcept {
    if constexpr (requires { Knobs::inks(); }) {
      return Knobs::inks();
    } else {
      return ink::table<Mixing, Knobs::edge_steps>;
    }
  }

  // A segment glows up to the value, brightest at its end.
  void light_arc(const Scale& scale, int value) noexcept {
    constexpr int segments = ink::arc_segments;
    constexpr Ink off{{24, 30, 40}, 34};
    constexpr Ink off_red{{72, 16, 20}, 51};
    constexpr Ink cool{{16, 92, 168}, 136};
    constexpr Ink bright{{120, 232, 255}, 255};
    constexpr Ink white{{255, 255, 255}, 255};
    constexpr Ink hot{{255, 52, 40}, 255};
    const int limit = scale.limit << value_bits;
    // In 1/16 of a segment.
    const auto lit = static_cast<int>(static_cast<std::int64_t>(value) * segments * 16 / limit);
    for (int i = 0; i < segments; ++i) {
      const bool red = i * scale.limit >= scale.red * segments;
      const Ink dark = red ? off_red : off;
      const int behind = lit - i * 16;  // how far the value has passed the segment's begin
      constexpr int tail = 12 * 16;
      Ink glow = red ? hot
                     : mix<Mixing>(bright, cool,
                                   behind < 16          ? 0
                                   : behind - 16 < tail ? behind - 16
                                                        : tail,
                                   tail);
      // A light runs round, as far as the arc is lit.
      if (i == segments * now_.runner / 1000 && theme_.owns_entry(scale.arc + i))
        glow = mix<Mixing>(glow, white, 1, 2);
      if (behind < 16) glow = mix<Mixing>(dark, glow, behind > 0 ? behind : 0, 16);
      theme_.set(scale.arc + i, glow);
    }
  }

  void light_lamp(int i, bool on) noexcept {
    constexpr std::array<int, light_count> colours{ink::green, ink::red, ink::red,  ink::amber,
                                                   ink::amber, ink::red, ink::blue, ink::green};
    const Ink lit = ink::all[static_cast<std::size_t>(colours[static_cast<std::size_t>(i)])];
    constexpr Ink dark{{34, 40, 50}, 34};
    theme_.set(ink::lights + i, on ? lit : dark);
  }

  void draw_backdrop(Paint& canvas) const {
    if (!theme_.owns_entry(ink::backdrop)) {
      canvas.fill(ink::background, {0, 0, size_.width, size_.height});
      return;
    }
    for (int i = 0; i < ink::backdrop_steps; ++i) {
      const int top = static_cast<int>(static_cast<std::int64_t>(size_.height) * i / ink::backdrop_steps);
      const int end =
          static_cast<int>(static_cast<std::int64_t>(size_.height) * (i + 1) / ink::backdrop_steps);
      canvas.fill(ink::backdrop + i, {0, top, size_.width, end - top});
    }
  }

  void draw_dial(Paint& canvas, const DialPlace& place, const Scale& scale, int value) const {
    const int side = 2 * place.radius + 1;
    if (!canvas.sees({place.centre.x - place.radius, place.centre.y - place.radius, side, side})) return;
    DialPainter<Paint, Knobs> dial(canvas, place, scale);
    dial.draw_face();
    if (scale.limit == speed_limit)
      dial.draw_digits(ink::text, 3, (now_.speed + 8) >> value_bits);
    else
      dial.draw_digits(ink::amber, 1, now_.gear);
    dial.draw_needle(value);
  }

  void draw_lights(Paint& canvas) const {
    if (layout_.light_scale == 0) {
      draw_arrows(canvas);
      return;
    }
    const Rect& strip = layout_.lights;
    const int side = 16 * layout_.light_scale;
    for (int i = 0; i < light_count; ++i) {
      // The turn signals stand at the ends, the rest in the middle, a light's width apart.
      const int middle = strip.x + strip.width / 2 + (2 * i - light_count + 1) * side * 7 / 8 - side / 2;
      const int x = i == 0 ? strip.x : i == light_count - 1 ? strip.right() - side : middle;
      canvas.bitmap(ink::lights + i, {x, strip.y}, symbols::of(static_cast<Light>(i)), 16,
                    layout_.light_scale);
    }
  }

  // The turn signals alone, where there is no strip of lights.
  void draw_arrows(Paint& canvas) const {
    if (layout_.arrows.empty()) return;
    constexpr int side = symbols::small_columns;
    const auto draw = [&](Light light, int x, std::span<const std::uint16_t> rows) {
      canvas.bitmap(ink::lights + static_cast<int>(light), {x, layout_.arrows.y}, rows, side, 1);
    };
    draw(Light::left, layout_.arrows.x, symbols::small_left);
    draw(Light::right, layout_.arrows.right() - side, symbols::small_right);
  }

  Size size_;
  Layout layout_;
  Colours theme_;
  Readings now_{};
};

/// The program as it is.
template <intaglio::image::PixelFormat F>
using Gauges = TunedGauges<F, DefaultKnobs>;

}  // namespace apps::gauges
