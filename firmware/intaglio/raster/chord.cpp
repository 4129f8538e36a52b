// SPDX-License-Identifier: MIT
#include <intaglio/raster/chord.hpp>

namespace intaglio::raster::detail {

ChordSide::ChordSide(linear::Point from, linear::Point to, number::Angle start, int sweep) noexcept
    : from_(from), along_{to.x - from.x, to.y - from.y} {
  // The arc is on the side where the cross product is negative, clockwise; the other way, turn the line
  // round.
  if (sweep < 0) along_ = {-along_.x, -along_.y};
  constexpr int half_turn = number::Angle::turn / 2;
  bool owns_line = along_.y > 0 || (along_.y == 0 && along_.x < 0);
  if (along_.x == 0 && along_.y == 0) {
    const bool half = sweep == half_turn || sweep == -half_turn;
    owns_line = half ? Sector(start, sweep).holds(0, 0) : sweep > half_turn || sweep < -half_turn;
  }
  on_line_ = owns_line ? 1 : 0;
}

}  // namespace intaglio::raster::detail
