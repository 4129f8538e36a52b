// SPDX-License-Identifier: MIT
//
// Dead and stuck pixels: they show one colour whatever they are sent.
#pragma once

#include <hal/sim/effects/effects.hpp>

#include <algorithm>
#include <span>

namespace hal::sim {

/// Puts the pixels into a picture of `width` columns; those outside of it must not be among them.
inline void put_dead_pixels(std::span<const DeadPixel> dead, int width, std::span<std::uint8_t> rgb) {
  note_call(Effect::dead);
  for (const DeadPixel& pixel : dead) {
    const std::size_t place = static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(width) +
                              static_cast<std::size_t>(pixel.x);
    std::ranges::copy(pixel.colour, rgb.subspan(3U * place).begin());
  }
}

}  // namespace hal::sim
