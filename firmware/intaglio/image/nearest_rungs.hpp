// SPDX-License-Identifier: MIT
//
// Other ways to find the nearest entry of a palette: rungs beside the one of nearest.hpp.
//
// Rule: a rung gives each colour a place in space, and the nearest entry is the one whose place has the least
// squared distance from the colour's; of several as near, the lowest index. A palette's places are made once.
// The rungs:
// - `NearestRgb`: the sRGB codes, which is `nearest_entry`;
// - `NearestWeighted`: the codes, squares of differences counting 2, 4 and 3 times;
// - `NearestLuv`: CIE 1976 L*u*v* (D65) in 1/64: lightness, and u'v' times 13 times lightness;
// - `NearestLab`: CIE 1976 L*a*b* (D65) in 1/64.
//
// Error: by how much the chosen entry is further from the colour than the best one, in CIE76 (the distance in
// L*a*b* of real numbers). Bounds hold for any palette. Places of `NearestLab` are off by at most 0.06 (all
// 2^24 colours), so that is at most four times as much for it. The others may choose any entry but the best,
// so theirs is the distance of the colours furthest apart, green and blue. That isn't far from the truth:
// palettes of two entries are known where they lose 166, 146 and 96 (tests/image/nearest.cpp). In palettes
// that programs have they lose less: the lab has 16 greys, 256 of a cube and 64 anywhere.
// Bit budget: places differ by less than 2^14.1, so a squared distance has 30 bits; weighted codes have 20.
// Textbook: section 1.4, on palettes. Worst known inputs: saturated blues, which L*a*b* puts far apart.
#pragma once

#include <intaglio/image/palette.hpp>
#include <intaglio/image/srgb.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/status.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace intaglio::image {

/// Where a colour lies in the space of a rung.
struct ColourPlace {
  std::int16_t x = 0;
  std::int16_t y = 0;
  std::int16_t z = 0;
};

/// A way to find the nearest of the places of a palette's entries: `rung(entries, colour)` is its index, 0 if
/// there is none. At most 256 entries.
template <class R>
concept NearestRung = number::Rung<R> && requires(const R& rung, std::span<const ColourPlace> entries) {
  { R::place(Rgb{}) } -> std::same_as<ColourPlace>;
  { rung(entries, Rgb{}) } -> std::same_as<std::uint8_t>;
};

namespace detail {

/// The search that all rungs share.
template <class R, int x_weight = 1, int y_weight = 1, int z_weight = 1>
struct NearestPlace {
  [[nodiscard]] constexpr std::uint8_t operator()(std::span<const ColourPlace> entries,
                                                  Rgb colour) const noexcept {
    const ColourPlace place = R::place(colour);
    int least = 0x7FFF'FFFF;
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < entries.size() && i < 256; ++i) {
      const int x = entries[i].x - place.x;
      const int y = entries[i].y - place.y;
      const int z = entries[i].z - place.z;
      const int distance = x_weight * x * x + y_weight * y * y + z_weight * z * z;
      if (distance >= least) continue;
      least = distance;
      nearest = i;
    }
    return static_cast<std::uint8_t>(nearest);
  }
};

