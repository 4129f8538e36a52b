// SPDX-License-Identifier: MIT
//
// The colours of the instruments, by importance (see `apps::Theme`): 2, 4 or 16 loadable entries get the
// first so many. From `bezel` on come ramps and lights, each light with an entry of its own, so it is
// switched by the palette alone.
#pragma once

#include <array>
#include <cstddef>
#include <firmware/apps/theme.hpp>

namespace apps::gauges::ink {

inline constexpr int background = 0;
inline constexpr int text = 1;
inline constexpr int needle = 2;
inline constexpr int dim = 3;
inline constexpr int red = 4;
inline constexpr int amber = 5;
inline constexpr int green = 6;
inline constexpr int face = 7;
inline constexpr int steel_light = 8;
inline constexpr int steel = 9;
inline constexpr int cyan = 10;
inline constexpr int ghost = 11;
inline constexpr int blue = 12;
inline constexpr int needle_dark = 13;
inline constexpr int steel_dark = 14;
inline constexpr int red_dark = 15;

inline constexpr int shadow = 16;
inline constexpr int bezel = 17;  ///< Metal, dark to light.
inline constexpr int bezel_steps = 16;
inline constexpr int faces = bezel + bezel_steps;  ///< A dial's face, rim to centre.
inline constexpr int face_steps = 12;
inline constexpr int hub = faces + face_steps;  ///< The needle's cap, rim to centre.
inline constexpr int hub_steps = 8;
inline constexpr int backdrop = hub + hub_steps;  ///< Behind the dials, top to bottom.
inline constexpr int backdrop_steps = 16;
inline constexpr int lights = backdrop + backdrop_steps;  ///< Warning lights, in the order of `Light`.
inline constexpr int light_inks = 8;
inline constexpr int arcs =
    lights + light_inks;  ///< The glowing arcs: that of speed, then that of the engine.
inline constexpr int arc_segments = 40;
inline constexpr int count = arcs + 2 * arc_segments;
static_assert(count <= 256);

/// What is drawn with smooth edges where the knobs ask for it. From `count` on, each of them has a ramp of
/// inks that leads from the face to it.
inline constexpr std::array<int, 5> smooth{needle, needle_dark, text, dim, red};

/// Inks in all, with ramps of so many steps.
[[nodiscard]] constexpr int count_with(int edge_steps) noexcept {
  return count + static_cast<int>(smooth.size()) * edge_steps;
}
static_assert(count_with(15) <= 256);

/// All of them as they are when nothing glows.
template <class Mixing = MixLight, int edge_steps = 0>
[[nodiscard]] constexpr std::array<Ink, std::size_t{count_with(edge_steps)}> make_inks() noexcept {
  std::array<Ink, std::size_t{count_with(edge_steps)}> inks{};
  const auto set = [&inks](int ink, Ink value) { inks[static_cast<std::size_t>(ink)] = value; };
  const auto ramp = [&set](int first, int steps, Ink from, Ink to) {
    for (int i = 0; i < steps; ++i) set(first + i, mix<Mixing>(from, to, i, steps - 1));
  };
  inks[background] = {{4, 6, 10}, 0};
  inks[text] = {{236, 242, 248}, 255};
  inks[needle] = {{255, 84, 36}, 255};
  inks[dim] = {{112, 122, 138}, 136};
  inks[red] = {{230, 36, 40}, 170};
  inks[amber] = {{255, 184, 28}, 221};
  inks[green] = {{52, 214, 104}, 204};
  inks[face] = {{18, 22, 30}, 17};
  inks[steel_light] = {{206, 214, 224}, 187};
  inks[steel] = {{112, 120, 132}, 119};
  inks[cyan] = {{72, 200, 255}, 238};
  inks[ghost] = {{34, 40, 50}, 34};
  inks[blue] = {{72, 120, 255}, 204};
  inks[needle_dark] = {{168, 32, 12}, 170};
  inks[steel_dark] = {{52, 58, 68}, 68};
  inks[red_dark] = {{104, 18, 22}, 68};
  inks[shadow] = {{6, 8, 12}, 0};
  ramp(bezel, bezel_steps, {{30, 33, 39}, 51}, {{232, 238, 246}, 204});
  ramp(faces, face_steps, {{34, 39, 49}, 17}, {{11, 13, 18}, 17});
  ramp(hub, hub_steps, {{44, 48, 56}, 68}, {{176, 184, 196}, 187});
  ramp(backdrop, backdrop_steps, {{24, 30, 42}, 0}, {{5, 7, 11}, 0});
  int first = count;
  for (const int ink : smooth)
    for (int step = 1; step <= edge_steps; ++step)
      set(first++, mix<Mixing>(inks[face], inks[static_cast<std::size_t>(ink)], step, edge_steps + 1));
  return inks;
}

/// The table of them.
template <class Mixing = MixLight, int edge_steps = 0>
inline constexpr std::array<Ink, std::size_t{count_with(edge_steps)}> table = make_inks<Mixing, edge_steps>();
inline constexpr const std::array<Ink, count>& all = table<>;

}  // namespace apps::gauges::ink
