// SPDX-License-Identifier: MIT
//
// PNG in and out, through libpng.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace host {

/// A picture of palette indices, a byte a pixel whatever its depth, rows close together.
struct IndexedPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> indices;      ///< width * height.
  std::vector<std::uint8_t> palette_rgb;  ///< RGBRGB…, 1..256 entries.
};

/// A picture of red, green, blue, alpha, 8 bits each in the sRGB encoding, rows close together.
struct RgbaPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< 4 * width * height.
};

/// A PNG with a palette, in as few bits a pixel as the palette needs. Throws Failure if the picture can't be
/// one (no pixel, an index without a colour).
std::string encode_png(const IndexedPicture& picture);

/// Reads any PNG. Throws Failure that names the file and says what is wrong with it.
RgbaPicture read_png(const std::string& path);

}  // namespace host
