// SPDX-License-Identifier: MIT
//
// The pixel grid: what a magnifying glass shows.
//
// Rule: each pixel becomes scale x scale screen pixels, of which the last row and the last column are dark.
// Of the columns left each of three stripes, side by side from the left, has floor((scale - 1) / 3), and
// shows one component alone: red, green, blue or blue, green, red; a rest of columns is dark, too, so that
// white is no colour. Without stripes all columns show the pixel's colour. No light is added to make up for
// what is dark.
#pragma once

#include <hal/sim/effects/effects.hpp>

#include <span>
#include <vector>

namespace hal::sim {

/// The picture of width x height pixels enlarged.
[[nodiscard]] std::vector<std::uint8_t> enlarge(const PixelGrid& grid, int width, int height,
                                                std::span<const std::uint8_t> rgb);

}  // namespace hal::sim
