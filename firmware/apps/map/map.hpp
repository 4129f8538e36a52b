// SPDX-License-Identifier: MIT
//
// The world's land, seen by a camera that tours it: panning, zooming, day and night.
//
// Rule: the picture is a pure function of the panel and the frame number, and draws every pixel of the
// surface it is given. Land is filled as polygons with holes; at the deepest zoom nearly all vertices of a
// continent lie thousands of pixels outside the panel, which changes neither a pixel nor the memory needed:
// the polygon filler keeps only edges with visible rows, and if those are more than the workspace holds, the
// picture is filled in halves, and halves of them.
//
// RAM: 11 KiB of vertices (the largest piece of land has 1370) and 20 KiB of edges.
// Data: Natural Earth 1:110m, public domain (see land.hpp).
#pragma once

#include <intaglio/image/surface.hpp>
#include <intaglio/present/screen_info.hpp>
#include <intaglio/raster/polygon.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/apps/canvas.hpp>
#include <firmware/apps/fonts.hpp>
#include <firmware/apps/map/coast.hpp>
#include <firmware/apps/map/inks.hpp>
#include <firmware/apps/map/knobs.hpp>
#include <firmware/apps/map/legend.hpp>
#include <firmware/apps/map/places.hpp>
#include <firmware/apps/map/projection.hpp>
#include <firmware/apps/map/tour.hpp>
#include <firmware/apps/map/zones.hpp>
#include <firmware/apps/theme.hpp>
#include <span>

namespace apps::map {

/// The program with its knobs turned (see `DefaultKnobs`). Follows the shape that `present::run` asks for.
template <intaglio::image::PixelFormat F, class Knobs>
class TunedMap {
 public:
  /// For a screen of at least one pixel.
  explicit TunedMap(const intaglio::present::ScreenInfo& screen) noexcept
      : size_(screen.size), theme_(ink::by_day, screen) {
    update(0);
  }

  /// Sets the state of a frame; frames may come in any order.
  void update(std::uint32_t frame) noexcept {
    camera_ = camera_at(frame, size_);
    if (camera_.night != night_ && !theme_.two_tone()) {
      night_ = camera_.night;
      for (int i = 0; i < ink::count; ++i)
        theme_.set(i, mix<Mixing>(ink::by_day[static_cast<std::size_t>(i)], ink::by_night(i), night_, 256));
    }
    theme_.fade(fade_full);
  }

  /// RGB bytes of this frame's palette; none where the screen's colours are fixed.
  [[nodiscard]] std::span<const std::uint8_t> palette() const noexcept { return theme_.palette(); }

  /// Draws all of `target.bounds()`, a frame or one band of it. Not to be called twice at the same time on
  /// one object. Errors: those of the library; none is expected.
  [[nodiscard]] Status draw(intaglio::image::Surface<F> target) const {
    Paint canvas(target, theme_);
    const Projection projection(camera_, size_);
    const Zones zones(projection, ink::land_steps / Knobs::zone_stride, size_.height);
    draw_ocean(canvas, projection);
    draw_graticule(canvas, projection);
    const bool lined = !theme_.two_tone() && pixels_per_degree(camera_) >= 1;
    // Surf and shadow of all land first, so no piece throws its shadow on another.
    if (lined && Knobs::surf > 0 && theme_.owns_entry(ink::shade))
      each_piece(canvas, projection, [&] { draw_surf(canvas); });
    each_piece(canvas, projection, [&] {
      fill_land(canvas, zones, canvas.bounds());
      if (lined) draw_shore(canvas, ink::coast, 0, 0);
    });
    draw_cities(canvas, projection);
    draw_legend(canvas, size_, camera_);
    return canvas.status();
  }

 private:
  using Mixing = typename Knobs::Mixing;
  using Colours = Theme<ink::count, static_cast<int>(F::max_index) + 1, Mixing>;
  using Paint = Canvas<F, Colours>;
  static constexpr int workspace_edges = 640;

  template <class Draw>
  void each_piece(const Paint& canvas, const Projection& projection, Draw draw) const {
    const Copies copies = copies_in_sight(projection, size_.width);
    for (int copy = copies.first; copy <= copies.last; ++copy)
      for (int i = 0; i < piece_count; ++i)
        if (coast_.find(i, copy, projection, canvas.bounds(), Knobs::shortest)) draw();
  }

  void draw_ocean(Paint& canvas, const Projection& projection) const {
    if (!theme_.owns_entry(ink::oceans + ink::ocean_steps - 1)) {
      canvas.fill(ink::ocean, {0, 0, size_.width, size_.height});
      return;
    }
    const int stride = Knobs::zone_stride;
    const Zones zones(projection, ink::ocean_steps / stride, size_.height);
    for (int i = 0; i < ink::ocean_steps / stride; ++i)
      canvas.fill(ink::oceans + i * stride + stride / 2,
                  {0, zones.begin(i), size_.width, zones.begin(i + 1) - zones.begin(i)});
  }

  void draw_graticule(Paint& canvas, const Projection& projection) const {
    constexpr int pole = 90 * units_per_degree;
    const int step = graticule_step(camera_) * units_per_degree;
    for (int y = -pole + step; y < pole; y += step)
      rule(canvas, {0, to_pixel(projection.row(y)), size_.width, 1});
    const Copies copies = copies_in_sight(projection, size_.width);
    const int east = copies.last * world_width + world_width / 2;
    for (int x = copies.first * world_width - world_width / 2; x <= east; x += step)
      rule(canvas, {to_pixel(projection.column(x)), 0, 1, size_.height});
  }

