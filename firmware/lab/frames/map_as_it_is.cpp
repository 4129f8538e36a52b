// SPDX-License-Identifier: MIT
#include <firmware/apps/map/map.hpp>
#include <firmware/lab/frames/programs.hpp>

namespace lab::frames {

Program map_as_it_is() noexcept {
  return Stage<apps::map::TunedMap<intaglio::image::Indexed8, apps::map::DefaultKnobs>>::program();
}

}  // namespace lab::frames
