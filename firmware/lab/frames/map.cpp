// SPDX-License-Identifier: MIT
#include <firmware/apps/map/map.hpp>
#include <firmware/lab/frames/programs.hpp>

namespace lab::frames {

Scene map() noexcept { return plain_scene<apps::map::Map<intaglio::image::Indexed8>>("map"); }

}  // namespace lab::frames