  // A line one pixel wide; dotted where there is no ink between water's and land's.
  void rule(Paint& canvas, const Rect& line) const {
    if (!canvas.sees(line)) return;
    if (!theme_.two_tone()) {
      canvas.fill(ink::graticule, line);
      return;
    }
    for (int y = line.y; y < line.bottom(); y += 4)
      for (int x = line.x; x < line.right(); x += 4) canvas.fill(ink::text, {x, y, 1, 1});
  }

  // Light water round the land, and its shadow to the lower right.
  void draw_surf(Paint& canvas) const {
    const bool all = Knobs::surf > 2;
    if (all) draw_shore(canvas, ink::shade, 2, 2);
    draw_shore(canvas, ink::shallow, -1, 0);
    if (all) draw_shore(canvas, ink::shallow, 0, -1);
    draw_shore(canvas, ink::shade, 1, 1);
  }

  void draw_shore(Paint& canvas, int line_ink, int dx, int dy) const {
    const auto vertices = coast_.vertices();
    const Rect& window = canvas.bounds();
    const auto outside = [&](Point a, Point b) {
      return (a.y < window.y && b.y < window.y) || (a.y >= window.bottom() && b.y >= window.bottom()) ||
             (a.x < window.x && b.x < window.x) || (a.x >= window.right() && b.x >= window.right());
    };
    std::size_t first = 0;
    for (const int length : coast_.contour_lengths()) {
      const std::size_t end = first + static_cast<std::size_t>(length);
      std::size_t before = end - 1;
      Point from = pixel(vertices[before], dx, dy);
      for (std::size_t i = first; i < end; before = i++) {
        const Point to = pixel(vertices[i], dx, dy);
        if (!outside(from, to) && coast_.is_shore(before, i)) canvas.line(line_ink, from, to);
        from = to;
      }
      first = end;
    }
  }

  [[nodiscard]] static constexpr Point pixel(SubPoint p, int dx, int dy) noexcept {
    return {to_pixel(p.x) + dx, to_pixel(p.y) + dy};
  }

  // Fills the piece found within a window, in halves if it has too many edges for the workspace.
  void fill_land(Paint& canvas, const Zones& zones, const Rect& window) const {
    using intaglio::raster::fill_polygon;
    using intaglio::raster::FillRule;
    const std::span<intaglio::raster::PolygonEdge> workspace(edges_);
    Status status;
    if (theme_.owns_entry(ink::lands + ink::land_steps - 1)) {
      const int stride = Knobs::zone_stride;
      ZoneSink<F> sink(canvas.target(), window, zones, ink::lands + stride / 2, stride);
      status = fill_polygon(sink, FillRule::even_odd, coast_.vertices(), coast_.contour_lengths(), workspace);
    } else {
      const intaglio::raster::Solid<F> sink{canvas.target(), theme_.index(ink::land), window};
      status = fill_polygon(sink, FillRule::even_odd, coast_.vertices(), coast_.contour_lengths(), workspace);
    }
    if (status.argument() == intaglio::Argument::workspace && window.height > 1) {
      const int upper = window.height / 2;
      fill_land(canvas, zones, {window.x, window.y, window.width, upper});
      fill_land(canvas, zones, {window.x, window.y + upper, window.width, window.height - upper});
      return;
    }
    canvas.note(status);
  }

  void draw_cities(Paint& canvas, const Projection& projection) const {
    const int density = pixels_per_degree(camera_);
    if (size_.height < 40 || density < 3) return;
    const int side = size_.height >= 200 ? 3 : 2;
    const bool named = size_.width >= 120 && size_.height >= 60 && density >= 5;
    const Copies copies = copies_in_sight(projection, size_.width);
    for (const City& city : cities)
      for (int copy = copies.first; copy <= copies.last; ++copy) {
        const int x = city.longitude * units_per_degree / 100 + copy * world_width;
        const int y = -city.latitude * units_per_degree / 100;
        const Point at{to_pixel(projection.column(x)), to_pixel(projection.row(y))};
        if (at.x < -100 || at.x > size_.width || !canvas.sees({0, at.y - 8, size_.width, 16})) continue;
        const Rect dot{at.x - 1, at.y - 1, side, side};
        canvas.fill(ink::panel, {dot.x - 1, dot.y - 1, side + 2, side + 2});
        canvas.fill(ink::city, dot);
        if (named) draw_name(canvas, {at.x + side + 2, at.y - 3}, city.name);
      }
  }

  // Readable on any ground: a dark copy on all sides of the text, or a dark box where that is too coarse.
  void draw_name(Paint& canvas, Point at, std::string_view name) const {
    if (theme_.two_tone()) {
      const Size box = intaglio::text::measure(small_font(), name);
      canvas.fill(ink::panel, {at.x - 1, at.y - 1, box.width + 1, box.height});
    }
    for (const Point d : {Point{-1, 0}, Point{1, 0}, Point{0, -1}, Point{0, 1}, Point{1, 1}})
      canvas.text(ink::panel, small_font(), {at.x + d.x, at.y + d.y}, name);
    canvas.text(ink::text, small_font(), at, name);
  }

  Size size_;
  Colours theme_;
  Camera camera_{};
  int night_ = -1;
  // Scratch of `draw`: nothing in it outlives a call.
  mutable Coast coast_;
  mutable std::array<intaglio::raster::PolygonEdge, workspace_edges> edges_;
};

/// The program as it is.
template <intaglio::image::PixelFormat F>
using Map = TunedMap<F, DefaultKnobs>;

}  // namespace apps::map
