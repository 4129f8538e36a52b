// SPDX-License-Identifier: MIT
//
// A swap chain on a simulated panel in virtual time, for tests of what programs show.
#pragma once

#include <hal/sim/panel.hpp>
#include <intaglio/present/swap_chain.hpp>

namespace scan_out {

template <intaglio::image::PixelFormat F = intaglio::image::Indexed8>
struct Stage {
  explicit Stage(const hal::sim::PanelSpec& spec, const intaglio::present::Pace& pace = {})
      : panel(spec, clock), chain(panel, pace) {}

  hal::sim::VirtualClock clock;
  hal::sim::Panel panel;
  intaglio::present::SwapChain<F> chain;
};

}  // namespace scan_out