/// Between green and blue; no two of all colours are further apart.
inline constexpr number::Bound furthest_colours{258'683, number::Unit::cie76};

/// Light through one row of a matrix in 2^-16.
[[nodiscard]] constexpr std::uint32_t light_through(Rgb colour, std::uint32_t r, std::uint32_t g,
                                                    std::uint32_t b) noexcept {
  return linear_of(colour.r) * r + linear_of(colour.g) * g + linear_of(colour.b) * b;
}

/// The f of L*a*b* of a part t of white, in 2^-16: the cube root, and a line for the dark. t in 2^-32.
[[nodiscard]] constexpr int lab_root(std::uint32_t t) noexcept {
  // (6/29)^3; below it (29/6)^2 t / 3 + 4/29.
  if (t < 38'038'000U) return static_cast<int>(((t >> 8U) * 1'993U + 32'768U) >> 16U) + 9'039;
  const std::uint64_t cube = std::uint64_t{t} << 16U;
  std::uint32_t root = 0;
  for (std::uint32_t bit = 1U << 15U; bit != 0; bit >>= 1U) {
    const std::uint32_t r = root | bit;
    if (std::uint64_t{r} * r * r <= cube) root = r;
  }
  return static_cast<int>(root);
}

/// value * 2^-16, to nearest.
[[nodiscard]] constexpr std::int16_t over_65536(int value) noexcept {
  return static_cast<std::int16_t>((value + 32'768) >> 16);
}

/// L* in 1/64 of the root of its light.
[[nodiscard]] constexpr int lightness(int root) noexcept { return over_65536(116 * 64 * root) - 16 * 64; }

/// u' in 2^-14 and v' in 2^-12 of a colour; of black those of white.
struct Chromaticity {
  int u;
  int v;
};
[[nodiscard]] constexpr Chromaticity chromaticity(Rgb colour) noexcept {
  if (colour == Rgb{}) colour = {255, 255, 255};
  const std::uint32_t x = light_through(colour, 27'031, 23'434, 11'825) >> 16U;
  const std::uint32_t y = light_through(colour, 13'938, 46'868, 4'730) >> 16U;
  // Half of it, for all of white's has more than 16 bits.
  const std::uint32_t half_z = light_through(colour, 634, 3'906, 31'140) >> 16U;
  const std::uint32_t sum = x + 15U * y + 6U * half_z;
  if (sum == 0) return {0, 0};
  return {static_cast<int>(x * 65'536U / sum), static_cast<int>(y * 36'864U / sum)};
}

}  // namespace detail

/// By sRGB codes; the default.
struct NearestRgb : detail::NearestPlace<NearestRgb> {
  static constexpr number::Bound bound = detail::furthest_colours;
  [[nodiscard]] static constexpr ColourPlace place(Rgb colour) noexcept {
    return {colour.r, colour.g, colour.b};
  }
};

/// By sRGB codes, green counting most.
struct NearestWeighted : detail::NearestPlace<NearestWeighted, 2, 4, 3> {
  static constexpr number::Bound bound = detail::furthest_colours;
  [[nodiscard]] static constexpr ColourPlace place(Rgb colour) noexcept { return NearestRgb::place(colour); }
};

/// By L*u*v*.
struct NearestLuv : detail::NearestPlace<NearestLuv> {
  static constexpr number::Bound bound = detail::furthest_colours;
  [[nodiscard]] static constexpr ColourPlace place(Rgb colour) noexcept {
    constexpr detail::Chromaticity white = detail::chromaticity({255, 255, 255});
    const int lightness =
        detail::lightness(detail::lab_root(detail::light_through(colour, 13'938, 46'868, 4'730)));
    const detail::Chromaticity tint = detail::chromaticity(colour);
    return {static_cast<std::int16_t>(lightness),
            static_cast<std::int16_t>((13 * lightness * (tint.u - white.u)) >> 14),
            static_cast<std::int16_t>((13 * lightness * (tint.v - white.v)) >> 12)};
  }
};

/// By L*a*b*.
struct NearestLab : detail::NearestPlace<NearestLab> {
  static constexpr number::Bound bound{240, number::Unit::cie76};
  static constexpr std::string_view slack =
      "colour, chosen and best entry all off their worst in the worst way";
  [[nodiscard]] static constexpr ColourPlace place(Rgb colour) noexcept {
    const int x = detail::lab_root(detail::light_through(colour, 28'439, 24'655, 12'442));
    const int y = detail::lab_root(detail::light_through(colour, 13'938, 46'868, 4'730));
    const int z = detail::lab_root(detail::light_through(colour, 1'164, 7'174, 57'198));
    return {static_cast<std::int16_t>(detail::lightness(y)), detail::over_65536(500 * 64 * (x - y)),
            detail::over_65536(200 * 64 * (y - z))};
  }
};

/// The rungs of nearest entries, cheapest first.
using NearestFamily = number::Family<NearestRgb, NearestWeighted, NearestLuv, NearestLab>;

/// The places of a palette's entries (RGBRGB..., as `Palette::bytes()`) for a rung. Errors: palette (not 1 ..
/// 256 whole entries: malformed), table (fewer places than entries: too_small, `needed()`); nothing is
/// written then.
template <NearestRung Rung>
constexpr Status make_places(std::span<ColourPlace> places, std::span<const std::uint8_t> palette) noexcept {
  if (palette.empty() || palette.size() % 3 != 0 || palette.size() > 768)
    return {Error::malformed, Argument::palette};
  const std::size_t entries = palette.size() / 3;
  if (places.size() < entries)
    return {Error::too_small, Argument::table, static_cast<std::uint32_t>(entries)};
  for (std::size_t i = 0; i < entries; ++i)
    places[i] = Rung::place({palette[3 * i], palette[3 * i + 1], palette[3 * i + 2]});
  return {};
}

}  // namespace intaglio::image
