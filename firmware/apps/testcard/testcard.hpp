// SPDX-License-Identifier: MIT
//
// A test card, for bringing up a board: what is wrong with a panel shows at a glance.
//
// - One-pixel border: a picture that is shifted, cropped or has the wrong stride loses a side or slants.
// - Bars of every index from left to right: swapped nibbles or bits, and a wrong palette depth.
// - The frame number in binary, most significant bit left: dropped and repeated frames.
// - Fields of one-pixel columns and rows: swapped bit order within a byte turns the columns into pairs.
// - A box that runs along the bottom: tearing shows as a step in its sides.
// - Figures, by every primitive of the library, most of them cut by an edge and some far larger than the
//   screen, so that equal digests on two machines say something of each.
#pragma once

#include <intaglio/image/palette.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/present/screen_info.hpp>
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/pixel.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/rectangle.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/raster/triangle.hpp>
#include <intaglio/status.hpp>

#include <array>
#include <cstdint>
#include <firmware/apps/place.hpp>
#include <span>

namespace apps::testcard {

/// Looks best from 64x32 pixels up; draws on any size.
template <intaglio::image::PixelFormat F>
class TestCard {
 public:
  explicit TestCard(const intaglio::present::ScreenInfo& screen)
      : size_(screen.size), paletted_(screen.palette_entries != 0) {}

  /// The state of that frame.
  void update(std::uint32_t frame) {
    frame_ = frame;
    turn_ = intaglio::number::Angle::from_steps(static_cast<int>(frame % 256U) * 256);
    // Colours that go round by an entry a frame; the first is black and the last white throughout.
    for (unsigned i = 1; i < bright; ++i) {
      const unsigned step = (i + frame) * 255U / bright;
      const intaglio::image::Rgb colour{static_cast<std::uint8_t>(step), static_cast<std::uint8_t>(step * 3U),
                                        static_cast<std::uint8_t>(255U - step)};
      colours_.set(static_cast<int>(i), colour).ignore();
    }
    colours_.set(static_cast<int>(bright), {255, 255, 255}).ignore();
  }
  std::span<const std::uint8_t> palette() const {
    return paletted_ ? colours_.bytes() : std::span<const std::uint8_t>{};
  }

  intaglio::Status draw(intaglio::image::Surface<F> target) const {
    // The first thing that goes wrong is the answer, and the rest is still drawn.
    intaglio::Status status;
    const auto keep = [&status](intaglio::Status s) {
      if (status.ok()) status = s;
    };
    const int width = size_.width;
    const int height = size_.height;
    keep(fill_rect(Solid(target, 0), {0, 0, width, height}));
    draw_bars(target, {0, 0, width, height / 5}, keep);
    draw_number(target, {0, height / 5, width, height / 10}, keep);
    draw_columns(target, {0, height * 3 / 10, width / 2, height / 10}, keep);
    draw_rows(target, {width / 2, height * 3 / 10, width - width / 2, height / 10}, keep);
    draw_figures(target, {0, height * 2 / 5, width, height - height * 2 / 5}, keep);
    keep(draw_rect(Solid(target, bright), {0, 0, width, height}));
    return status;
  }

 private:
  using Solid = intaglio::raster::Solid<F>;
  using Xor = intaglio::raster::Xor<F>;
  using Surface = intaglio::image::Surface<F>;
  using Rect = intaglio::linear::Rect;
  using Point = intaglio::linear::Point;
  using SubPoint = intaglio::linear::SubPoint;
  using Angle = intaglio::number::Angle;

  static constexpr unsigned bright = F::max_index;

  /// An index other than the background's, spread over those there are.
  static constexpr unsigned shade(unsigned sixteenths) noexcept {
    return 1U + sixteenths * (bright - 1U) / 16U;
  }

  template <class Keep>
  static void draw_bars(Surface target, const Rect& area, Keep keep) {
    constexpr int bars = static_cast<int>(bright) + 1;
    for (int i = 0; i < bars; ++i) {
      const int left = area.x + area.width * i / bars;
      const int right = area.x + area.width * (i + 1) / bars;
      keep(fill_rect(Solid(target, static_cast<unsigned>(i)), {left, area.y, right - left, area.height}));
    }
  }

  template <class Keep>
  void draw_number(Surface target, const Rect& area, Keep keep) const {
    constexpr int bits = 16;
    for (int i = 0; i < bits; ++i) {
      const Rect field{area.x + area.width * i / bits + 1, area.y + 1, area.width / bits - 2,
                       area.height - 2};
      const bool set = (frame_ >> static_cast<unsigned>(bits - 1 - i) & 1U) != 0;
      keep(set ? fill_rect(Solid(target, bright), field) : draw_rect(Solid(target, shade(8)), field));
    }
  }

  template <class Keep>
  static void draw_columns(Surface target, const Rect& area, Keep keep) {
    const Solid pen(target, bright);
    for (int x = area.x; x < area.right(); x += 2) keep(draw_vertical(pen, {x, area.y}, area.height));
  }

