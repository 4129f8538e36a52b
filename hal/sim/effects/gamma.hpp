// SPDX-License-Identifier: MIT
//
// The panel's gamma: the light it makes of a level, as the desk's screen (sRGB) has to show it.
//
// Rule: encode((value / 255) ^ (hundredths / 100)), see light.hpp and power.hpp.
#pragma once

#include <hal/sim/effects/effects.hpp>
#include <hal/sim/effects/light.hpp>
#include <hal/sim/effects/power.hpp>

namespace hal::sim {

[[nodiscard]] inline std::uint8_t with_gamma(std::uint8_t value, const PanelGamma& gamma) {
  note_call(Effect::gamma);
  return encode(static_cast<Light>((power(value, 255, gamma.hundredths) + 128U) >> 8U));
}

}  // namespace hal::sim
