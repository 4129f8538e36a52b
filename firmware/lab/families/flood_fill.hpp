// SPDX-License-Identifier: MIT
//
// The family of flood fills: by runs, by a stack of pixels, and without any memory by going over the window
// again and again. All fill the same pixels.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/flood_rungs.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/status.hpp>

#include <array>
#include <cstdint>
#include <firmware/lab/family.hpp>
#include <span>
#include <string_view>

namespace lab {

using FloodPen = intaglio::raster::Solid<image::Indexed8>;

/// No memory: down and up over the whole window, as long as a pixel is found beside a filled one. It stays
/// here: pixels that have the pen's index before are taken for filled ones, so it isn't a rung of the
/// library's family.
struct SweepFlood {
  static constexpr number::Bound bound = intaglio::raster::SpanFlood::bound;
  static constexpr std::string_view domain =
      "regions of index 0 in windows without the pen's index: not in the library, so `cheapest` can't choose "
      "it";
  struct Cell {};
  intaglio::Status operator()(const FloodPen& pen, intaglio::linear::Point seed,
                              std::span<Cell> /*workspace*/) const noexcept {
    const auto clip = pen.clip();
    const auto surface = pen.surface();
    surface.set(seed.x, seed.y, pen.index());
    const auto filled = [&](int x, int y) {
      return x >= clip.x && y >= clip.y && x < clip.right() && y < clip.bottom() &&
             surface.get(x, y) == pen.index();
    };
    for (bool changed = true; changed;) {
      changed = false;
      for (const int step : {1, -1}) {
        for (int i = 0; i < clip.width * clip.height; ++i) {
          const int place = step > 0 ? i : clip.width * clip.height - 1 - i;
          const int x = clip.x + place % clip.width;
          const int y = clip.y + place / clip.width;
          if (surface.get(x, y) != 0 || (!filled(x - step, y) && !filled(x, y - step))) continue;
          surface.set(x, y, pen.index());
          changed = true;
        }
      }
    }
    return {};
  }
};

struct FloodFill {
  static constexpr std::string_view name = "flood-fill";
  static constexpr std::string_view title = "Flood fill of a chamber of 80x60 pixels";
  using Rungs = number::Family<intaglio::raster::SpanFlood, intaglio::raster::PixelStackFlood, SweepFlood>;
  using Default = intaglio::raster::SpanFlood;
  static constexpr Load loads[] = {
      {"empty chambers", 2}, {"winding corridors", 2}, {"chambers strewn with dots", 2}};

  static constexpr int width = 80;
  static constexpr int height = 60;
  static constexpr unsigned wall = 2;
  static constexpr int across = 4;  // chambers in a row of the canvas

  /// The seed of a chamber lies in its first free pixel.
  struct Input {
    intaglio::linear::Rect chamber;
    intaglio::linear::Point seed;
  };
  static Input input(int /*load*/, int i) noexcept {
    const intaglio::linear::Rect chamber{i % across * width, i / across % across * height, width, height};
    return {chamber, {chamber.x + 1, chamber.y + 1}};
  }

  /// True if a place of the canvas is wall under a load. Corridors are seven pixels wide and open by turns at
  /// their ends.
  static constexpr bool is_wall(int load, int x, int y) noexcept {
    const int u = x % width;
    const int v = y % height;
    if (u == 0 || v == 0) return true;
    if (load == 1 && u % 8 == 0) return u / 8 % 2 == 0 ? v < height - 8 : v >= 8;
    return load == 2 && !(u == 1 && v == 1) &&
           (static_cast<unsigned>(u * 73 + v * 151) * 2'654'435'761U >> 28U) == 0;
  }
  static void prepare(int load) noexcept {
    const auto picture = canvas();
    for (int y = 0; y < across * height; ++y) {
      for (int x = 0; x < across * width; ++x) picture.set(x, y, is_wall(load, x, y) ? wall : 0);
    }
  }
  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    static std::array<typename R::Cell, 8192> workspace;
    return R{}(FloodPen(canvas(), 1, in.chamber), in.seed, workspace).ok() ? 1 : 0;
  }
};

}  // namespace lab
