// SPDX-License-Identifier: MIT
#include <firmware/apps/primitives/primitives.hpp>
#include <firmware/lab/frames/programs.hpp>

namespace lab::frames {

Scene primitives() noexcept {
  return plain_scene<apps::primitives::Primitives<intaglio::image::Indexed8>>("primitives");
}

}  // namespace lab::frames
