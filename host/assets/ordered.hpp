// SPDX-License-Identifier: MIT
//
// Ordered dithering of a picture in colour to any palette.
//
// Rule: each pixel shows one of two entries, the one nearest to its colour c and another, by Bayer's matrix
// of 8x8: of two entries a and b the b of greater red + green + blue in so many of 64 places, s, that the
// mixture comes nearest to c. The other entry is the one for which |mixture - c|^2 and a quarter of
// s (64 - s) / 64^2 |a - b|^2 is least: a true mean, but no coarser than need be. A colour of the palette
// stays plain.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace host::assets {

using Colour = std::array<std::uint8_t, 3>;

/// The entry that each pixel of a picture (RGBARGBA…) shows. Precondition: there are 1 to 256 entries.
std::vector<std::uint8_t> dither_ordered(std::span<const std::uint8_t> rgba, std::size_t width,
                                         std::span<const Colour> palette);

}  // namespace host::assets
