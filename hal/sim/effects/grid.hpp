// SPDX-License-Identifier: MIT
//
// The pixel grid: what a magnifying glass shows.
//
// Rule: each pixel becomes scale x scale screen pixels, of which the last row and the last column are dark.
// Of the scale - 1 columns left, stripe i of 0..2 has those from floor(i (scale - 1) / 3) up to the next
// stripe's first, and shows one component alone: red, green, blue or blue, green, red. Without stripes all
// show the pixel's colour. No light is added to make up for what is dark.
#pragma once

#include <hal/sim/effects/effects.hpp>

#include <span>
#include <vector>

namespace hal::sim {

/// The picture of width x height pixels enlarged.
[[nodiscard]] std::vector<std::uint8_t> enlarge(const PixelGrid& grid, int width, int height,
                                                std::span<const std::uint8_t> rgb);

}  // namespace hal::sim
