// SPDX-License-Identifier: MIT
//
// The reach of an oval's rows, walked from row to row without products.
//
// Rule: that of oval.hpp. With X and Y in half pixels from the middle, p = 2*b^2*X, q = 2*a^2*Y and
// e = a^2*Y^2 + b^2*X^2 - a^2*b^2 its two comparisons read e <= q - a^2 where p <= q, and e <= p - b^2
// elsewhere. A pixel to the side adds 2p + 4b^2 to e and 4b^2 to p; a row likewise.
//
// Bit budget: a row's outermost pixel has e <= max(p, q), and the next one doesn't belong, so
// e >= -2p - 4b^2 - max(a^2, b^2). A step adds or takes 2q + 4a^2 or 2p + 4b^2. With m = max(a, b), on the
// curve p + 2q, 2p + q <= 2*sqrt(5)*a*b*m and p, q <= 2*a*b*m, so |e| <= 6*a*b*m + 16*m^2: int32 up to half
// axes of 322 pixels, int64 up to 2^19 (`fits`). e is formed modulo the word to start: what is lost in the
// squares cancels.
// Error: none. Textbook: section 2.4, the second-order differences of a conic.
#pragma once

#include <intaglio/number/root.hpp>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace intaglio::raster::detail {

/// Stands on a pixel not more than a step from the outermost that belongs to the oval on its row.
template <std::signed_integral Int>
class OvalWalk {
  using Word = std::make_unsigned_t<Int>;

 public:
  /// True if Int holds the walk around an oval with these half axes (in half pixels, at most 2^21).
  [[nodiscard]] static constexpr bool fits(int a, int b) noexcept {
    constexpr auto limit = static_cast<std::uint64_t>(std::numeric_limits<Int>::max());
    constexpr auto longest = static_cast<int>(std::min<std::uint64_t>(number::isqrt(limit / 64), 1U << 21U));
    const int m = std::max(a, b);
    return m <= longest &&
           std::uint64_t{static_cast<Word>(a) * static_cast<Word>(b)} * static_cast<unsigned>(m) <= limit / 8;
  }

  /// Stands nowhere.
  constexpr OvalWalk() noexcept = default;
  /// Stands on (x, y), the outermost pixel of its row, in half pixels from the middle. Precondition: `fits`.
  constexpr OvalWalk(int a, int b, int x, int y) noexcept
      : a_squared_(product(a, a)),
        b_squared_(product(b, b)),
        column_(2 * product(product(b, b), x)),
        row_(2 * product(product(a, a), y)),
        error_(static_cast<Int>(word(product(product(a, a), y)) * word(y) +
                                word(product(b, b)) * (word(x) * word(x) - word(a) * word(a)))),
        inset_((a - x) / 2) {}

  /// How many pixels the box has left of this one.
  [[nodiscard]] constexpr int inset() const noexcept { return inset_; }
  /// True if the pixel belongs to the oval.
  [[nodiscard]] constexpr bool belongs() const noexcept {
    return column_ <= row_ ? error_ <= row_ - a_squared_ : error_ <= column_ - b_squared_;
  }
  /// Goes inwards to the first pixel that belongs to the oval.
  constexpr void settle() noexcept {
    for (; column_ > row_; narrower())
      if (error_ <= column_ - b_squared_) return;
    // Where the curve is flat it stays so, and a pixel's limit is its row's.
    for (const Int limit = row_ - a_squared_; error_ > limit;) narrower();
  }

  /// To the pixel of the next row away from the middle.
  constexpr void outwards() noexcept {
    error_ += 2 * row_ + 4 * a_squared_;
    row_ += 4 * a_squared_;
  }
  /// To the pixel of the next row towards the middle.
  constexpr void inwards() noexcept {
    row_ -= 4 * a_squared_;
    error_ -= 2 * row_ + 4 * a_squared_;
  }
  /// To the next pixel outwards on the row.
  constexpr void wider() noexcept {
    error_ += 2 * column_ + 4 * b_squared_;
    column_ += 4 * b_squared_;
    --inset_;
  }
  /// To the next pixel inwards on the row.
  constexpr void narrower() noexcept {
    column_ -= 4 * b_squared_;
    error_ -= 2 * column_ + 4 * b_squared_;
    ++inset_;
  }

 private:
  static constexpr Word word(std::int64_t n) noexcept { return static_cast<Word>(n); }
  static constexpr Int product(Int n, Int m) noexcept { return n * m; }

  Int a_squared_ = 0;
  Int b_squared_ = 0;
  Int column_ = 0;  // p
  Int row_ = 0;     // q
  Int error_ = 0;   // e
  int inset_ = 0;
};

}  // namespace intaglio::raster::detail
