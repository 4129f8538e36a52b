// SPDX-License-Identifier: MIT
//
// The family of vectors brought to length one: any, and normals whose length interpolation has shortened.
#pragma once

#include <intaglio/number/unit_vector.hpp>

#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>

namespace lab {

struct Normalise {
  static constexpr std::string_view name = "normalise";
  static constexpr std::string_view title = "Vector of three components brought to length one, in 2^-15";
  using Rungs = number::NormaliseFamily;
  using Default = number::UnitNewtonExact;
  static constexpr Load loads[] = {{"any vector", 128}, {"0.7 to 1 long in 2^-14", 128}};

  using Input = number::Components;
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i));
    Input vector{};
    if (load == 0) {
      for (auto& component : vector) component = static_cast<std::int16_t>(random.between(-32767, 32767));
      return vector;
    }
    std::int32_t square = 0;
    while (square < 1 << 27 || square > 1 << 28) {
      square = 0;
      for (auto& component : vector) {
        component = static_cast<std::int16_t>(random.between(-16384, 16384));
        square += component * component;
      }
    }
    return vector;
  }
  template <class R>
  static std::uint32_t run(const Input& vector) noexcept {
    const number::UnitVector unit = R{}(vector);
    return static_cast<std::uint32_t>(unit[0].raw() + 3 * unit[1].raw() + 5 * unit[2].raw());
  }
};

}  // namespace lab
