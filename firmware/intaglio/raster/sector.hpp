// SPDX-License-Identifier: MIT
//
// Sectors: which pixels around a centre lie between two binary angles, and a sink that lets only those
// through.
//
// Rule: angles turn clockwise on the screen from three o'clock. A sweep of n > 0 steps from `start` holds the
// directions start <= a < start + n, a negative one those of start + n <= a < start; a turn or more, either
// way, holds all, zero none. So sectors side by side share no pixel and leave none out. The centre counts as
// at three o'clock.
//
// How: a direction is compared with the exact one of the angle, by quadrant and by the sign of a cross
// product. Cosine and sine come in 2^-62, as the product of the unit vectors of the angle's binary digits.
//
// Bit budget: coordinates 21 bits, cosine and sine 63, products 84: compared as two words.
// Error: none. A product of unit vectors is off by less than 29 * 2^-62 (13 factors, each half a unit off in
// both components, and rounded twice), the cross product by less than 61 * 2^-42 = 2^-36. Over all angles,
// the smallest cross product that isn't 0 with coordinates to 2^20 is 2^-34.4 (continued fractions of all
// tangents); it is 0 only on axes and diagonals, where both sides are computed alike.
// Textbook: section 2.4, exercise 4. Worst known inputs: sweeps of a full turn, 330 to 390 degrees, adjacent
// quarters (others leave gaps or draw pixels twice).
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/raster/sink.hpp>

#include <cstdint>

namespace intaglio::raster::detail {

/// The end of the columns from `begin` on (up to `end`) for which `holds(column)` is the same, if it changes
/// at most once.
template <class Holds>
[[nodiscard]] int same_until(int begin, int end, Holds holds) noexcept {
  const bool value = holds(begin);
  if (holds(end - 1) == value) return end;
  // It is the same at `begin` and different at `end`.
  for (--end; end - begin > 1;) {
    const int middle = begin + (end - begin) / 2;
    (holds(middle) == value ? begin : end) = middle;
  }
  return end;
}

/// The half line from the centre at an angle.
class Ray {
 public:
  explicit Ray(number::Angle angle) noexcept;
  /// True if, clockwise from three o'clock, the direction of (dx, dy) comes before the ray.
  [[nodiscard]] bool comes_after(int dx, int dy) const noexcept;
  /// The end of the columns from `begin` on (up to `end`) for which `comes_after` is the same. On a row it
  /// changes at most once.
  [[nodiscard]] int same_until(int begin, int end, int dy) const noexcept;
  /// The pixel nearest to the ray's point at this distance (0..2^20) from the centre, counted from there.
  [[nodiscard]] linear::Point at(int distance) const noexcept;
  /// The pixel nearest to where the ray meets the ellipse with these half axes (0..2^20) around the centre,
  /// counted from there; where the ellipse is a straight line that the ray runs along, its end. The place is
  /// known to 1/256 pixel; on a circle it is `at`.
  [[nodiscard]] linear::Point on_ellipse(int x_radius, int y_radius) const noexcept;

 private:
  /// The place that is so far along the quadrant's first axis and its second, as columns and rows.
  [[nodiscard]] linear::Point turned(int along, int across) const noexcept;

  int quadrant_;
  std::uint64_t cosine_ = std::uint64_t{1} << 62U;  // within the quadrant, in 2^-62
  std::uint64_t sine_ = 0;
};

/// The directions of a sweep.
class Sector {
 public:
  /// Precondition: 0 < |sweep| < a turn.
  Sector(number::Angle start, int sweep) noexcept;
  [[nodiscard]] bool holds(int dx, int dy) const noexcept;
  /// The end of columns from `begin` on for which `holds` is the same (it may go on being the same there).
  [[nodiscard]] int same_until(int begin, int end, int dy) const noexcept;

 private:
  Ray first_;
  Ray last_;
  bool across_zero_;
};

/// Hands on what lies in a part of the plane around a centre: a sector, say.
template <SpanSink S, class Part>
class PartSink {
 public:
  PartSink(S& sink, linear::Point centre, const Part& part) noexcept
      : sink_(&sink), centre_(centre), part_(part) {}

  [[nodiscard]] linear::Rect clip() const { return sink_->clip(); }
  void span(int y, int begin, int end) {
    if (end - begin == 1) {
      if (part_.holds(begin - centre_.x, y - centre_.y)) sink_->span(y, begin, end);
      return;
    }
    while (begin < end) {
      const int stop = centre_.x + part_.same_until(begin - centre_.x, end - centre_.x, y - centre_.y);
      if (part_.holds(begin - centre_.x, y - centre_.y)) sink_->span(y, begin, stop);
      begin = stop;
    }
  }

 private:
  S* sink_;
  linear::Point centre_;
  Part part_;
};

}  // namespace intaglio::raster::detail
