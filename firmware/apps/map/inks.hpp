// SPDX-License-Identifier: MIT
//
// The colours of the map, by importance (see `apps::Theme`), by day and by night.
#pragma once

#include <array>
#include <cstddef>
#include <firmware/apps/theme.hpp>

namespace apps::map::ink {

inline constexpr int ocean = 0;
inline constexpr int land = 1;
inline constexpr int text = 2;
inline constexpr int graticule = 3;
inline constexpr int coast = 4;
inline constexpr int city = 5;
inline constexpr int panel = 6;
inline constexpr int note = 7;
inline constexpr int shallow = 8;
inline constexpr int shade = 9;
inline constexpr int aim = 10;
inline constexpr int oceans = 16;  ///< By latitude, north to south.
inline constexpr int ocean_steps = 48;
inline constexpr int lands = oceans + ocean_steps;  ///< By latitude, north to south.
inline constexpr int land_steps = 176;
inline constexpr int count = lands + land_steps;
static_assert(count <= 256);

/// A colour at a latitude (degrees from the equator).
struct Zone {
  int latitude;
  Rgb colour;
};

/// The colour at a latitude in 1/16 degree, mixed from its neighbours in the table.
template <std::size_t N>
[[nodiscard]] constexpr Rgb zone_colour(const std::array<Zone, N>& zones, int latitude) noexcept {
  std::size_t i = 1;
  while (i + 1 < N && zones[i].latitude * 16 < latitude) ++i;
  const int from = zones[i - 1].latitude * 16;
  const int whole = zones[i].latitude * 16 - from;
  const int part = latitude - from < 0 ? 0 : latitude - from > whole ? whole : latitude - from;
  return mix(zones[i - 1].colour, zones[i].colour, part, whole);
}

/// Rain forest, savanna, desert, forest, taiga, tundra, ice.
inline constexpr std::array<Zone, 10> land_zones{{{0, {44, 118, 58}},
                                                  {9, {84, 138, 62}},
                                                  {18, {190, 168, 104}},
                                                  {28, {206, 182, 120}},
                                                  {36, {142, 156, 84}},
                                                  {48, {82, 134, 70}},
                                                  {60, {66, 112, 76}},
                                                  {68, {138, 148, 126}},
                                                  {76, {216, 226, 232}},
                                                  {90, {244, 248, 250}}}};
inline constexpr std::array<Zone, 4> ocean_zones{
    {{0, {22, 92, 150}}, {30, {16, 72, 128}}, {60, {14, 52, 98}}, {90, {40, 74, 112}}}};

/// All of them by day.
[[nodiscard]] constexpr std::array<Ink, count> make_inks() noexcept {
  std::array<Ink, count> inks{};
  inks[ocean] = {{16, 64, 116}, 17};
  inks[land] = {{120, 152, 84}, 136};
  inks[text] = {{244, 248, 252}, 255};
  inks[graticule] = {{52, 108, 160}, 51};
  inks[coast] = {{236, 228, 196}, 204};
  inks[city] = {{200, 48, 40}, 255};
  inks[panel] = {{10, 22, 36}, 0};
  inks[note] = {{148, 178, 204}, 170};
  inks[shallow] = {{58, 140, 190}, 68};
  inks[shade] = {{8, 36, 72}, 0};
  inks[aim] = {{255, 196, 64}, 238};
  const auto ramp = [&inks](int first, int steps, const auto& zones, int tone) {
    for (int i = 0; i < steps; ++i) {
      const int north = (90 * 16) - (2 * i + 1) * 90 * 16 / steps;
      inks[static_cast<std::size_t>(first) + static_cast<std::size_t>(i)] = {
          zone_colour(zones, north < 0 ? -north : north), static_cast<std::uint8_t>(tone)};
    }
  };
  ramp(oceans, ocean_steps, ocean_zones, inks[ocean].tone);
  ramp(lands, land_steps, land_zones, inks[land].tone);
  return inks;
}

inline constexpr std::array<Ink, count> by_day = make_inks();

/// The same by night: darker and bluer, but for what shines by itself.
[[nodiscard]] constexpr Ink by_night(int ink) noexcept {
  const Ink day = by_day[static_cast<std::size_t>(ink)];
  if (ink == text || ink == panel || ink == note || ink == aim) return day;
  if (ink == city) return {{255, 220, 120}, 255};
  const auto part = [](int value, int of_16) { return static_cast<std::uint8_t>(value * of_16 / 16); };
  return {{part(day.colour.r, 5), part(day.colour.g, 6), part(day.colour.b, 8)}, part(day.tone, 10)};
}

}  // namespace apps::map::ink
