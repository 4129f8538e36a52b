// SPDX-License-Identifier: MIT
//
// The family of dithering: even greys, as backgrounds are, slopes, as skies are, and any picture.
#pragma once

#include <intaglio/image/dither.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>

namespace lab {

struct Dither {
  static constexpr std::string_view name = "dither";
  static constexpr std::string_view title =
      "Dithering of 256 values to few levels, by the means of 8x8 pixels";
  static constexpr std::string_view per = "pixel";
  using Rungs = image::DitherFamily;
  using Default = image::DitherOrdered8;
  static constexpr Load loads[] = {{"even greys", 8}, {"slopes", 8}, {"any picture", 8}};
  static constexpr int side = 32;

  struct Input {
    std::int16_t first;   ///< The value in the corner.
    std::int16_t across;  ///< What a pixel to the right adds, in 1/64.
    std::int16_t down;    ///< What a row adds, in 1/64.
    std::uint16_t noise;  ///< The bits of noise that are added.
    std::int16_t levels;
  };
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i));
    const auto number = [&](int first, int last) {
      return static_cast<std::int16_t>(random.between(first, last));
    };
    const auto levels = static_cast<std::int16_t>(i % 2 == 0 ? 2 : 4);
    if (load == 0) return {number(0, 255), 0, 0, 0, levels};
    if (load == 1) return {number(100, 150), number(-90, 90), number(-90, 90), 0, levels};
    return {number(100, 150), 0, 0, 63, levels};
  }
  static constexpr int units(const Input& /*input*/) noexcept { return side * side; }

  /// The bound under a load: of even greys and slopes by trying all that the search for errors lists.
  template <class R>
  static constexpr number::Bound bound(int load) noexcept {
    const auto levels = [&](int even, int sloping) {
      return load == 0   ? number::Bound{even, number::Unit::palette_level}
             : load == 1 ? number::Bound{sloping, number::Unit::palette_level}
                         : R::bound;
    };
    if constexpr (std::same_as<R, image::DitherOrdered2>) return levels(125, 125);
    if constexpr (std::same_as<R, image::DitherOrdered4>) return levels(32, 112);
    if constexpr (std::same_as<R, image::DitherOrdered8>) return levels(8, 107);
    if constexpr (std::same_as<R, image::DitherThreeTap>) return levels(87, 87);
    if constexpr (std::same_as<R, image::DitherFourTap>) return levels(59, 80);
    if constexpr (std::same_as<R, image::DitherSerpentine>) return levels(55, 77);
    return levels(R::bound.thousandths, R::bound.thousandths);
  }

  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    static std::array<std::int16_t, side + 2> memory{};
    const auto target = canvas();
    typename R::Walk walk(0, side, in.levels, memory);
    std::uint32_t noise = 1;
    for (int y = 0; y < side; ++y) {
      const bool back = walk.begin_row(y);
      int x = back ? side - 1 : 0;
      for (int left = side; left > 0; --left, x += back ? -1 : 1) {
        noise = noise * 1'664'525U + 1'013'904'223U;
        const int value =
            in.first + (in.across * x + in.down * y) / 64 + static_cast<int>(noise >> 20U & in.noise);
        target.set(x, y, walk.next(static_cast<std::uint8_t>(value)));
      }
    }
    return 0;
  }
};

}  // namespace lab
