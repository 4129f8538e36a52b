// SPDX-License-Identifier: MIT
//
// Pictures from files, copied, stretched or turned by the library's blits.
//
// Rule: a pixel at least half opaque takes the palette entry whose red, green and blue are nearest (the sum
// of the squared differences, the first of several); others are hidden by a mask. What lies inside the clip
// comes by spans, so a sprite can be exclusive-ored, counted and cut to a polygon as everything else.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/status.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace host::draw {

namespace linear = intaglio::linear;

/// A picture in indices, and a mask of it.
struct SpritePicture {
  linear::Size size;
  std::vector<std::uint8_t> indices;  ///< A byte a pixel.
  std::vector<std::uint8_t> mask;     ///< A bit a pixel, the highest first; rows begin at a byte.
};

/// Reads a PNG in the colours of a palette (RGBRGB…). Throws Failure.
std::shared_ptr<const SpritePicture> read_sprite(const std::string& path,
                                                 std::span<const std::uint8_t> palette);

enum class SpriteMethod : std::uint8_t {
  copy,
  stretch,  ///< To `area`.
  zoom,     ///< Scaled and turned about the middle, which stays where a copy has it.
  shear,    ///< Turned by three shears.
};

struct Sprite {
  std::shared_ptr<const SpritePicture> picture;
  SpriteMethod method{};
  linear::Rect area;  ///< Its corner is where a copy begins.
  int scale = 256;    ///< In 1/256, 1 .. 65536.
  intaglio::number::Angle angle;
};

/// Which pixels of a canvas show what.
class SpriteImage {
 public:
  /// Errors: as the blits.
  [[nodiscard]] static intaglio::Result<SpriteImage> create(const Sprite& sprite, linear::Size canvas);

  /// The index that a pixel of the canvas shows; below 0 for none.
  [[nodiscard]] int index(int x, int y) const {
    const std::size_t at =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    return on_zeros_[at] == on_ones_[at] ? on_zeros_[at] : -1;
  }

 private:
  // Drawn on two grounds: what is the same on both was drawn.
  int width_ = 0;
  std::vector<std::uint8_t> on_zeros_;
  std::vector<std::uint8_t> on_ones_;
};

}  // namespace host::draw
