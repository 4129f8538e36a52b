// SPDX-License-Identifier: MIT
#include <hal/sim/effects/grid.hpp>

namespace hal::sim {

std::vector<std::uint8_t> enlarge(const PixelGrid& grid, int width, int height,
                                  std::span<const std::uint8_t> rgb) {
  note_call(Effect::grid);
  const auto scale = static_cast<std::size_t>(grid.scale);
  const auto columns = static_cast<std::size_t>(width);
  const std::size_t row = 3U * columns * scale;
  std::vector<std::uint8_t> large(row * scale * static_cast<std::size_t>(height));
  // Which component a column of a cell shows; 3: all of them, 4: none.
  std::vector<std::size_t> shown(scale - 1U, grid.stripes == Stripes::none ? 3U : 4U);
  if (grid.stripes != Stripes::none) {
    const std::size_t wide = (scale - 1U) / 3U;
    for (std::size_t x = 0; x < 3U * wide; ++x)
      shown[x] = grid.stripes == Stripes::rgb ? x / wide : 2U - x / wide;
  }
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
    for (std::size_t x = 0; x < columns; ++x) {
      const auto pixel = rgb.subspan(3U * (y * columns + x), 3);
      for (std::size_t below = 0; below + 1U < scale; ++below)
        for (std::size_t right = 0; right + 1U < scale; ++right)
          for (std::size_t component = 0; component < 3; ++component)
            if (shown[right] == 3U || shown[right] == component)
              large[(y * scale + below) * row + 3U * (x * scale + right) + component] = pixel[component];
    }
  }
  return large;
}

}  // namespace hal::sim
