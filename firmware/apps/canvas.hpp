// SPDX-License-Identifier: MIT
//
// A surface to draw on by ink, that remembers the first thing that went wrong.
//
// Rule: every call draws one primitive of the library with the index of an ink; a call whose bounding box
// lies wholly outside the surface (a band of a frame, often) costs a few comparisons. A program's layout may
// shrink to nothing on a tiny screen, so empty shapes are fine and draw nothing.
#pragma once

#include <intaglio/image/surface.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/sine.hpp>
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/rectangle.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/raster/triangle.hpp>
#include <intaglio/status.hpp>
#include <intaglio/text/draw_text.hpp>
#include <intaglio/text/measure.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace apps {

using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::linear::Size;
using intaglio::linear::SubPoint;
using intaglio::number::Angle;

/// Where a text stands relative to its point.
enum class Align : std::uint8_t { left, centre, right };

/// The place `radius` (in 1/256 px, at most 2^27) away from `centre`, `angle` clockwise from straight up.
/// Each coordinate is off by less than 1 + radius/20000 sub-pixels, by the sine that the library uses; by
/// another rung by what its bound says.
template <intaglio::number::Rung Sine = intaglio::number::SineTable256Linear>
[[nodiscard]] constexpr SubPoint around(SubPoint centre, int radius, Angle angle) noexcept {
  const auto scaled = [=](int q15) {
    return static_cast<int>((static_cast<std::int64_t>(radius) * q15 + 16384) >> 15);
  };
  return {centre.x + scaled(intaglio::number::sine<Sine>(angle).raw()),
          centre.y - scaled(intaglio::number::cosine<Sine>(angle).raw())};
}

/// Draws with the inks of a `Theme` on one surface.
template <intaglio::image::PixelFormat F, class Theme>
class Canvas {
 public:
  using Format = F;

  Canvas(intaglio::image::Surface<F> target, const Theme& theme) noexcept : target_(target), theme_(theme) {}

  /// The first error of all calls so far.
  [[nodiscard]] Status status() const noexcept { return status_; }
  [[nodiscard]] const Rect& bounds() const noexcept { return target_.bounds(); }
  [[nodiscard]] const intaglio::image::Surface<F>& target() const noexcept { return target_; }
  [[nodiscard]] const Theme& theme() const noexcept { return theme_; }

  /// True if a pixel of the rectangle is on the surface.
  [[nodiscard]] bool sees(const Rect& area) const noexcept {
    return !intaglio::linear::intersect(area, target_.bounds()).empty();
  }

  void fill(int ink, const Rect& area) {
    if (sees(area)) note(intaglio::raster::fill_rect(solid(ink), area));
  }
  void frame(int ink, const Rect& area) {
    if (sees(area)) note(intaglio::raster::draw_rect(solid(ink), area));
  }
  void line(int ink, Point from, Point to) { note(intaglio::raster::draw_line(solid(ink), from, to)); }
  void disc(int ink, Point centre, int radius) {
    if (radius >= 0 && sees({centre.x - radius, centre.y - radius, 2 * radius + 1, 2 * radius + 1}))
      note(intaglio::raster::fill_disc(solid(ink), centre, radius));
  }
  void circle(int ink, Point centre, int radius) {
    if (radius >= 0 && sees({centre.x - radius, centre.y - radius, 2 * radius + 1, 2 * radius + 1}))
      note(intaglio::raster::draw_circle(solid(ink), centre, radius));
  }
  /// One contour of at most 16 corners.
  void polygon(int ink, std::span<const SubPoint> corners) {
    std::array<intaglio::raster::PolygonEdge, 16> workspace;
    note(intaglio::raster::fill_polygon(solid(ink), intaglio::raster::FillRule::non_zero, corners,
                                        std::span(workspace)));
  }
  /// A convex contour of four corners: as `polygon` would, at less cost for small ones.
  void quadrangle(int ink, const std::array<SubPoint, 4>& corners) {
    const auto pen = solid(ink);
    note(intaglio::raster::fill_triangle(pen, corners[0], corners[1], corners[2]));
    note(intaglio::raster::fill_triangle(pen, corners[0], corners[2], corners[3]));
  }
  void text(int ink, const intaglio::text::Font& font, Point top_left, std::string_view utf8) {
    if (!font.empty()) note(intaglio::text::draw_text(solid(ink), font, top_left, utf8));
  }
  /// The part of a text that lies in a rectangle.
  void text_within(int ink, const Rect& window, const intaglio::text::Font& font, Point top_left,
                   std::string_view utf8) {
    if (font.empty() || !sees(window)) return;
    note(intaglio::text::draw_text(intaglio::raster::Solid<F>{target_, theme_.index(ink), window}, font,
                                   top_left, utf8));
  }
  /// Text whose line box is centred on `at.y` and stands left of, on or right of `at.x`.
  void label(int ink, const intaglio::text::Font& font, Point at, Align align, std::string_view utf8) {
    const Size box = intaglio::text::measure(font, utf8);
    const int shift = align == Align::left ? 0 : align == Align::centre ? box.width / 2 : box.width;
    text(ink, font, {at.x - shift, at.y - box.height / 2}, utf8);
  }
  /// A picture of one ink: a row a word, the most significant of its `columns` bits left, each bit a square
  /// of `scale` pixels.
  void bitmap(int ink, Point top_left, std::span<const std::uint16_t> rows, int columns, int scale) {
    const int side = static_cast<int>(rows.size()) * scale;
    if (!sees({top_left.x, top_left.y, columns * scale, side})) return;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const int y = top_left.y + static_cast<int>(row) * scale;
      for (int begin = 0; begin < columns;) {
        const auto lit = [&](int column) {
          return column < columns &&
                 (unsigned{rows[row]} >> static_cast<unsigned>(columns - 1 - column) & 1U) != 0;
        };
        if (!lit(begin)) {
          ++begin;
          continue;
        }
        int end = begin;
        while (lit(end)) ++end;
        fill(ink, {top_left.x + begin * scale, y, (end - begin) * scale, scale});
        begin = end;
      }
    }
  }

  /// Takes the status of a drawing call made elsewhere.
  void note(Status status) noexcept {
    if (status_.ok()) status_ = status;
  }

 private:
  [[nodiscard]] auto solid(int ink) const noexcept {
    return intaglio::raster::Solid<F>{target_, theme_.index(ink)};
  }

  intaglio::image::Surface<F> target_;
  const Theme& theme_;
  Status status_{};
};

}  // namespace apps
