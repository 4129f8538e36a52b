// SPDX-License-Identifier: MIT
//
// The family of reciprocal square roots: of numbers of any length alike, and of the squared lengths of
// vectors in 2^-14, as normals are after interpolation.
#pragma once

#include <intaglio/number/reciprocal_root.hpp>

#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>

namespace lab {

struct ReciprocalRoot {
  static constexpr std::string_view name = "reciprocal-root";
  static constexpr std::string_view title = "Reciprocal square root of 32 bits, floor(2^31 / sqrt(n))";
  using Rungs = number::ReciprocalRootFamily;
  using Default = number::ReciprocalRootNewtonExact;
  static constexpr Load loads[] = {{"any number of bits", 256}, {"squares of 0.7 to 1 in 2^-14", 256}};

  using Input = std::uint32_t;
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i));
    if (load == 0) return random.bits() >> (static_cast<unsigned>(i) & 31U) | 1U;
    return static_cast<Input>(random.between(1 << 27, 1 << 28));
  }
  template <class R>
  static std::uint32_t run(Input n) noexcept {
    return R{}(n);
  }
};

}  // namespace lab
