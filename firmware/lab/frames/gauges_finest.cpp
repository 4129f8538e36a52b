// SPDX-License-Identifier: MIT
#include <firmware/apps/gauges/gauges.hpp>
#include <firmware/lab/frames/programs.hpp>

namespace lab::frames {

Program gauges_finest() noexcept {
  return Stage<apps::gauges::TunedGauges<intaglio::image::Indexed8, apps::gauges::FinestKnobs>>::program();
}

}  // namespace lab::frames
