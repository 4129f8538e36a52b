// SPDX-License-Identifier: MIT
//
// Draws the badge in memory, as firmware would before sending it to a panel.
#include "badge.hpp"

#include <intaglio/image/format.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/raster/solid.hpp>

#include <array>
#include <cstdint>

int main() {
  using Surface = intaglio::image::Surface<intaglio::image::Indexed4>;
  static std::array<std::uint8_t, 4 * 7> memory;
  const auto surface = Surface::over(memory, {7, 7});
  if (!surface.ok()) return 1;
  return draw_badge(intaglio::raster::Solid(surface.value(), 1)).ok() ? 0 : 2;
}
