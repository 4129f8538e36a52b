// SPDX-License-Identifier: MIT
//
// An edge on its way down the rows, and what it covers of each pixel.
//
// Rule: what lies right of an edge in a column is, for a piece that stays in the column, as high as the piece
// and as wide as the mean of the distances of its ends from the right side; else a triangle in the first
// column, the unit square less a triangle in the last, and between them always a column's rise more.
//
// Where an edge crosses the sides of rows is stepped by quotient and remainder, so there is no drift at any
// length; where it crosses the sides of columns inside a row follows from there by its slope.
//
// Error bound: a place on the side of a row is less than 2^-32 pixel off, a slope less than 2^-31 of itself,
// heights are exact; products are rounded down to 2^-30. So an area is less than 2^-28 pixel off.
// Bit budget: columns in 2^-32 pixel below 2^53; heights and areas in 2^-30, those that are stepped through
// columns in 2^-62, which a row of 2^62 and its rounding don't leave. A part of a column that an edge reaches
// within a row is below 2^(32 - up) in 2^-32 column.
// Textbook: section 2.8.1. Worst known inputs: edges along the sides of pixels; a slope of a power of two.
#pragma once

#include <intaglio/number/multiply_high.hpp>

#include <cstdint>

namespace intaglio::raster::detail {

/// An edge in the workspace. Columns count from the left side of the area that is looked at.
struct CoverageEdge {
  std::int64_t x = 0;        // where it crosses the upper side of the row, in 2^-32 column
  std::int64_t step = 0;     // how far x goes with each row
  std::int32_t error;        // running remainder of x, -height .. -1; while it waits, its first vertex
  std::uint32_t rest = 0;    // of the step, over `height`
  std::uint32_t height = 0;  // in 1/256 pixel
  int left = 0;              // no column further left is touched on the row
  CoverageEdge* follower = nullptr;  // in its list
  int row;                           // its last row; while it waits, the first of its visible ones
  std::uint32_t slope = 0;           // rows a column, times 2^(30 + down - up), with the highest bit set
  std::int32_t x_end;  // its lower end, in 1/256 pixel from the left side; while it waits, its second vertex
  int right = 0;       // the last column that its first piece touches
  std::uint8_t depth = 0;  // how far it reaches into its last row, in 1/256 pixel, less one
  std::uint8_t up = 0;
  std::uint8_t down = 1;
  std::int8_t turn = 1;  // 1 if the contour runs down, else -1

  /// One that waits.
  CoverageEdge(int first_row, std::int32_t from, std::int32_t to) noexcept
      : error(from), row(first_row), x_end(to) {}

  [[nodiscard]] static constexpr int column_of(std::int64_t x) noexcept { return static_cast<int>(x >> 32); }
  /// Where a piece of it ends, the end in the column further left first.
  struct Piece {
    std::int64_t first;
    std::int64_t last;
    [[gnu::always_inline]] Piece(std::int64_t a, std::int64_t b) noexcept
        : first(column_of(b) < column_of(a) ? b : a), last(column_of(b) < column_of(a) ? a : b) {}
    [[nodiscard]] int left() const noexcept { return column_of(first); }
    [[nodiscard]] int right() const noexcept { return column_of(last); }
  };
  /// Goes on to the next row; where it crosses the upper side of that.
  [[gnu::always_inline]] std::int64_t go_on() noexcept {
    error += static_cast<std::int32_t>(rest);
    x += step;
    if (error >= 0) {
      error -= static_cast<std::int32_t>(height);
      ++x;
    }
    left = leftmost();
    return x;
  }
  /// The same if it crosses the row from side to side; its piece there. Else where the piece begins, twice.
  [[gnu::always_inline]] Piece advance(int y) noexcept {
    const std::int64_t from = x;
    return {from, row > y ? go_on() : from};
  }
  [[nodiscard, gnu::always_inline]] int leftmost() const noexcept {
    const int columns = column_of(step);
    return column_of(x) + (columns & (columns >> 31));
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
    const int first = piece.left();
    const int last = piece.right();
    const auto from = static_cast<std::uint32_t>(piece.first);
    const auto to = static_cast<std::uint32_t>(piece.last);
    const auto visible = [width](int column) {
      return all_visible || static_cast<unsigned>(column) < static_cast<unsigned>(width);
    };
    if (first == last) {
      // Left of it lies the mean of the distances of its ends from the column's left side.
      if (visible(first)) take(first, high - number::multiply_high(high, (from >> 1U) + (to >> 1U)));
      return;
    }
    // A triangle in the first column, and what a triangle leaves in the last.
    const std::uint32_t done = rise(~from);
    if (visible(first)) take(first, number::multiply_high(done, ~from) / 2);
    int column = first + 1;
    if (column != last) {
      const std::uint64_t each = std::uint64_t{slope >> down} << 32U | slope << (32U - down);  // in 2^-62 row
      std::uint64_t area = (std::uint64_t{done} << 32U) + each / 2;
      int stop = last;
      if (!all_visible) {
        if (column < 0) {
          area += static_cast<unsigned>(-column) * each;
          column = 0;
        }
        if (stop > width) stop = width;
      }
      for (; column < stop; ++column, area += each) take(column, static_cast<std::uint32_t>(area >> 32U));
    }
    if (visible(last)) take(last, high - number::multiply_high(rise(to), to) / 2);
  }
};

}  // namespace intaglio::raster::detail
