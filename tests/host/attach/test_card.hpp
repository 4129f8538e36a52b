// SPDX-License-Identifier: MIT
//
// The test card on any panel, for tests of what lies between.
#pragma once

#include <host/sim/program.hpp>

namespace host {

/// Runs so many frames of it, one every `interval` VBLANKs; `on_frame()` is called after each.
template <class OnFrame>
intaglio::Status run_test_card(hal::Panel& panel, int interval, std::uint32_t frames, OnFrame&& on_frame) {
  intaglio::present::FrameCounts counts;
  const auto go_on = [&](std::uint32_t frame, std::uint32_t) {
    on_frame(frame);
    return true;
  };
  return find_program("testcard")
      ->run(panel, {.pace = interval, .frames = frames, .on_frame = go_on}, counts);
}
inline intaglio::Status run_test_card(hal::Panel& panel, std::uint32_t frames) {
  return run_test_card(panel, 1, frames, [](std::uint32_t) {});
}

}  // namespace host
