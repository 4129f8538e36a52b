// SPDX-License-Identifier: MIT
#include <host/sim/programs.hpp>

#include <firmware/apps/map/map.hpp>

namespace host {

constexpr Program map_program{"map", "the world's land: panning, zooming, day and night",
                              run_on_panel<apps::map::Map>};

}  // namespace host
