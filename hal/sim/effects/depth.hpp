// SPDX-License-Identifier: MIT
//
// Colour depth: the bits of a colour that reach the glass.
//
// Rule: a component keeps its b upper bits; level v of 2^b - 1 shows as round(255 v / (2^b - 1)), so that
// black and white stay what they are.
#pragma once

#include <hal/sim/effects/effects.hpp>

namespace hal::sim {

/// The component that is shown for `value` where `bits` (1..8) reach the glass.
[[nodiscard]] inline std::uint8_t at_depth(std::uint8_t value, int bits) {
  note_call(Effect::depth);
  const int most = (1 << bits) - 1;
  return static_cast<std::uint8_t>(((value >> (8 - bits)) * 510 + most) / (2 * most));
}

}  // namespace hal::sim
