// SPDX-License-Identifier: MIT
//
// The family of arc tangents: of directions of any length, and of those on a small screen.
#pragma once

#include <intaglio/number/arc_tangent.hpp>

#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>

namespace lab {

struct ArcTangent {
  static constexpr std::string_view name = "arc-tangent";
  static constexpr std::string_view title = "Angle of a direction, in 1/65536 turn";
  using Rungs = number::ArcTangentFamily;
  using Default = number::ArcTangentTable128Linear;
  static constexpr Load loads[] = {{"any length", 256}, {"on a screen of 640x480", 256}};

  struct Input {
    std::int32_t x;
    std::int32_t y;
  };
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i));
    if (load == 1) {
      const int x = random.between(-320, 319);
      return {x, random.between(-240, 239)};
    }
    // Both of 32 bits down to 4, sign included.
    const int shift = i % 29;
    const auto x = static_cast<std::int32_t>(random.bits()) >> shift;
    return {x, static_cast<std::int32_t>(random.bits()) >> shift};
  }
  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    return static_cast<std::uint32_t>(R{}(in.x, in.y).steps());
  }
};

}  // namespace lab
