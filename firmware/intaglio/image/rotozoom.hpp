// SPDX-License-Identifier: MIT
//
// Rotozoom: shows a picture turned by any angle and scaled, about any point.
//
// Rule: a target pixel (x, y) shows the source pixel that its centre comes from. With (dx, dy) the way from
// the target's pivot to that centre, U = cos/scale and V = sin/scale, each rounded to 2^-16,
//   column = floor(pivot.x + 1/2 + U dx + V dy),   row = floor(pivot.y + 1/2 - V dx + U dy),
// evaluated exactly; a target pixel whose column or row isn't one of the source's stays as it is. The rule of
// blit.hpp (colour key, table) says what becomes of the others.
//
// How: along a row of the target, column and row move by U and -V in 16.16, which is exact, from a start that
// is multiplied out for each row: no drift along it nor from row to row, and a clipped or banded picture is
// the whole one, cut. The pixels that fall on the source are one run, found by division (ends included), so
// the inner loop checks nothing and nothing outside the source is ever read.
//
// Bit budget: pivots within 2^28 sub-pixels, |dx| and |dy| within 2^29 of them, |U| and |V| within 2^24
// (scale at least 1/256): places in 2^-24 pixel have 56 bits. Sides of the source are at most 2^16, so a
// place on it fits 16.16 without a sign.
//
// Error bound: U and V are off by at most 2^-17 for the rounding and 1.001 * 2^-15 / scale for the sine, so a
// place on the source by at most (|dx| + |dy|) times that sum; none for quarter turns at a scale that is a
// power of 2.
//
// Cost: two divisions, up to four short ones a visible row of the target, then the pixels shown, once each.
//
// Textbook: the inverse mapping of an affine map. Worst known inputs: steps of 0 (quarter turns), a source of
// 2^16 columns, whose last step leaves 32 bits (unsigned, and not read any more).
#pragma once

#include <intaglio/image/lookup.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/number/fixed.hpp>
#include <intaglio/status.hpp>

#include <cstdint>

namespace intaglio::image {

/// Where and how a picture is shown.
struct Rotozoom {
  /// The place of the target, in its coordinates, on which the source's pivot lands.
  linear::SubPoint position{};
  /// The place of the source that stays where it is, counted from the centre of its corner pixel. The middle
  /// of w columns is 128 (w - 1).
  linear::SubPoint pivot{};
  /// Clockwise on the screen.
  number::Angle angle{};
  /// Target pixels a source pixel, 1/256 .. 256.
  number::Fixed<16> scale = number::Fixed<16>::from_int(1);
};

/// Smallest and largest scale that `blit_rotozoom` takes.
inline constexpr number::Fixed<16> least_rotozoom_scale = number::Fixed<16>::from_raw(1 << 8);
inline constexpr number::Fixed<16> largest_rotozoom_scale = number::Fixed<16>::from_raw(1 << 24);

namespace detail {

/// The pixels first .. last-1 of a row, counted from its left end, and the place on the source of the first,
/// in 2^-16 pixel.
struct RotozoomRun {
  int first;
  int last;
  std::uint32_t column;
  std::uint32_t row;
};

/// The inverse map, row by row.
class RotozoomMap {
 public:
  /// Precondition: `placement` passed `check_rotozoom`, 1 <= sides of the source <= turned_side_limit.
  RotozoomMap(const Rotozoom& placement, linear::Size source) noexcept;

  /// The run of the target's pixels (left, y) .. (left + width - 1, y) that show the source.
  /// Precondition: coordinates in the domain, 1 <= width <= 2^21.
  [[nodiscard]] RotozoomRun run(int left, int y, int width) const noexcept;

  /// What a pixel to the right adds to the place on the source, modulo 2^32.
  [[nodiscard]] std::uint32_t column_step() const noexcept { return static_cast<std::uint32_t>(along_); }
  [[nodiscard]] std::uint32_t row_step() const noexcept { return static_cast<std::uint32_t>(-across_); }

 private:
  linear::SubPoint position_;
  linear::SubPoint pivot_;
  linear::Size source_;
  std::int32_t along_;   // U
  std::int32_t across_;  // V
};

[[nodiscard]] Status check_rotozoom(const Rotozoom& placement, linear::Size source) noexcept;

}  // namespace detail

/// Shows `source` on `target` by the rule at the head of this file; pixels outside the target's bounds or
/// outside `clip` stay as they are.
/// Errors: position, point (the pivot; each outside the domain of sub-pixels), out_of_range size (the scale),
/// too_large source (a side above 2^16), rectangle (the clip is outside the domain), colour, table, mask (as
/// `blit`), mismatched source (its memory meets that of the target inside `clip`). Nothing is drawn on error.
template <PixelFormat F, PixelFormat G, class Byte, class Rule = Everything>
requires(Rule::template converts<F, G>) Status
    blit_rotozoom(const Surface<F>& target, const Rotozoom& placement, const PixelView<G, Byte>& source,
                  const Rule& rule = {}, const linear::Rect& clip = everywhere)
noexcept {
  if (const Status status = detail::check_rotozoom(placement, source.size()); !status.ok()) return status;
  const auto show_part = [&](const linear::Rect& part, const auto show) {
    const detail::RotozoomMap map(placement, source.size());
    const std::uint32_t column_step = map.column_step();
    const std::uint32_t row_step = map.row_step();
    for (int y = part.y; y < part.bottom(); ++y) {
      detail::RotozoomRun run = map.run(part.x, y, part.width);
      for (; run.first < run.last; ++run.first, run.column += column_step, run.row += row_step)
        show(part.x + run.first, y, static_cast<int>(run.column >> 16U), static_cast<int>(run.row >> 16U));
    }
  };
  return detail::blit_by_lookup(target, target.bounds(), source, rule, clip, show_part);
}

}  // namespace intaglio::image
