// SPDX-License-Identifier: MIT
//
// The family of stretched and shrunk pictures of values. The source lies below on the canvas that is drawn
// on.
#pragma once

#include <intaglio/image/scale_rungs.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <firmware/lab/family.hpp>
#include <span>
#include <string_view>

namespace lab {

struct ImageScale {
  static constexpr std::string_view name = "image-scale";
  static constexpr std::string_view title =
      "A picture of values, enlarged beside bilinear interpolation, shrunk beside the mean of each pixel's "
      "box";
  static constexpr std::string_view per = "pixel";
  using Rungs = image::ScaleFamily;
  using Default = image::ScaleNearest;
  static constexpr Load loads[] = {
      {"24x16 to 60x40", 4}, {"24x16 to 150x101", 1}, {"60x40 to 24x16", 4}, {"168x112 to 24x16", 1}};
  /// Which truth a load is held against.
  static constexpr bool shrinks(int load) noexcept { return load >= 2; }

  struct Input {
    std::int16_t x;
    std::int16_t width;
    std::int16_t height;
    std::int16_t columns;  ///< Of the source.
    std::int16_t rows;
  };
  static Input input(int load, int i) noexcept {
    constexpr std::array<Input, 4> inputs{
        {{5, 60, 40, 24, 16}, {9, 150, 101, 24, 16}, {5, 24, 16, 60, 40}, {9, 24, 16, 168, 112}}};
    Input in = inputs[static_cast<std::size_t>(load)];
    in.x = static_cast<std::int16_t>(in.x + 70 * i);
    return in;
  }
  static constexpr int units(const Input& in) noexcept { return in.width * in.height; }

  /// The bound under a load. Of pictures shrunk 5:2, the bilinear ones show a pixel for 9/16 and two beside
  /// it for 3/16 each, which the mean has for 4/25: 183/400 of 255 may be different, and what `bound` says.
  template <class R>
  static constexpr number::Bound bound(int load) noexcept {
    if (!shrinks(load)) return R::bound;
    constexpr bool bilinear =
        std::same_as<R, image::ScaleBilinear4> || std::same_as<R, image::ScaleBilinear8>;
    if (bilinear && load == 2) return {116'663 + R::bound.thousandths, R::bound.unit};
    return R::shrinking_bound;
  }

  /// Memory for the largest source.
  static std::span<std::uint8_t> pixels() noexcept {
    static std::array<std::uint8_t, std::size_t{168 * 112}> memory{};
    return memory;
  }
  static void prepare(int load) noexcept {
    const Input in = input(load, 0);
    Random random(7);
    for (auto& pixel : pixels().first(static_cast<std::size_t>(in.columns * in.rows)))
      pixel = random.between(0, 1) == 0 ? 0 : 255;
  }

  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    const auto source = image::Picture<image::Indexed8>::over(pixels(), {in.columns, in.rows});
    return R{}(canvas(), {in.x, 4, in.width, in.height}, source.value()).ok() ? 1U : 0U;
  }
};

}  // namespace lab
