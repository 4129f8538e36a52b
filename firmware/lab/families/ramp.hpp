// SPDX-License-Identifier: MIT
//
// The family of ramps: a ramp of greys as a panel of 4 bits has, and mixtures of any two codes.
#pragma once

#include <intaglio/image/mix_rungs.hpp>

#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>

namespace lab {

struct Ramp {
  static constexpr std::string_view name = "ramp";
  static constexpr std::string_view title = "Mixing two sRGB codes, beside the mixture of light";
  using Rungs = image::MixFamily;
  using Default = image::MixTable16;
  static constexpr Load loads[] = {{"16 greys, black to white", 256}, {"any codes and parts", 256}};

  struct Input {
    std::uint8_t from;
    std::uint8_t to;
    std::int16_t part;
    std::int16_t whole;
  };
  static Input input(int load, int i) noexcept {
    if (load == 0) return {0, 255, static_cast<std::int16_t>(i % 16), 15};
    Random random(static_cast<std::uint32_t>(i));
    const auto whole = static_cast<std::int16_t>(random.between(1, 255));
    return {static_cast<std::uint8_t>(random.between(0, 255)),
            static_cast<std::uint8_t>(random.between(0, 255)),
            static_cast<std::int16_t>(random.between(0, whole)), whole};
  }
  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    return R{}(in.from, in.to, in.part, in.whole);
  }
};

}  // namespace lab
