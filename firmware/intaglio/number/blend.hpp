// SPDX-License-Identifier: MIT
//
// A share of one value and the rest of another, 8 and 16 bits: from*(1 - a) + to*a, where a counts 255ths or
// 65535ths.
//
// Rule: exactly, the answer is t / 255 with t = from*(255 - alpha) + to*alpha. The rungs:
// - t shifted by 8: too little, up to two, and white over white isn't white;
// - a weight of 256ths, alpha + its first bit, and a shift: white stays white; for 8 bits also as from + (to
//   - from)*weight, with one product;
// - (t + t/256 + 1) / 256, for 1/255 is 1/256 + 1/256^2 + ...: t / 255 rounded down for every t there is;
// - the same with one half added first, which is t / 255 rounded to nearest for every t there is;
// - the division, rounded to nearest. There are no ties: 255 and 65535 are odd.
// 16 bits in the same way. `from` = 0 is a plain product.
//
// Error bounds: against the unrounded t / 255, all 2^24 arguments for 8 bits; for 16 by the same reasoning,
// at the ends of all ranges and at random; a weight is off by at most half a 65536th. Bit budget: t <=
// 65535^2 = 2^32 - 2^17 + 1, and with one half and t / 2^16 added below 2^32 - 2^15: unsigned 32 bits.
// Textbook: section 2.8. Worst known inputs: t = 255^2 - 2, which a shift makes 253.
#pragma once

#include <intaglio/number/bound.hpp>

#include <concepts>
#include <cstdint>

namespace intaglio::number {

namespace detail {

template <class T>
inline constexpr unsigned blend_bits = 8 * sizeof(T);
/// All of `to`: 255 or 65535.
template <class T>
inline constexpr std::uint32_t whole = (std::uint32_t{1} << blend_bits<T>)-1;

/// from*(255 - alpha) + to*alpha.
template <std::unsigned_integral T>
[[nodiscard]] constexpr std::uint32_t weighed(T from, T to, T alpha) noexcept {
  return std::uint32_t{from} * (whole<T> - alpha) + std::uint32_t{to} * alpha;
}

/// alpha in 256ths or 65536ths: 0 for 0, all for all.
template <std::unsigned_integral T>
[[nodiscard]] constexpr std::uint32_t weight(T alpha) noexcept {
  return std::uint32_t{alpha} + (std::uint32_t{alpha} >> (blend_bits<T> - 1));
}

template <std::unsigned_integral T>
struct BlendShift {
  [[nodiscard]] constexpr T operator()(T from, T to, T alpha) const noexcept {
    return static_cast<T>(weighed(from, to, alpha) >> blend_bits<T>);
  }
};

template <std::unsigned_integral T>
struct BlendWeight {
  [[nodiscard]] constexpr T operator()(T from, T to, T alpha) const noexcept {
    const std::uint32_t share = weight(alpha);
    return static_cast<T>((std::uint32_t{from} * (whole<T> + 1 - share) + std::uint32_t{to} * share) >>
                          blend_bits<T>);
  }
};

template <std::unsigned_integral T>
struct BlendTwoShiftsDown {
  [[nodiscard]] constexpr T operator()(T from, T to, T alpha) const noexcept {
    const std::uint32_t t = weighed(from, to, alpha);
    return static_cast<T>((t + 1 + (t >> blend_bits<T>)) >> blend_bits<T>);
  }
};

template <std::unsigned_integral T>
struct BlendTwoShifts {
  [[nodiscard]] constexpr T operator()(T from, T to, T alpha) const noexcept {
    const std::uint32_t t = weighed(from, to, alpha) + (std::uint32_t{1} << (blend_bits<T> - 1));
    return static_cast<T>((t + (t >> blend_bits<T>)) >> blend_bits<T>);
  }
};

template <std::unsigned_integral T>
struct BlendDivision {
  [[nodiscard]] constexpr T operator()(T from, T to, T alpha) const noexcept {
    return static_cast<T>((weighed(from, to, alpha) + whole<T> / 2) / whole<T>);
  }
};

}  // namespace detail

/// The shift alone.
struct Blend8Shift : detail::BlendShift<std::uint8_t> {
  static constexpr Bound bound{1'993};
};
/// 256ths and one product.
struct Blend8WeightOneProduct {
  static constexpr Bound bound{1'432};

  [[nodiscard]] constexpr std::uint8_t operator()(std::uint8_t from, std::uint8_t to,
                                                  std::uint8_t alpha) const noexcept {
    const auto share = static_cast<std::int32_t>(detail::weight(alpha));
    return static_cast<std::uint8_t>(from + ((to - from) * share >> 8));
  }
};
/// 256ths.
struct Blend8Weight : detail::BlendWeight<std::uint8_t> {
  static constexpr Bound bound{1'432};
};
/// 1/255 by two shifts, rounded down.
struct Blend8TwoShiftsDown : detail::BlendTwoShiftsDown<std::uint8_t> {
  static constexpr Bound bound{997};
};
/// 1/255 by two shifts, rounded to nearest.
struct Blend8TwoShifts : detail::BlendTwoShifts<std::uint8_t> {
  static constexpr Bound bound{499};
};
/// The division, rounded to nearest.
struct Blend8Division : detail::BlendDivision<std::uint8_t> {
  static constexpr Bound bound{499};
};

/// The same for 16 bits.
struct Blend16Shift : detail::BlendShift<std::uint16_t> {
  static constexpr Bound bound{2'000};
};
struct Blend16Weight : detail::BlendWeight<std::uint16_t> {
  static constexpr Bound bound{1'500};
};
struct Blend16TwoShiftsDown : detail::BlendTwoShiftsDown<std::uint16_t> {
  static constexpr Bound bound{1'000};
};
struct Blend16TwoShifts : detail::BlendTwoShifts<std::uint16_t> {
  static constexpr Bound bound{500};
};
struct Blend16Division : detail::BlendDivision<std::uint16_t> {
  static constexpr Bound bound{500};
};

/// The rungs that blend 8 bits, and 16.
using Blend8Family = Family<Blend8Shift, Blend8WeightOneProduct, Blend8Weight, Blend8TwoShiftsDown,
                            Blend8TwoShifts, Blend8Division>;
using Blend16Family =
    Family<Blend16Shift, Blend16Weight, Blend16TwoShiftsDown, Blend16TwoShifts, Blend16Division>;

}  // namespace intaglio::number