  template <class Keep>
  static void draw_rows(Surface target, const Rect& area, Keep keep) {
    const Solid pen(target, bright);
    for (int y = area.y; y < area.bottom(); y += 2) keep(draw_horizontal(pen, {area.x, y}, area.width));
  }

  template <class Keep>
  void draw_figures(Surface target, const Rect& area, Keep keep) const {
    const int unit = area.height / 2;
    const Point left{area.x + area.width / 6, area.y + unit};
    const Point middle{area.x + area.width / 2, area.y + unit};
    const Point right{area.right() - area.width / 6, area.y + unit};

    // Sparks, most of them outside.
    for (unsigned i = 0; i < 64; ++i) {
      const unsigned random = (i * 64U + frame_ + 1U) * 2654435761U;
      const Point spark{static_cast<int>(random >> 8U & 1023U) - 100,
                        static_cast<int>(random >> 18U & 1023U) - 100};
      keep(draw_pixel(Solid(target, shade(i & 15U), area), spark));
    }
    // A fan of lines whose ends lie near the domain's edge, in a window of its own.
    const Rect window{left.x - unit * 3 / 4, left.y - unit * 3 / 4, unit * 3 / 2, unit * 3 / 2};
    constexpr Angle step_of_fan = Angle::from_degrees(30);
    for (int i = 0; i < 12; ++i) {
      const SubPoint end = around({}, 65'000, turn_ + step_of_fan * i);
      keep(draw_line(Solid(target, shade(static_cast<unsigned>(i)), window), left, {end.x * 16, end.y * 16}));
    }
    keep(draw_rect(Solid(target, bright), window));
    // Circles one in another, and a circle far larger than the screen.
    const int radius = unit * static_cast<int>(frame_ % 64U) / 64;
    for (int r = radius; r > 0; r -= 5) keep(draw_circle(Solid(target, shade(12), area), middle, r));
    keep(draw_circle(Solid(target, shade(4), area), {middle.x, middle.y + 5'000}, 5'000 + unit / 2));
    // A star that crosses itself, a polygon with a hole, a triangle, all turning by less than a pixel a
    // frame.
    draw_star(target, right, unit * 7 / 8, keep);
    draw_frame(target, middle, unit / 2, keep);
    const int reach = unit * 96;
    keep(fill_triangle(Solid(target, shade(14), area), around(right, reach, -turn_),
                       around(right, reach, -turn_ + Angle::from_degrees(120)),
                       around(right, reach, -turn_ + Angle::from_degrees(240))));
    // Inverting twice where they overlap.
    keep(fill_disc(Xor(target, bright, area), {middle.x - unit / 3, middle.y}, unit / 3));
    keep(fill_disc(Xor(target, bright, area), {middle.x, middle.y}, unit / 3));
    // The box that runs.
    const int step = static_cast<int>(frame_ * 2U % static_cast<unsigned>(size_.width));
    keep(fill_rect(Xor(target, bright), {step, area.bottom() - unit / 2, unit / 3, unit / 3}));
  }

  template <class Keep>
  void draw_star(Surface target, Point centre, int radius, Keep keep) const {
    std::array<SubPoint, 5> tips;
    for (int i = 0; i < 5; ++i)
      tips[static_cast<std::size_t>(i)] =
          around(centre, radius * intaglio::linear::subpixel_one, turn_ + Angle::from_degrees(144 * i));
    std::array<intaglio::raster::PolygonEdge, 5> workspace;
    const auto rule =
        frame_ / 64U % 2U == 0 ? intaglio::raster::FillRule::even_odd : intaglio::raster::FillRule::non_zero;
    keep(fill_polygon(Solid(target, shade(6)), rule, tips, workspace));
  }

  /// A square with a square hole.
  template <class Keep>
  void draw_frame(Surface target, Point centre, int radius, Keep keep) const {
    const int outer = radius * intaglio::linear::subpixel_one;
    std::array<SubPoint, 8> corners;
    for (int i = 0; i < 4; ++i) {
      const Angle angle = turn_ + intaglio::number::quarter_turn * i;
      corners[static_cast<std::size_t>(i)] = around(centre, outer, angle);
      corners[static_cast<std::size_t>(4 + i)] = around(centre, outer * 3 / 4, angle);
    }
    constexpr std::array contours{4, 4};
    std::array<intaglio::raster::PolygonEdge, 8> workspace;
    keep(fill_polygon(Solid(target, shade(10)), intaglio::raster::FillRule::even_odd, corners, contours,
                      workspace));
  }

  intaglio::linear::Size size_;
  bool paletted_;
  std::uint32_t frame_ = 0;
  Angle turn_{};
  intaglio::image::Palette<static_cast<int>(F::max_index) + 1> colours_;
};

}  // namespace apps::testcard
