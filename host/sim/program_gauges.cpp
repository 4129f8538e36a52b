// SPDX-License-Identifier: MIT
#include <host/sim/programs.hpp>

#include <firmware/apps/gauges/gauges.hpp>

namespace host {

constexpr Program gauges_program{"gauges", "an instrument cluster: dials, digits, bars, warning lights",
                                 run_on_panel<apps::gauges::Gauges>};

}  // namespace host
