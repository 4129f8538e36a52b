// SPDX-License-Identifier: MIT
//
// Shows the badge on a simulated panel, and checks that it is on display.
#include "badge.hpp"

#include <hal/sim/panel.hpp>
#include <intaglio/image/format.hpp>
#include <intaglio/present/swap_chain.hpp>
#include <intaglio/raster/solid.hpp>

#include <cstdint>
#include <utility>

int main() {
  hal::sim::VirtualClock clock;
  hal::sim::Panel panel(hal::sim::paletted(16, 8, 8), clock);
  intaglio::present::SwapChain<intaglio::image::Indexed8> screen(panel);
  auto frame = screen.begin();
  if (!frame.ok() || !draw_badge(intaglio::raster::Solid(frame.value().surface(), 1)).ok()) return 1;
  constexpr std::uint8_t palette[]{0, 0, 0, 255, 128, 0};
  if (!screen.present(std::move(frame).value(), palette).ok() || !screen.wait_until_shown().ok()) return 2;
  const hal::sim::Picture shown = panel.displayed();
  const std::size_t centre = 3 * 16 + 3;
  return shown.indices[centre] == 1 && shown.rgb[3 * centre] == 255 ? 0 : 3;
}
