// SPDX-License-Identifier: MIT
#include <host/sim/half_blocks.hpp>

#include <algorithm>
#include <array>

namespace host {

namespace {

using Colour = std::array<std::uint8_t, 3>;

Colour colour_at(const RgbPicture& picture, int x, int y) {
  if (y >= picture.height) return {};
  const auto bytes = picture.at(x, y);
  return {bytes[0], bytes[1], bytes[2]};
}

/// `layer` is 38 for the foreground and 48 for the background.
void append_colour(std::string& out, int layer, const Colour& colour) {
  out += "\x1b[" + std::to_string(layer) + ";2;" + std::to_string(colour[0]) + ';' +
         std::to_string(colour[1]) + ';' + std::to_string(colour[2]) + 'm';
}

}  // namespace

RgbPicture shrink_to_fit(const RgbPicture& picture, int columns, int rows) {
  const auto parts = [](int length, int factor) { return (length + factor - 1) / factor; };
  int factor = 1;
  while (parts(picture.width, factor) > columns || parts(picture.height, factor) > 2 * rows) ++factor;
  if (factor == 1) return picture;
  RgbPicture small(parts(picture.width, factor), parts(picture.height, factor));
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      std::array<int, 3> sum{};
      int count = 0;
      for (int from_y = y * factor; from_y < std::min((y + 1) * factor, picture.height); ++from_y) {
        for (int from_x = x * factor; from_x < std::min((x + 1) * factor, picture.width); ++from_x) {
          const auto pixel = picture.at(from_x, from_y);
          for (std::size_t channel = 0; channel < 3; ++channel) sum[channel] += pixel[channel];
          ++count;
        }
      }
      const auto pixel = small.at(x, y);
      for (std::size_t channel = 0; channel < 3; ++channel)
        pixel[channel] = static_cast<std::uint8_t>((sum[channel] + count / 2) / count);
    }
  }
  return small;
}

std::string half_blocks(const RgbPicture& picture) {
  std::string out;
  for (int y = 0; y < picture.height; y += 2) {
    Colour above{};
    Colour below{};
    for (int x = 0; x < picture.width; ++x) {
      const Colour next_above = colour_at(picture, x, y);
      const Colour next_below = colour_at(picture, x, y + 1);
      if (x == 0 || next_above != above) append_colour(out, 38, next_above);
      if (x == 0 || next_below != below) append_colour(out, 48, next_below);
      above = next_above;
      below = next_below;
      out += "\u2580";
    }
    out += "\x1b[0m\r\n";
  }
  return out;
}

}  // namespace host
