// SPDX-License-Identifier: MIT
//
// Ways to fill the region of a seed's index: by runs, and by a stack of pixels.
//
// Rule: the pixels that `flood_fill` fills by four neighbours (flood.hpp), which is `SpanFlood`.
// `PixelStackFlood`, the textbook's, puts the four neighbours of each pixel onto a stack of 4 bytes a pixel:
// of an empty area as many as it has pixels at worst. Both take a workspace of the rung's `Cell`s.
//
// Error: none. Bit budget: places on the stack have 16 bits. Textbook: section 2.8. Worst known inputs: empty
// areas by pixels, mazes by runs.
#pragma once

#include <intaglio/image/surface.hpp>
#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/raster/flood.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::raster {

/// The library's, a run of pixels at a time: `flood_fill`.
struct SpanFlood {
  static constexpr number::Bound bound = number::exactly(number::Unit::wrong_pixel);
  using Cell = FloodSpan;
  template <image::PixelFormat F>
  Status operator()(const Solid<F>& pen, linear::Point seed, const std::span<Cell>& workspace) const {
    return flood_fill(pen, Connectivity::four, seed, workspace);
  }
};

/// A place on the stack of `PixelStackFlood`.
struct FloodPlace {
  std::int16_t x = 0;
  std::int16_t y = 0;
};

/// Pixel by pixel. Arguments and errors as `SpanFlood`'s; too_large rectangle if the clip has places of more
/// than 16 bits. `needed()` of a workspace that is too small is one more than there are.
struct PixelStackFlood {
  static constexpr number::Bound bound = SpanFlood::bound;
  using Cell = FloodPlace;
  template <image::PixelFormat F>
  Status operator()(const Solid<F>& pen, linear::Point seed, const std::span<Cell>& workspace) const {
    if (!linear::in_domain(seed)) return {Error::out_of_domain, Argument::point};
    const linear::Rect clip = pen.clip();
    constexpr int most = 32'767;
    if (clip.x < -most || clip.y < -most || clip.right() > most || clip.bottom() > most)
      return {Error::too_large, Argument::rectangle, most};
    if (!in_clip(clip, seed)) return {};
    const image::Surface<F>& surface = pen.surface();
    const unsigned index = pen.index();
    const unsigned region = surface.get(seed.x, seed.y);
    if (region == index) return {};
    std::size_t height = 0;
    const auto visit = [&](int x, int y) {
      if (!in_clip(clip, {x, y}) || surface.get(x, y) != region) return true;
      if (height == workspace.size()) return false;
      surface.set(x, y, index);
      workspace[height++] = {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)};
      return true;
    };
    bool fits = visit(seed.x, seed.y);
    while (fits && height != 0) {
      const auto [x, y] = workspace[--height];
      fits = visit(x - 1, y) && visit(x + 1, y) && visit(x, y - 1) && visit(x, y + 1);
    }
    if (fits) return {};
    return {Error::too_small, Argument::workspace, static_cast<std::uint32_t>(workspace.size() + 1)};
  }
};

/// The rungs of flood fills.
using FloodFamily = number::Family<SpanFlood, PixelStackFlood>;

}  // namespace intaglio::raster
