// SPDX-License-Identifier: MIT
#include <firmware/apps/testcard/testcard.hpp>
#include <firmware/lab/frames/programs.hpp>

namespace lab::frames {

Scene testcard() noexcept {
  return plain_scene<apps::testcard::TestCard<intaglio::image::Indexed8>>("testcard");
}

}  // namespace lab::frames
