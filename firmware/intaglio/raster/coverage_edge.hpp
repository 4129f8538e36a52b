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
// Error bound: a place on the side of a row is less than 2^-32 pixel off, a slope less than 2^-31 of itself,
// heights are exact; products are rounded down to 2^-30. So an area is less than 2^-28 pixel off. As an edge
// that isn't upright moves by 2^-37 column or more on 1/256 row, rounding puts no place beyond its end.
// Bit budget: columns below 2^21, their fractions in two words; heights and areas in 2^-30, those that are
// stepped through columns in 2^-62, which a row of 2^62 and its rounding don't leave. A part of a column that
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

  // Where it crosses the lower side of the row, and how far that goes with each row. Fractions are in 2^-32
  // column, fine ones in 2^-32 of that.
  std::uint32_t fraction = 0;
  std::uint32_t fine = 0;
  int column;  // while it waits, its first vertex
  std::uint32_t step_fine = 0;
  std::uint32_t step_fraction = 0;
  int step_columns = 0;
  int left = 0;                      // no column further left is touched on the row
  int right = 0;                     // nor any further right
  std::uint32_t top_fraction = 0;    // where it crosses the upper side of the row, or begins, in 2^-32 column
  int row;                           // its last row; while it waits, the first of its visible ones
  std::uint32_t slope = 0;           // rows a column, times 2^(30 + down - up), with the highest bit set
  int plain = INT32_MIN;             // before this row it crosses all from side to side, in visible columns
  CoverageEdge* follower = nullptr;  // in its list
  std::int32_t x_end;  // its lower end, in 1/256 pixel from the left side; while it waits, its second vertex
  std::uint16_t height = 0;   // of its piece on the row, if that isn't its last one, in 1/256 row
  std::uint16_t last_height;  // of its piece on its last row
  std::uint8_t up = 0;
  std::uint8_t down = 1;
  std::int8_t turn = 1;  // 1 if the contour runs down, else -1

  static constexpr unsigned x_end_bits = 8;

  /// One that waits.
  CoverageEdge(int first_row, int from, std::int32_t to) noexcept
      : column(from), row(first_row), x_end(to), last_height(0) {}

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
  /// How high it is over a part of a column, in 2^-30 row.
  [[nodiscard, gnu::always_inline]] std::uint32_t rise(std::uint32_t part) const noexcept {
    return number::multiply_high(part << up, slope) >> down;
  }

  /// Calls take(column, area) from left to right for the columns 0 .. width-1 that a piece of it, so high,
  /// touches (or, if all are known to be such, for all of them): the area right of it. What a piece gives in
  /// a column doesn't depend on the width.
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
    const bool leftwards = step_columns < 0;
    const std::uint32_t from = leftwards ? piece.bottom : piece.top;
    const std::uint32_t to = leftwards ? piece.top : piece.bottom;
    // A triangle in the first column, and what a triangle leaves in the last.
    const std::uint32_t done = rise(~from);
    const std::uint32_t rest = high - number::multiply_high(rise(to), to) / 2;
    if (visible(first)) take(first, number::multiply_high(done, ~from) / 2);
    if (last - first > 1) {
      const std::uint64_t each = std::uint64_t{slope >> down} << 32U | slope << (32U - down);  // in 2^-62 row
      std::uint64_t area = (std::uint64_t{done} << 32U) + each / 2;
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
    }
    if (visible(last)) take(last, rest);
  }
};

}  // namespace intaglio::raster::detail
