// SPDX-License-Identifier: MIT
//
// An edge on its way down the rows, and what it covers of each pixel.
//
// Rule: what lies right of an edge in a column is, for a piece that stays in the column, as high as the piece
// and as wide as the mean of the distances of its ends from the right side; else a triangle in the first
// column, the unit square less a triangle in the last, and between them always a column's rise more.
//
// Where an edge crosses the sides of rows is stepped in 2^-64 column and up to 2^-42 too far right at any
// length; where it crosses the sides of columns inside a row follows from there by its slope. An edge is a
// row ahead: it knows both ends of its piece, and so exactly which columns that touches.
//
// Areas count in 2^-23 of a level of 1/255 pixel, so that rounding one to a level is a shift; rises, heights
// that are multiplied by a width, in twice that.
//
// Error bound: a place on the side of a row is less than 2^-32 pixel off, a slope less than 2^-29 of itself,
// heights are exact; rises are rounded down to 2^-29. So an area is less than 2^-28 pixel off. As an edge
// that isn't upright moves by 2^-37 column or more on 1/256 row, rounding puts no place beyond its end. All
// that makes a rise is rounded down, so no part of one is more than the whole.
// Bit budget: columns below 2^21, their fractions in two words; areas below 2^31, those that are stepped
// through columns in 2^-32 of their unit, which a row and its rounding don't leave. A part of a column that
// an edge reaches within a row is below 2^(32 - up) in 2^-32 column. On its last row an edge looks less than
// 2^29 columns too far ahead.
// Textbook: section 2.8.1. Worst known inputs: edges along the sides of pixels; a slope of a power of two.
#pragma once

#include <intaglio/number/add_long.hpp>
#include <intaglio/number/multiply_high.hpp>

#include <cstdint>

namespace intaglio::raster::detail {

/// An edge in the workspace. Columns count from the left side of the area that is looked at.
struct alignas(8) CoverageEdge {
  /// A place on the side of a row, or what is between two.
  struct Place {
    int column;
    std::uint64_t fraction;  // in 2^-64 column
  };

  // Where it crosses the upper side of the row, or begins, in 2^-32 column.
  std::uint32_t top_fraction = 0;
  // Where it crosses the lower side of the row, and how far that goes with each row. Fractions are in 2^-32
  // column, fine ones in 2^-32 of that.
  std::uint32_t fraction = 0;
  std::uint32_t fine = 0;
  int column;  // while it waits, its first vertex
  std::uint32_t step_fine = 0;
  std::uint32_t step_fraction = 0;
  int step_columns = 0;
  std::uint32_t slope = 0;           // what it rises in a column, divided by 2^up
  std::uint32_t slope_fine = 0;      // in 2^-32 of that
  int row;                           // its last row; while it waits, the first of its visible ones
  int left = 0;                      // no column further left is touched on the row
  int right = 0;                     // nor any further right
  int plain = INT32_MIN;             // before this row it crosses all from side to side, in visible columns
  CoverageEdge* follower = nullptr;  // in its list
  std::int32_t x_end;  // its lower end, in 1/256 pixel from the left side; while it waits, its second vertex
  std::uint8_t height = 0;  // of its piece on the row, if that isn't its last one, in 1/256 row, less one
  std::uint8_t last_height = 0;  // of its piece on its last row, less one
  std::uint8_t up = 0;
  std::int8_t turn = 1;  // 1 if the contour runs down, else -1

  static constexpr unsigned x_end_bits = 8;
  /// The area of a pixel.
  static constexpr int whole = 255 << 23;

  /// One that waits.
  CoverageEdge(int first_row, int from, std::int32_t to) noexcept : column(from), row(first_row), x_end(to) {}

  /// A piece of it: the first and the last column that it touches, and where it begins and ends in them, in
  /// 2^-32 column.
  struct Piece {
    int left;
    int right;
    std::uint32_t top;
    std::uint32_t bottom;
  };
  /// Its piece on a row that isn't its last one.
  [[nodiscard, gnu::always_inline]] Piece piece() const noexcept {
    return {left, right, top_fraction, fraction};
  }
  /// The column that it ends in.
  [[nodiscard]] int end_column() const noexcept { return x_end >> x_end_bits; }
  /// Its piece on its last row.
  [[nodiscard]] Piece last_piece() const noexcept {
    const int end = end_column();
    const bool leftwards = step_columns < 0;
    return {leftwards ? end : left, leftwards ? right : end, top_fraction,
            static_cast<std::uint32_t>(x_end) << (32U - x_end_bits)};
  }
  /// Goes on to the next row; its leftmost column there.
  [[gnu::always_inline]] int go_on() noexcept {
    const int from = column;
    top_fraction = fraction;
    number::add_long(fine, fraction, column, step_fine, step_fraction, step_columns);
    const int to = column;
    const int way = to - from;
    const int leftwards = way & (way >> 31);
    right = to - leftwards;
    left = from + leftwards;
    return left;
  }
  /// How much it rises in a part of a column.
  [[nodiscard, gnu::always_inline]] std::uint32_t rise(std::uint32_t part) const noexcept {
    return number::multiply_high(part << up, slope);
  }

  /// Calls take(column, area) for the columns 0 .. width-1 that a piece of it, so high, touches, from left to
  /// right; or, if all are known to be such, for all of them, in any order. It is the area right of the
  /// piece; in a whole column `high`. What a piece gives in a column doesn't depend on the width.
  template <bool all_visible, class Take>
  [[gnu::always_inline]] void visit_columns(const Piece& piece, std::uint32_t high, int width,
                                            const Take& take) const noexcept {
    const int first = piece.left;
    const int last = piece.right;
    const auto visible = [width](int x) {
      return all_visible || static_cast<unsigned>(x) < static_cast<unsigned>(width);
    };
    if (first == last) {
      // Left of it lies the mean of the distances of its ends from the column's left side.
      if (visible(first))
        take(first, high - number::multiply_high(high, (piece.top >> 1U) + (piece.bottom >> 1U)));
      return;
    }
    // From left to right.
    const std::uint32_t swap = (piece.top ^ piece.bottom) & static_cast<std::uint32_t>(step_columns >> 31);
    const std::uint32_t part = ~(piece.top ^ swap);
    const std::uint32_t to = piece.bottom ^ swap;
    const std::uint32_t done = rise(part);
    if (visible(first)) take(first, number::multiply_high(done, part));
    const auto left_of = [high, to](std::uint32_t rest) { return high - number::multiply_high(rest, to); };
    if (last - first == 1) {
      if (visible(last)) take(last, left_of(high / 2 - done));
      return;
    }
    const std::uint32_t at_last = left_of(rise(to));
    if (all_visible) take(last, at_last);
    const std::uint64_t half = std::uint64_t{slope} << 32U | slope_fine;
    const std::uint64_t each = 2 * half;
    std::uint64_t area = (std::uint64_t{done} << 33U) + half;
    int x = first + 1;
    int stop = last;
    if (!all_visible) {
      if (x < 0) {
        area += static_cast<unsigned>(-x) * each;
        x = 0;
      }
      if (stop > width) stop = width;
    }
    for (; x < stop; ++x, area += each) take(x, static_cast<std::uint32_t>(area >> 32U));
    if (!all_visible && visible(last)) take(last, at_last);
  }
};

}  // namespace intaglio::raster::detail
