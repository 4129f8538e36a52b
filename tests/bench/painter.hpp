// SPDX-License-Identifier: MIT
//
// A library that draws shapes, as the comparison sees it.
#pragma once

#include <tests/bench/pictures.hpp>

#include <memory>

namespace bench {

/// Draws white shapes on black. Each picks its own fastest sensible surface and calls.
class Painter {
 public:
  virtual ~Painter() = default;
  Painter() = default;
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  /// Makes everything black.
  virtual void clear() = 0;
  /// Draws a shape; false if the library has no call for it.
  virtual bool draw(const Shape& shape) = 0;
  /// Waits until what was drawn is in memory.
  virtual void finish() {}
  /// 0 (black) to 255 (white).
  [[nodiscard]] virtual int level(int x, int y) const = 0;
};

std::unique_ptr<Painter> make_intaglio();          ///< On 8 bits a pixel.
std::unique_ptr<Painter> make_intaglio_smooth();   ///< By exact area, on 8 bits a pixel; polygons alone.
std::unique_ptr<Painter> make_cairo(bool smooth);  ///< On CAIRO_FORMAT_A8.
std::unique_ptr<Painter> make_agg(bool smooth);    ///< On gray8.
std::unique_ptr<Painter> make_sdl_gfx();           ///< SDL's software renderer, on ARGB8888.

}  // namespace bench
