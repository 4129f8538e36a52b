// SPDX-License-Identifier: MIT
//
// Pictures from files, copied, stretched or turned by the library's blits.
//
// Rule: red, green, blue and opacity are pictures of values, each drawn by itself. A pixel that is then at
// least half opaque takes the palette entry whose red, green and blue are nearest (the sum of the squared
// differences, the first of several), or, dithered, the level of its grey; others stay hidden. Ways that mix
// pixels weight their colours by opacity, so what is hidden doesn't show. What lies inside the clip comes by
// spans, so a sprite can be exclusive-ored, counted and cut to a polygon as everything else.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/status.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace host::draw {

namespace linear = intaglio::linear;

/// A picture's red, green, blue and opacity, a byte a pixel.
struct SpritePicture {
  linear::Size size;
  std::array<std::vector<std::uint8_t>, 4> channels;
};

/// Reads a PNG. Throws Failure.
std::shared_ptr<const SpritePicture> read_sprite(const std::string& path);

enum class SpriteMethod : std::uint8_t {
  copy,
  stretch,           ///< To `area`.
  stretch_bilinear,  ///< The same, interpolated.
  stretch_box,       ///< The same, the mean over each pixel's box.
  zoom,              ///< Scaled and turned about the middle, which stays where a copy has it.
  shear,             ///< Turned by three shears.
  turn_bilinear,     ///< Turned, interpolated.
};

enum class DitherMethod : std::uint8_t { none, bayer2, bayer4, bayer8, three_tap, four_tap, serpentine };
/// Greys in indices 0 .. levels - 1, by place on the canvas, or from its top left on.
struct SpriteDither {
  DitherMethod method{};
  int levels = 2;
};

struct Sprite {
  std::shared_ptr<const SpritePicture> picture;
  SpriteMethod method{};
  linear::Rect area;  ///< Its corner is where a copy begins.
  int scale = 256;    ///< In 1/256, 1 .. 65536.
  intaglio::number::Angle angle;
  std::vector<std::uint8_t> palette;  ///< RGBRGB…
  std::optional<SpriteDither> dither;
};

/// Which pixels of a canvas show what.
class SpriteImage {
 public:
  /// Errors: as the blits.
  [[nodiscard]] static intaglio::Result<SpriteImage> create(const Sprite& sprite, linear::Size canvas);

  /// The index that a pixel of the canvas shows; below 0 for none.
  [[nodiscard]] int index(int x, int y) const {
    return indices_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                    static_cast<std::size_t>(x)];
  }

 private:
  int width_ = 0;
  std::vector<std::int16_t> indices_;
};

}  // namespace host::draw
