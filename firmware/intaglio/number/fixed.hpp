// SPDX-License-Identifier: MIT
//
// Fixed-point numbers: an int32 that counts 2^-F.
//
// Rule: every operation that can't be exact says in its name how it rounds: `floor` towards -infinity,
// `nearest` to the nearest with ties towards +infinity. A result that leaves the range is saturated to the
// end it left by: nothing wraps. A quotient by zero saturates to the dividend's side (0 for 0/0).
//
// Bit budget: sums of two int32 have 33 bits, products 64 (2^31 * 2^31 = 2^62), a dividend moved up by B <=
// 31 fraction bits 63; all are formed in int64. Rounding adds at most 2^30 to a product: still below 2^63.
// Error bound: 0 for +, - and unary -, below 1 lsb for floor, at most 1/2 lsb for nearest, after saturation.
//
// Worst known inputs: 65536 / -2 in 16.16, which is representable and saturates elsewhere; -1/2, which must
// be -0.5 and not -0.499985; the largest and smallest value rounded to an integer.
#pragma once

#include <intaglio/number/division.hpp>
#include <intaglio/number/mul_div.hpp>

#include <compare>
#include <cstdint>
#include <limits>

namespace intaglio::number {

/// The int32 nearest to the value.
[[nodiscard]] constexpr std::int32_t saturate(std::int64_t value) noexcept {
  using Limits = std::numeric_limits<std::int32_t>;
  return value > Limits::max()   ? Limits::max()
         : value < Limits::min() ? Limits::min()
                                 : static_cast<std::int32_t>(value);
}

namespace detail {
/// 1 with F fraction bits.
template <int F>
inline constexpr std::int64_t fixed_one = std::int64_t{1} << F;

/// value / 2^bits, rounded down. 0 <= bits <= 62.
[[nodiscard]] constexpr std::int64_t shift_floor(std::int64_t value, int bits) noexcept {
  return value >> bits;
}
/// value / 2^bits, rounded to nearest, ties up. 0 <= bits <= 31 and |value| < 2^63 - 2^30.
[[nodiscard]] constexpr std::int64_t shift_nearest(std::int64_t value, int bits) noexcept {
  return bits == 0 ? value : (value + (std::int64_t{1} << (bits - 1))) >> bits;
}
}  // namespace detail

/// A multiple of 2^-F between -2^(31-F) and 2^(31-F) - 2^-F.
template <int F>
class Fixed {
  static_assert(F >= 0 && F <= 31);

 public:
  /// Bits after the binary point.
  static constexpr int fraction_bits = F;

  /// Zero.
  constexpr Fixed() noexcept = default;
  /// The number raw * 2^-F.
  [[nodiscard]] static constexpr Fixed from_raw(std::int32_t raw) noexcept { return Fixed(raw); }
  /// A whole number, saturated.
  [[nodiscard]] static constexpr Fixed from_int(std::int32_t value) noexcept {
    return Fixed(saturate(std::int64_t{value} * detail::fixed_one<F>));
  }
  /// The largest representable number <= numerator/denominator, saturated.
  [[nodiscard]] static constexpr Fixed from_ratio_floor(std::int64_t numerator,
                                                        std::int64_t denominator) noexcept {
    return Fixed(saturate(mul_div_floor(numerator, detail::fixed_one<F>, denominator)));
  }
  /// The representable number nearest to numerator/denominator, saturated.
  [[nodiscard]] static constexpr Fixed from_ratio_nearest(std::int64_t numerator,
                                                          std::int64_t denominator) noexcept {
    return Fixed(saturate(mul_div_nearest(numerator, detail::fixed_one<F>, denominator)));
  }
  /// Smallest and largest number, and the distance of neighbours.
  [[nodiscard]] static constexpr Fixed min() noexcept {
    return Fixed(std::numeric_limits<std::int32_t>::min());
  }
  [[nodiscard]] static constexpr Fixed max() noexcept {
    return Fixed(std::numeric_limits<std::int32_t>::max());
  }
  [[nodiscard]] static constexpr Fixed epsilon() noexcept { return Fixed(1); }

