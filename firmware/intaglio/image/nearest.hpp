// SPDX-License-Identifier: MIT
//
// The entry of a palette that is nearest to a colour.
//
// Rule: nearest is by the squared distance of the sRGB codes, each channel counting the same; of several as
// near, the lowest index. Distances that come closer to what the eye sees are in nearest_rungs.hpp.
// Error: none. Bit budget: a squared distance has 18 bits. Textbook: section 1.4, on palettes.
#pragma once

#include <intaglio/image/palette.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::image {

/// The entry of a palette (RGBRGB..., as `Palette::bytes()`) whose colour is nearest; 0 if there is none.
/// Cost: about 10 instructions an entry.
[[nodiscard]] constexpr std::uint8_t nearest_entry(std::span<const std::uint8_t> palette,
                                                   Rgb colour) noexcept {
  std::uint8_t nearest = 0;
  int least = 3 * 255 * 255 + 1;
  for (std::size_t at = 0; at + 3 <= palette.size() && at < 768; at += 3) {
    const int r = palette[at] - colour.r;
    const int g = palette[at + 1] - colour.g;
    const int b = palette[at + 2] - colour.b;
    const int distance = r * r + g * g + b * b;
    if (distance >= least) continue;
    least = distance;
    nearest = static_cast<std::uint8_t>(at / 3);
    if (distance == 0) break;
  }
  return nearest;
}

}  // namespace intaglio::image
