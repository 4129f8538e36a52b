// SPDX-License-Identifier: MIT
//
// A picture turned by three shears (Paeth): no pixel is lost and none is shown twice.
//
// Rule: the angle is a number of quarter turns, which only renumber the source's columns and rows, and a rest
// r within an eighth of a turn. With s = sin r and t = tan(r/2) = s / (1 + cos r), a turn by r is a shear
// along x by -t, one along y by s, and one along x by -t again. Each moves whole rows or columns by a whole
// number of pixels, so it is a permutation, and so are the three: with the pivot p landing on P, pixel (x, y)
// goes
//   x1 = x + round(-t (y - p.y)),
//   Y  = y + round(P.y - p.y + s (x1 - p.x)),
//   X  = x1 + round(P.x - p.x - t (Y - P.y)),
// rounded to the nearest, ties upwards, exactly, with sine and cosine of `number/sine.hpp`. Each source pixel
// lands on one target pixel, and no two on one. The rule of blit.hpp (colour key, table, mask) says what
// becomes of it.
//
// How: the other way round, from the target's visible pixels. Along a row of the target the source's row
// moves by s, kept in 2^-15, and each time it comes to another row, the first shear moves by t, kept as a
// remainder of 2^15 (1 + cos r): exact additions from a start that is divided out for each row, so there is
// no drift, and a clipped or banded picture is the whole one, cut. The columns that reach the source's rows
// are found by division; what lies beside it is skipped, so nothing outside the source is ever read.
//
// Bit budget: pivots within 2^28 sub-pixels, or 2^29 turned; sine and 1 + cosine within 2^16 * 2^-15: below
// 2^48. Sides of the source are at most 2^16, so a place in its rows has 31 bits.
//
// Error bound: a pixel lands within 1.36 pixels along x and 0.86 along y (in the turned source's axes) of
// where the turn brings its centre, for the three roundings, and 1.2 * 2^-14 pixels more for each pixel of
// its way (columns and rows added) from the pivot, for the sine.
//
// Cost: two divisions for the picture, up to five short ones a visible row of the target; then at most the
// pixels of the box around the sheared picture's row, twice those shown at 45 degrees.
//
// Textbook: none; beside the inverse mapping of an affine map. Worst known inputs: 45 degrees either way,
// where the quarter turns change; angles whose sine is a few 2^-15.
#pragma once

#include <intaglio/image/lookup.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/status.hpp>

#include <cstdint>

namespace intaglio::image {

/// Where a turned picture is shown.
struct ThreeShear {
  /// The place of the target, in its coordinates, on which the source's pivot lands.
  linear::SubPoint position{};
  /// The place of the source that it is turned about, counted from the centre of its corner pixel. The middle
  /// of w columns is 128 (w - 1).
  linear::SubPoint pivot{};
  /// Clockwise on the screen.
  number::Angle angle{};
};

namespace detail {

/// The way along a row of the target, in the columns and rows of the source after the quarter turns.
class ThreeShearRow {
 public:
  /// The pixels first .. last-1, counted from where the row begins, stand on rows of the source; `column` may
  /// be any number.
  int first = 0;
  int last = 0;

  [[nodiscard]] constexpr int column() const noexcept { return column_; }
  [[nodiscard]] constexpr int row() const noexcept { return last_row_ - static_cast<int>(place_ >> 15U); }
  /// On to the next pixel.
  constexpr void advance() noexcept {
    const std::uint32_t before = place_ >> 15U;
    place_ += static_cast<std::uint32_t>(slope_);
    ++column_;
    if (place_ >> 15U == before) return;
    remainder_ += slope_ < 0 ? -slope_ : slope_;
    if (remainder_ < divisor_) return;
    remainder_ -= divisor_;
    --column_;
  }

 private:
  friend class ThreeShearMap;
  int column_ = 0;
  int last_row_ = 0;
  std::uint32_t place_ = 0;  // last_row_ - row, in 2^-15
  std::int32_t slope_ = 0;   // s in 2^-15
  std::int32_t remainder_ = 0;
  std::int32_t divisor_ = 1;  // 1 + cos r in 2^-15
};

/// The inverse map.
class ThreeShearMap {
 public:
  /// Precondition: `placement` passed `check_turned`, 1 <= sides of the source <= turned_side_limit.
  ThreeShearMap(const ThreeShear& placement, linear::Size source) noexcept;

  /// The way along the target's pixels (left, y) .. (left + width - 1, y).
  /// Precondition: coordinates in the domain, 1 <= width <= 2^21.
  [[nodiscard]] ThreeShearRow row(int left, int y, int width) const noexcept;

  /// True if the turned source has the column.
  [[nodiscard]] constexpr bool has_column(int column) const noexcept {
    return static_cast<unsigned>(column) < static_cast<unsigned>(size_.width);
  }
  /// The source's pixel, counted from its corner, of a column and row of the turned source.
  [[nodiscard]] constexpr linear::Point unturned(int column, int row) const noexcept {
    return {origin_.x + along_.x * column - along_.y * row, origin_.y + along_.y * column + along_.x * row};
  }

 private:
  [[nodiscard]] std::int64_t first_shear(int row) const noexcept;  // to be divided by the divisor

  linear::SubPoint position_;
  linear::SubPoint pivot_;  // of the turned source
  linear::Size size_;       // of the turned source
  linear::Point origin_;    // the source's pixel in its corner
  linear::Point along_;     // a column more is this on the source
  std::int32_t slope_;
  std::int32_t divisor_;
  int least_shift_;  // of the first shear
  int most_shift_;
};

}  // namespace detail

/// Shows `source` on `target` by the rule at the head of this file; pixels outside the target's bounds or
/// outside `clip` stay as they are.
/// Errors: position, point (the pivot; each outside the domain of sub-pixels), too_large source (a side above
/// 2^16), rectangle (the clip is outside the domain), colour, table, mask (as `blit`), mismatched source (its
/// memory meets that of the target inside `clip`). Nothing is drawn on error.
template <PixelFormat F, PixelFormat G, class Byte, class Rule = Everything>
requires(Rule::template converts<F, G>) Status
    blit_three_shear(const Surface<F>& target, const ThreeShear& placement, const PixelView<G, Byte>& source,
                     const Rule& rule = {}, const linear::Rect& clip = everywhere)
noexcept {
  const Status status = detail::check_turned(placement.position, placement.pivot, source.size());
  if (!status.ok()) return status;
  const auto show_part = [&](const linear::Rect& part, const auto show) {
    const detail::ThreeShearMap map(placement, source.size());
    for (int y = part.y; y < part.bottom(); ++y) {
      detail::ThreeShearRow way = map.row(part.x, y, part.width);
      for (; way.first < way.last; ++way.first, way.advance()) {
        if (!map.has_column(way.column())) continue;
        const linear::Point from = map.unturned(way.column(), way.row());
        show(part.x + way.first, y, from.x, from.y);
      }
    }
  };
  return detail::blit_by_lookup(target, target.bounds(), source, rule, clip, show_part);
}

}  // namespace intaglio::image
