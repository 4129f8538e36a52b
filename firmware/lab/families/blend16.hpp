// SPDX-License-Identifier: MIT
//
// The family of blends of 16 bits: of two values, and of one with nothing, which is a product.
#pragma once

#include <intaglio/number/blend.hpp>

#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>

namespace lab {

struct Blend16 {
  static constexpr std::string_view name = "blend16";
  static constexpr std::string_view title = "Blend of two 16-bit values, (from*(65535 - a) + to*a) / 65535";
  using Rungs = number::Blend16Family;
  using Default = number::Blend16TwoShifts;
  static constexpr Load loads[] = {{"two values", 256}, {"one value and nothing", 256}};

  struct Input {
    std::uint16_t from;
    std::uint16_t to;
    std::uint16_t alpha;
  };
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i));
    const auto value = [&] { return static_cast<std::uint16_t>(random.between(0, 65535)); };
    const std::uint16_t to = value();
    const std::uint16_t alpha = value();
    return {load == 0 ? value() : std::uint16_t{0}, to, alpha};
  }
  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    return R{}(in.from, in.to, in.alpha);
  }
};

}  // namespace lab
