// SPDX-License-Identifier: MIT
//
// The family of stretched pictures of values.
#pragma once

#include <intaglio/image/scale_rungs.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>

namespace lab {

struct ImageScale {
  static constexpr std::string_view name = "image-scale";
  static constexpr std::string_view title = "Stretching a picture of values, beside bilinear interpolation";
  static constexpr std::string_view per = "pixel";
  using Rungs = image::ScaleFamily;
  using Default = image::ScaleNearest;
  static constexpr Load loads[] = {{"24x16 to 60x40", 4}, {"24x16 to 150x101", 1}};

  static constexpr int columns = 24;
  static constexpr int rows = 16;
  static constexpr std::array<std::uint8_t, static_cast<std::size_t>(columns* rows)> values = [] {
    std::array<std::uint8_t, static_cast<std::size_t>(columns * rows)> made{};
    Random random(7);
    for (auto& value : made) value = random.between(0, 1) == 0 ? 0 : 255;
    return made;
  }();

  struct Input {
    std::int16_t x;
    std::int16_t width;
    std::int16_t height;
  };
  static Input input(int load, int i) noexcept {
    if (load == 0) return {static_cast<std::int16_t>(5 + 70 * i), 60, 40};
    return {9, 150, 101};
  }
  static constexpr int units(const Input& in) noexcept { return in.width * in.height; }

  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    const auto source = image::Picture<image::Indexed8>::over(values, {columns, rows});
    return R{}(canvas(), {in.x, 4, in.width, in.height}, source.value()).ok() ? 1U : 0U;
  }
};

}  // namespace lab
