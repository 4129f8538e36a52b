// SPDX-License-Identifier: MIT
//
// Pictures turned on the glass.
#pragma once

#include <hal/panel.hpp>

namespace hal::panels {

/// How far the picture is turned clockwise on the glass as its maker holds it.
enum class Rotation : std::uint8_t { by_0, by_90, by_180, by_270 };

/// True if rows of the picture run along columns of the glass.
[[nodiscard]] constexpr bool swaps_sides(Rotation rotation) noexcept {
  return rotation == Rotation::by_90 || rotation == Rotation::by_270;
}

/// How the beam runs over the picture when it runs down the glass, or up.
[[nodiscard]] constexpr ScanDirection scan_over(Rotation rotation, bool up) noexcept {
  switch (rotation) {
    case Rotation::by_90:
      return up ? ScanDirection::left : ScanDirection::right;
    case Rotation::by_180:
      return up ? ScanDirection::down : ScanDirection::up;
    case Rotation::by_270:
      return up ? ScanDirection::right : ScanDirection::left;
    default:
      return up ? ScanDirection::up : ScanDirection::down;
  }
}

}  // namespace hal::panels
