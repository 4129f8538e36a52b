// SPDX-License-Identifier: MIT
//
// The family of reciprocals: of any divisor, and of the small ones that depths and lengths near by are.
#pragma once

#include <intaglio/number/reciprocal.hpp>

#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>

namespace lab {

struct Reciprocal {
  static constexpr std::string_view name = "reciprocal";
  static constexpr std::string_view title = "Reciprocal of 16 bits, floor(2^31 / d)";
  using Rungs = number::ReciprocalFamily;
  using Default = number::ReciprocalDivision;
  static constexpr Load loads[] = {{"any divisor", 256}, {"divisors below 1024", 256}};

  using Input = std::uint16_t;
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i));
    return static_cast<Input>(random.between(1, load == 0 ? 65535 : 1023));
  }
  template <class R>
  static std::uint32_t run(Input divisor) noexcept {
    return R{}(divisor);
  }
};

}  // namespace lab