  /// The number times 2^F.
  [[nodiscard]] constexpr std::int32_t raw() const noexcept { return raw_; }
  /// The largest integer <= the number.
  [[nodiscard]] constexpr std::int32_t floor() const noexcept {
    return static_cast<std::int32_t>(detail::shift_floor(raw_, F));
  }
  /// The nearest integer, ties towards +infinity.
  [[nodiscard]] constexpr std::int32_t nearest() const noexcept {
    return static_cast<std::int32_t>(detail::shift_nearest(raw_, F));
  }
  /// The smallest integer >= the number.
  [[nodiscard]] constexpr std::int32_t ceil() const noexcept {
    return static_cast<std::int32_t>(detail::shift_floor(raw_ + (detail::fixed_one<F> - 1), F));
  }
  /// The same number with G fraction bits: exact upwards unless it leaves the range, rounded downwards.
  template <int G>
  [[nodiscard]] constexpr Fixed<G> to_floor() const noexcept {
    if constexpr (G >= F)
      return Fixed<G>::from_raw(saturate(std::int64_t{raw_} * detail::fixed_one<G - F>));
    else
      return Fixed<G>::from_raw(static_cast<std::int32_t>(detail::shift_floor(raw_, F - G)));
  }
  template <int G>
  [[nodiscard]] constexpr Fixed<G> to_nearest() const noexcept {
    if constexpr (G >= F)
      return to_floor<G>();
    else
      return Fixed<G>::from_raw(static_cast<std::int32_t>(detail::shift_nearest(raw_, F - G)));
  }

  friend constexpr Fixed operator+(Fixed a, Fixed b) noexcept {
    return Fixed(saturate(std::int64_t{a.raw_} + b.raw_));
  }
  friend constexpr Fixed operator-(Fixed a, Fixed b) noexcept {
    return Fixed(saturate(std::int64_t{a.raw_} - b.raw_));
  }
  friend constexpr Fixed operator-(Fixed a) noexcept { return Fixed(saturate(-std::int64_t{a.raw_})); }
  constexpr Fixed& operator+=(Fixed other) noexcept { return *this = *this + other; }
  constexpr Fixed& operator-=(Fixed other) noexcept { return *this = *this - other; }
  // clang-tidy takes the 0 of the generated comparisons for a pointer.
  friend constexpr auto operator<=>(Fixed, Fixed) noexcept = default;  // NOLINT(modernize-use-nullptr)

 private:
  constexpr explicit Fixed(std::int32_t raw) noexcept : raw_(raw) {}

  std::int32_t raw_ = 0;
};

/// a * b in the format of a. The factors may have different formats: a length times a sine, say.
template <int A, int B>
[[nodiscard]] constexpr Fixed<A> multiply_floor(Fixed<A> a, Fixed<B> b) noexcept {
  return Fixed<A>::from_raw(saturate(detail::shift_floor(std::int64_t{a.raw()} * b.raw(), B)));
}
template <int A, int B>
[[nodiscard]] constexpr Fixed<A> multiply_nearest(Fixed<A> a, Fixed<B> b) noexcept {
  return Fixed<A>::from_raw(saturate(detail::shift_nearest(std::int64_t{a.raw()} * b.raw(), B)));
}

/// a / b in the format of a.
template <int A, int B>
[[nodiscard]] constexpr Fixed<A> divide_floor(Fixed<A> a, Fixed<B> b) noexcept {
  return Fixed<A>::from_raw(
      saturate(floor_div(std::int64_t{a.raw()} * detail::fixed_one<B>, std::int64_t{b.raw()})));
}
template <int A, int B>
[[nodiscard]] constexpr Fixed<A> divide_nearest(Fixed<A> a, Fixed<B> b) noexcept {
  return Fixed<A>::from_raw(
      saturate(round_div(std::int64_t{a.raw()} * detail::fixed_one<B>, std::int64_t{b.raw()})));
}

/// A whole number times a fixed-point factor, rounded to a whole number: radius times sine gives pixels.
template <int B>
[[nodiscard]] constexpr int scale_floor(std::int32_t value, Fixed<B> factor) noexcept {
  return multiply_floor(Fixed<0>::from_raw(value), factor).raw();
}
template <int B>
[[nodiscard]] constexpr int scale_nearest(std::int32_t value, Fixed<B> factor) noexcept {
  return multiply_nearest(Fixed<0>::from_raw(value), factor).raw();
}

static_assert(sizeof(Fixed<15>) == 4);

}  // namespace intaglio::number
