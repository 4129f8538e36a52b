// SPDX-License-Identifier: MIT
//
// Power-on garbage: memory that no one has written holds noise, the same for the same seed.
#pragma once

#include <hal/sim/effects/effects.hpp>
#include <hal/sim/effects/noise.hpp>

#include <span>

namespace hal::sim {

/// Fills memory number `part` of a panel.
inline void fill_with_garbage(const PowerOnGarbage& garbage, std::uint64_t part,
                              std::span<std::uint8_t> memory) {
  note_call(Effect::garbage);
  for (std::size_t i = 0; i < memory.size(); ++i)
    memory[i] = static_cast<std::uint8_t>(noise(noise(garbage.seed ^ part << 32U) + i));
}

}  // namespace hal::sim
