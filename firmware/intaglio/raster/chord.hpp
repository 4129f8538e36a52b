// SPDX-License-Identifier: MIT
//
// Chords: the part of a disc that an arc and the straight line between its ends enclose.
//
// Rule: the line goes from pixel to pixel: those nearest to the exact ends of the arc on the circle around
// the centre. The pixels of the disc (disc.hpp) on the arc's side of it belong to the chord; those on it as
// in a polygon, iff the chord lies to the right of the line or, where that is level, below it. So the two
// chords of a line share no pixel and make the disc. If both ends are the same pixel, a sweep below half a
// turn has no pixel and a larger one all; of half turns (radius 0) the one that holds three o'clock has it.
//
// Only what is visible is visited. Bit budget: coordinates 21 bits, differences 22, products 44.
// Error: none; the ends are known to 2^-37, and none lies within 2^-35.8 of halfway between two
// pixels (continued fractions of all cosines, radii to 2^20).
// Textbook: section 2.4, exercise 4. Worst known inputs: half turns (the line through the centre), ends that
// are the same pixel.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/sector.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

#include <cstdint>

namespace intaglio::raster {

namespace detail {

/// The side of a chord's line on which its arc is; around the centre.
class ChordSide {
 public:
  /// The line from `from` to `to`, where the arc from `start` through `sweep` ends. Precondition: 0 < |sweep|
  /// < a turn, the points are in the domain.
  ChordSide(linear::Point from, linear::Point to, number::Angle start, int sweep) noexcept;
  /// The chord of a circle. Precondition: as above, and the radius is in the domain.
  ChordSide(int radius, number::Angle start, int sweep) noexcept
      : ChordSide(Ray(start).at(radius), Ray(start + number::Angle::from_steps(sweep)).at(radius), start,
                  sweep) {}
  [[nodiscard]] bool holds(int dx, int dy) const noexcept {
    const std::int64_t cross =
        std::int64_t{along_.x} * (dy - from_.y) - std::int64_t{along_.y} * (dx - from_.x);
    return cross < on_line_;
  }
  [[nodiscard]] int same_until(int begin, int end, int dy) const noexcept {
    return detail::same_until(begin, end, [&](int dx) { return holds(dx, dy); });
  }

 private:
  linear::Point from_;
  linear::Point along_;  // from the one end to the other
  int on_line_;          // 1 if the line's pixels belong, else 0
};

}  // namespace detail

/// Fills the chord of the disc around the pixel `centre` (|c| <= 2^20) with radius 0..2^20 that the arc from
/// `start` through `sweep` steps of 1/65536 turn cuts off; clockwise on the screen, negative sweeps go the
/// other way, a turn or more is the whole disc. Errors: point, radius (outside the domain); nothing is drawn
/// then. Cost: that of a disc, and some hundred instructions a visible row.
template <SpanSink S>
Status fill_chord(S&& sink, linear::Point centre, int radius, number::Angle start, int sweep) {
  const Status status = detail::check_circle(centre, radius);
  if (!status.ok() || sweep == 0) return status;
  if (sweep >= number::Angle::turn || sweep <= -number::Angle::turn) return fill_disc(sink, centre, radius);
  return fill_disc(detail::PartSink(sink, centre, detail::ChordSide(radius, start, sweep)), centre, radius);
}

}  // namespace intaglio::raster
