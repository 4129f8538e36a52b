// SPDX-License-Identifier: MIT
//
// Ovals: the pixels of a filled circle or ellipse that just fits a box, row by row.
//
// Rule: X and Y count half pixels from the middle of the box, so an oval of w by h pixels has the half axes
// a = w - 1 and b = h - 1, and goes through the centres of its outermost pixels. A pixel belongs to it
// - where the curve is flat there (b^2*|X| <= a^2*|Y|), iff it is not beyond the pixel that is nearest to the
//   curve in its column: |Y| - 1 <= b*sqrt(1 - X^2/a^2);
// - elsewhere, iff it is not beyond the nearest one in its row: |X| - 1 <= a*sqrt(1 - Y^2/b^2).
// Halfway, the outer of two pixels is the nearest; that happens in even diameters only (6 is the first). So
// the outermost pixels of columns and rows are those nearest to the curve along its minor direction, the set
// has no dents, transposing the box transposes it, and flat ovals keep their tips. An odd diameter gives the
// disc of that radius (disc.hpp).
//
// How: on a row next to the one before it the outermost pixel is walked to (oval_walk.hpp). On others, and on
// ovals too large for that, the search gallops from the row before it: a row costs the logarithm of its step.
// Neither goes further than the window, nor visits a row outside it.
//
// Bit budget: a, b <= 2^21, so a^2 has 42 bits, b^2*X 63; the two sides of the test have 84, and where they
// might not fit 64 they are compared as two words.
// Error: none. Textbook: section 2.4. Worst known inputs: 320x240 and 580x200 (products wrap in 32 bits), 1
// by 10 (tips), half axes of 2^20 (84 bits).
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/raster/oval_walk.hpp>
#include <intaglio/raster/row_span.hpp>
#include <intaglio/status.hpp>

#include <algorithm>
#include <cstdint>

namespace intaglio::raster::detail {

/// Of the places 0 .. length along a line, counted from the nearer end, those first .. last that lie between
/// `low` and `high` from either end; none if first > last.
struct FromEnds {
  int first;
  int last;
  constexpr FromEnds(int length, int low, int high) noexcept
      : first(std::max(0, std::min(low, length - high))), last(std::min({high, length - low, length / 2})) {}
};

/// One filled oval. Rows may be asked for in any order; neighbours are cheap.
class Oval {
 public:
  /// Fits the box of width by height pixels, 1 .. 2^21 + 1 each, with its top left at `corner` (within 2^21).
  /// Where one of them is even, both must be.
  Oval(linear::Point corner, int width, int height) noexcept;
  /// The ellipse around the centre of a pixel.
  static Oval around(linear::Point centre, int x_radius, int y_radius) noexcept {
    return {{centre.x - x_radius, centre.y - y_radius}, 2 * x_radius + 1, 2 * y_radius + 1};
  }

  /// Its pixels on this row; an empty span beyond it. Not const: it begins where the last row ended.
  [[nodiscard]] RowSpan row(int y) noexcept;
  /// Pixels of the box to the left of the oval on the row that is `from_top` below the box's top.
  [[nodiscard]] int inset(int from_top) noexcept;

  /// Where rows end outside these columns doesn't matter from now on.
  void look_at(int x_begin, int x_end) noexcept {
    // The pixels beside them decide about outlines.
    look_at(FromEnds(a_, x_begin - 2 - corner_.x, x_end + 1 - corner_.x));
  }
  /// The same for the box's columns counted from its sides.
  void look_at(const FromEnds& columns) noexcept;

  /// The walk of the rows from the one that is `from_top` below the box's top. Precondition: `fits`.
  template <class Int>
  [[nodiscard]] OvalWalk<Int> walk_from(int from_top) noexcept {
    const int y = b_ - 2 * from_top;
    // On the middle row or both the oval is as wide as its box.
    if (y > 1) {
      row_ = y;
      search(static_cast<unsigned>(y));
    }
    return {a_, b_, reach_, y};
  }
  template <class Int>
  [[nodiscard]] bool fits() const noexcept {
    return OvalWalk<Int>::fits(a_, b_);
  }

  [[nodiscard]] int left() const noexcept { return corner_.x; }
  [[nodiscard]] int right() const noexcept { return corner_.x + a_ + 1; }
  [[nodiscard]] int top() const noexcept { return corner_.y; }
  [[nodiscard]] int bottom() const noexcept { return corner_.y + b_ + 1; }

 private:
  [[nodiscard]] bool holds(unsigned x, unsigned y) const noexcept;
  void search(unsigned y) noexcept;

  linear::Point corner_;
  int a_;
  int b_;
  int reach_;  // of the last row asked for
  int least_reach_;
  int most_reach_;
  bool small_;          // it can be walked
  bool walks_ = false;  // the walk stands on (reach_, row_)
  int row_ = -1;        // the last asked for, from the middle; none if below 0
  OvalWalk<std::int64_t> walk_;
  std::uint64_t a_squared_;
  std::uint64_t b_squared_;
};

/// Errors: point, radius (outside the domain).
[[nodiscard]] Status check_ellipse(linear::Point centre, int x_radius, int y_radius) noexcept;
/// Errors: point, size (outside the domain; a diameter is 0 .. 2^21).
[[nodiscard]] Status check_diameter(linear::Point top_left, int diameter) noexcept;

}  // namespace intaglio::raster::detail
