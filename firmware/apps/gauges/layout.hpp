// SPDX-License-Identifier: MIT
//
// Where the instruments stand on a panel of any size.
//
// Rule: a panel too low or too narrow for a dial gets a readout (digits and a bar). A landscape panel gets
// two dials side by side, as large as fit between a strip of warning lights above (panels of 170 rows and
// more) and a strip with bars and odometer below; a much wider one puts a readout between the dials. A
// portrait panel gets a large dial, and below it a small one beside the bars. What doesn't fit is empty,
// never outside.
#pragma once

#include <intaglio/linear/rect.hpp>

namespace apps::gauges {

/// A dial; radius 0 means there is none.
struct DialPlace {
  intaglio::linear::Point centre{};
  int radius = 0;
};

/// The places of all instruments; empty rectangles where one is left out.
struct Layout {
  DialPlace speed{};
  DialPlace rpm{};
  intaglio::linear::Rect readout{};   ///< Digits and engine-speed bar, where there is no room for dials.
  intaglio::linear::Rect fuel{};      ///< A bar with its symbol and ends.
  intaglio::linear::Rect heat{};      ///< As `fuel`.
  intaglio::linear::Rect odometer{};  ///< Digits of the odometer.
  intaglio::linear::Rect lights{};    ///< The strip of warning lights.
  intaglio::linear::Rect arrows{};    ///< Two small turn signals, where there is no strip of lights.
  int light_scale = 0;                ///< Side of a light's dot in pixels; a light has 16x16 dots.
};

/// The layout for a panel; sides of 1 and more.
[[nodiscard]] Layout layout_for(intaglio::linear::Size size) noexcept;

}  // namespace apps::gauges
