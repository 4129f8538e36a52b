// SPDX-License-Identifier: MIT
//
// The family of blends of 8 bits: of two values, and of one with nothing, which is a product.
#pragma once

#include <intaglio/number/blend.hpp>

#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>

namespace lab {

struct Blend8 {
  static constexpr std::string_view name = "blend8";
  static constexpr std::string_view title = "Blend of two 8-bit values, (from*(255 - a) + to*a) / 255";
  using Rungs = number::Blend8Family;
  using Default = number::Blend8TwoShifts;
  static constexpr Load loads[] = {{"two values", 256}, {"one value and nothing", 256}};

  struct Input {
    std::uint8_t from;
    std::uint8_t to;
    std::uint8_t alpha;
  };
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i));
    const auto value = [&] { return static_cast<std::uint8_t>(random.between(0, 255)); };
    const std::uint8_t to = value();
    const std::uint8_t alpha = value();
    return {load == 0 ? value() : std::uint8_t{0}, to, alpha};
  }
  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    return R{}(in.from, in.to, in.alpha);
  }
};

}  // namespace lab
