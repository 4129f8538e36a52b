// SPDX-License-Identifier: MIT
#include <firmware/apps/gauges/gauges.hpp>
#include <firmware/lab/frames/programs.hpp>

namespace lab::frames {

Program gauges_as_it_is() noexcept {
  return Stage<apps::gauges::TunedGauges<intaglio::image::Indexed8, apps::gauges::DefaultKnobs>>::program();
}

}  // namespace lab::frames
