// SPDX-License-Identifier: MIT
//
// The family of sines: of any angle, and of the small ones that a slow turn or a swaying pointer has.
#pragma once

#include <intaglio/number/angle.hpp>
#include <intaglio/number/sine_rungs.hpp>

#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>

namespace lab {

struct Sine {
  static constexpr std::string_view name = "sine";
  static constexpr std::string_view title = "Sine of a binary angle, in 2^-15";
  using Rungs = number::SineFamily;
  using Default = number::SineTable256Linear;
  static constexpr Load loads[] = {{"any angle", 256}, {"angles below 6 degrees", 256}};

  using Input = number::Angle;
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i));
    return Input::from_steps(load == 0 ? random.between(0, 65535) : random.between(-1092, 1092));
  }
  template <class R>
  static std::uint32_t run(Input angle) noexcept {
    return static_cast<std::uint32_t>(R{}(angle).raw());
  }
};

}  // namespace lab
