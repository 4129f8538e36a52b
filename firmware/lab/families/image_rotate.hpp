// SPDX-License-Identifier: MIT
//
// The family of turned pictures of values.
#pragma once

#include <intaglio/image/rotate_rungs.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>

namespace lab {

struct ImageRotate {
  static constexpr std::string_view name = "image-rotate";
  static constexpr std::string_view title =
      "Turning a picture of values: how far off the places are that its pixels show";
  static constexpr std::string_view per = "pixel";
  using Rungs = image::RotateFamily;
  using Default = image::RotateNearest;
  static constexpr Load loads[] = {{"40x30 by any angle", 4}};

  static constexpr int columns = 40;
  static constexpr int rows = 30;
  static constexpr std::array<std::uint8_t, std::size_t{1200}> values = [] {
    std::array<std::uint8_t, std::size_t{1200}> made{};
    Random random(7);
    for (auto& value : made) value = random.between(0, 1) == 0 ? 0 : 255;
    return made;
  }();

  /// Within 25 pixels of the pivot the sine moves a place by at most 0.0014, by shears 0.0026.
  template <class R>
  static constexpr number::Bound bound(int /*load*/) noexcept {
    if constexpr (std::same_as<R, image::RotateNearest>) return number::pixels(710);
    if constexpr (std::same_as<R, image::RotateThreeShear>) return number::pixels(1'122);
    return number::pixels(8);
  }
  /// The middle of the picture lies on the same place of the canvas at every angle.
  static constexpr image::ThreeShear turned(int steps) noexcept {
    return {
        {160 * 256, 120 * 256}, {128 * (columns - 1), 128 * (rows - 1)}, number::Angle::from_steps(steps)};
  }

  using Input = number::Angle;
  static Input input(int /*load*/, int i) noexcept { return Input::from_steps(5461 + 14'000 * i); }
  static constexpr int units(const Input& /*input*/) noexcept { return columns * rows; }

  template <class R>
  static std::uint32_t run(const Input& angle) noexcept {
    const auto source = image::Picture<image::Indexed8>::over(values, {columns, rows});
    image::ThreeShear turn = turned(0);
    turn.angle = angle;
    return R{}(canvas(), turn, source.value()).ok() ? 1U : 0U;
  }
};

}  // namespace lab
