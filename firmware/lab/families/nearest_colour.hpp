// SPDX-License-Identifier: MIT
//
// The family of nearest colours, in the palettes that programs have: greys, a cube, colours of a picture.
#pragma once

#include <intaglio/image/nearest_rungs.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <firmware/lab/family.hpp>
#include <span>
#include <string_view>

namespace lab {

struct NearestColour {
  static constexpr std::string_view name = "nearest-colour";
  static constexpr std::string_view title = "The nearest entry of a palette";
  using Rungs = image::NearestFamily;
  using Default = image::NearestRgb;
  static constexpr Load loads[] = {{"16 greys", 128}, {"cube of 256", 32}, {"64 colours", 64}};

  /// An entry of a load's palette, and how many there are.
  static constexpr int entries(int load) noexcept { return load == 0 ? 16 : load == 1 ? 256 : 64; }
  static constexpr image::Rgb entry(int load, int i) noexcept {
    const auto code = [](int value) { return static_cast<std::uint8_t>(value); };
    if (load == 0) return {code(17 * i), code(17 * i), code(17 * i)};
    if (load == 1) return {code((i >> 5) * 255 / 7), code((i >> 2 & 7) * 255 / 7), code((i & 3) * 85)};
    Random random(static_cast<std::uint32_t>(i));
    return {code(random.between(0, 255)), code(random.between(0, 255)), code(random.between(0, 255))};
  }
  template <class R, int load>
  static constexpr auto places = [] {
    std::array<image::ColourPlace, static_cast<std::size_t>(entries(load))> made{};
    for (int i = 0; i < entries(load); ++i) made[static_cast<std::size_t>(i)] = R::place(entry(load, i));
    return made;
  }();
  template <class R>
  static constexpr std::span<const image::ColourPlace> palette(int load) noexcept {
    if (load == 0) return places<R, 0>;
    if (load == 1) return places<R, 1>;
    return places<R, 2>;
  }

  /// In this palette, over all 2^24 colours; the rungs' own bounds are for any palette.
  template <class R>
  static constexpr number::Bound bound(int load) noexcept {
    const auto cie76 = [load](int greys, int cube, int colours) {
      return number::Bound{load == 0 ? greys : load == 1 ? cube : colours, number::Unit::cie76};
    };
    if constexpr (std::same_as<R, image::NearestRgb>) return cie76(11'100, 30'500, 65'700);
    if constexpr (std::same_as<R, image::NearestWeighted>) return cie76(7'400, 30'500, 51'500);
    if constexpr (std::same_as<R, image::NearestLuv>) return cie76(46, 40'000, 43'600);
    return R::bound;
  }

  struct Input {
    image::Rgb colour;
    std::uint8_t load;
  };
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(1000 + i));
    const auto code = [&] { return static_cast<std::uint8_t>(random.between(0, 255)); };
    return {{code(), code(), code()}, static_cast<std::uint8_t>(load)};
  }
  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    return R{}(palette<R>(in.load), in.colour);
  }
};

}  // namespace lab
