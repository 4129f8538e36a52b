// SPDX-License-Identifier: MIT
//
// Places by distance and angle, for figures that turn.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/number/sine.hpp>

namespace apps {

/// The place at a distance (1/256 pixel, below 2^16) and angle from a centre.
[[nodiscard]] inline intaglio::linear::SubPoint around(intaglio::linear::Point centre, int distance,
                                                       intaglio::number::Angle angle) {
  constexpr int one = 1 << 15;
  const int across = distance * (intaglio::number::cosine(angle).raw() / 2) / (one / 2);
  const int down = distance * (intaglio::number::sine(angle).raw() / 2) / (one / 2);
  return {centre.x * intaglio::linear::subpixel_one + across,
          centre.y * intaglio::linear::subpixel_one + down};
}

}  // namespace apps
