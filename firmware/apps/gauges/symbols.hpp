// SPDX-License-Identifier: MIT
//
// The symbols on the warning lights and bars, drawn by hand, dot by dot.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/apps/gauges/drive.hpp>
#include <span>
#include <string_view>

namespace apps::gauges::symbols {

/// A symbol, a word a row and the leftmost dot in the most significant bit used, from a picture in text: '#'
/// is a dot. All rows have the same width, at most 16.
template <std::size_t Rows>
[[nodiscard]] consteval std::array<std::uint16_t, Rows> symbol(const std::string_view (&picture)[Rows]) {
  std::array<std::uint16_t, Rows> rows{};
  for (std::size_t y = 0; y < Rows; ++y)
    for (const char dot : picture[y])
      rows[y] = static_cast<std::uint16_t>(unsigned{rows[y]} << 1U | (dot == '#' ? 1U : 0U));
  return rows;
}

/// The same seen in a mirror.
template <std::size_t Rows>
[[nodiscard]] consteval std::array<std::uint16_t, Rows> mirrored(const std::array<std::uint16_t, Rows>& rows,
                                                                 unsigned columns = Rows) {
  std::array<std::uint16_t, Rows> out{};
  for (std::size_t y = 0; y < Rows; ++y)
    for (unsigned bit = 0; bit < columns; ++bit)
      out[y] = static_cast<std::uint16_t>(unsigned{out[y]} << 1U | (unsigned{rows[y]} >> bit & 1U));
  return out;
}

inline constexpr auto left = symbol<16>({
    "................",
    "......##........",
    ".....###........",
    "....####........",
    "...#####........",
    "..##############",
    ".###############",
    "################",
    "################",
    ".###############",
    "..##############",
    "...#####........",
    "....####........",
    ".....###........",
    "......##........",
    "................",
});
inline constexpr auto right = mirrored(left);

inline constexpr auto battery = symbol<16>({
    "................",
    "................",
    "..####....####..",
    "..####....####..",
    "################",
    "#..............#",
    "#..........#...#",
    "#..........#...#",
    "#.#####..#####.#",
    "#..........#...#",
    "#..........#...#",
    "#..............#",
    "#..............#",
    "################",
    "................",
    "................",
});

inline constexpr auto oil = symbol<16>({
    "................",
    "................",
    "................",
    ".....####.......",
    "......##......##",
    "##....##....###.",
    "##.##########...",
    ".##.........#.#.",
    ".##........#..#.",
    "..##......#..###",
    "...#.....#...###",
    "...#....#.....#.",
    "...######.......",
    "................",
    "................",
    "................",
});

inline constexpr auto engine = symbol<16>({
    "................",
    "................",
    "....#######.....",
    ".......#........",
    "...#########....",
    "...#.......#....",
    "#..#.......####.",
    "#..#..........##",
    "####..........##",
    "#..#..........##",
    "#..#.........##.",
    "...##.......#...",
    "....#########...",
    "................",
    "................",
    "................",
});

inline constexpr auto fuel = symbol<16>({
    "................",
    "..########......",
    "..#......#.#....",
    "..#.####.#..#...",
    "..#.####.#..##..",
    "..#.####.#..###.",
    "..#......#..#.#.",
    "..########..###.",
    "..########...#..",
    "..##########.#..",
    "..########.#.#..",
    "..########.#.#..",
    "..########.#.#..",
    "..########..#...",
    ".##########.....",
    "................",
});

inline constexpr auto heat = symbol<16>({
    "................",
    ".......##.......",
    ".......####.....",
    ".......##.......",
    ".......####.....",
    ".......##.......",
    ".......####.....",
    ".......##.......",
    ".......##.......",
    "......####......",
    "##....####....##",
    "..##..####..##..",
    ".......##.......",
    "##..##....##..##",
    "..##..####..##..",
    "................",
});

inline constexpr auto beam = symbol<16>({
    "................",
    "................",
    "######...####...",
    "........#....#..",
    ".......#......#.",
    "######.#......##",
    ".......#......##",
    ".......#......##",
    "######.#......##",
    ".......#......##",
    ".......#......#.",
    "######..#....#..",
    ".........####...",
    "................",
    "................",
    "................",
});

/// The symbol of a warning light, 16 columns wide.
[[nodiscard]] constexpr std::span<const std::uint16_t> of(Light light) noexcept {
  switch (light) {
    case Light::left:
      return left;
    case Light::battery:
      return battery;
    case Light::oil:
      return oil;
    case Light::engine:
      return engine;
    case Light::fuel:
      return fuel;
    case Light::heat:
      return heat;
    case Light::beam:
      return beam;
    case Light::right:
      return right;
  }
  return {};
}

/// For low bars: 7 columns by 7.
inline constexpr int small_columns = 7;
inline constexpr auto small_fuel = symbol<7>({
    "#####..",
    "#...##.",
    "#...#.#",
    "#####.#",
    "#####.#",
    "#######",
    "#####..",
});
inline constexpr auto small_left = symbol<7>({
    "...#...",
    "..##...",
    ".######",
    "#######",
    ".######",
    "..##...",
    "...#...",
});
inline constexpr auto small_right = mirrored(small_left);
inline constexpr auto small_heat = symbol<7>({
    "...#...",
    "...##..",
    "...#...",
    "...##..",
    "...#...",
    "..###..",
    "..###..",
});

}  // namespace apps::gauges::symbols
