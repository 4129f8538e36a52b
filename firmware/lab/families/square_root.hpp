// SPDX-License-Identifier: MIT
//
// The family of square roots: of numbers of any length alike, and of squared distances on small screens and
// within small shapes.
#pragma once

#include <intaglio/number/root_rungs.hpp>

#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>

namespace lab {

struct SquareRoot {
  static constexpr std::string_view name = "square-root";
  static constexpr std::string_view title = "Square root of 32 bits, floor(sqrt(n))";
  using Rungs = number::RootFamily;
  using Default = number::RootBitwise;
  static constexpr Load loads[] = {{"any number of bits", 256}, {"below 65536", 256}, {"below 1024", 256}};

  using Input = std::uint32_t;
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i));
    const std::uint32_t bits = random.bits();
    if (load == 0) return bits >> (static_cast<unsigned>(i) & 31U);
    return bits >> (load == 1 ? 16U : 22U);
  }
  template <class R>
  static std::uint32_t run(Input n) noexcept {
    return R{}(n);
  }
};

}  // namespace lab
