// SPDX-License-Identifier: MIT
//
// A number for the frame that a scene drew last.
//
// Rule: FNV-1a over words of the picture, then over the palette's bytes.
#pragma once

#include <cstdint>
#include <firmware/lab/frames/scene.hpp>

namespace lab::frames {

[[nodiscard]] inline std::uint32_t digest(const Scene& scene) noexcept {
  std::uint32_t sum = 2'166'136'261U;
  const auto add = [&sum](std::uint32_t word) { sum = (sum ^ word) * 16'777'619U; };
  const std::uint8_t* const pixels = canvas().byte_at(0, 0);
  for (int i = 0; i < size.width * size.height; i += 4)
    add(pixels[i] | std::uint32_t{pixels[i + 1]} << 8U | std::uint32_t{pixels[i + 2]} << 16U |
        std::uint32_t{pixels[i + 3]} << 24U);
  for (const std::uint8_t byte : scene.palette()) add(byte);
  return sum;
}

}  // namespace lab::frames
