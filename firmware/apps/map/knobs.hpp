// SPDX-License-Identifier: MIT
//
// What can be turned to make a frame of the map cheaper: a type with these members.
//
// Rule: as in firmware/apps/gauges/knobs.hpp. The map as it is has the most accurate setting of each.
#pragma once

#include <firmware/apps/theme.hpp>

namespace apps::map {

/// The knobs of the program as it is.
struct DefaultKnobs {
  /// How colours change from day to night.
  using Mixing = MixLight;
  /// Vertices less than so far from the last one drawn, in 1/256 px along both axes, are left out.
  static constexpr int shortest = 0;
  /// Lines of light water and of shadow along each shore: 4, 2 or 0.
  static constexpr int surf = 4;
  /// So many neighbouring bands of latitude share a colour: 1, 4 or 16.
  static constexpr int zone_stride = 1;
};

}  // namespace apps::map
