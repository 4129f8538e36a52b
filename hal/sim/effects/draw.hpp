// SPDX-License-Identifier: MIT
//
// Drawing time: a frame takes the program its least time and up to `spread` more, evenly spread, a function
// of the frame's number alone.
#pragma once

#include <hal/sim/effects/effects.hpp>
#include <hal/sim/effects/noise.hpp>

namespace hal::sim {

[[nodiscard]] inline Nanoseconds draw_time(const DrawTime& draw, std::uint32_t frame) {
  note_call(Effect::draw);
  return draw.least + noise_up_to(draw.spread, std::uint64_t{frame} ^ 0xD3A7'0000'0000U);
}

}  // namespace hal::sim
