// SPDX-License-Identifier: MIT
//
// Sine and cosine of a binary angle; other ways to them are in sine_rungs.hpp.
//
// Rule: 257 samples of one quarter turn, rounded to 2^-15, and a straight line between neighbours, rounded to
// nearest. The falling quarters read the table backwards; since t[i] + d*f/64 and t[i+1] - d*(64-f)/64 round
// alike, the mirror is exact, and so, for every angle and without a tolerance:
//   sine(-a) = -sine(a)   cosine(-a) = cosine(a)   cosine(a) = sine(a + quarter_turn)   |sine| <= 1 =
//   sine(90)
//
// Error bound: 1/2 lsb from the sample, 1/2 from the rounding, h^2/8 = 0.155 lsb from the straight line
// (h = pi/512): below 1.16 by construction; the
// largest over all 65,536 angles is 1.0008, held by a test.
// Bit budget: samples have 16 bits, a difference times 6 fraction bits 14. Table: 514 bytes.
// Cost: 21 instructions on Cortex-M3, 24 on Cortex-M0+.
//
// The samples are summed at compile time from the series x - x^3/3! + x^5/5! - ... in 2^-30, integers only.
#pragma once

#include <intaglio/number/angle.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/number/fixed.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace intaglio::number {

namespace detail {

inline constexpr int sine_samples = 256;
using QuarterSine = std::array<std::uint16_t, sine_samples + 1>;

/// round(2^15 * sin(i/256 of a quarter turn)). Twelve terms leave less than 2^-30; each is rounded once, so
/// the sum is off by less than 2^-26, and no sample lies that close to a rounding tie (a test compares all).
[[nodiscard]] consteval QuarterSine make_quarter_sine() {
  constexpr std::int64_t half_pi = 1'686'629'713;  // pi/2 in 2^-30.
  constexpr int bits = 30;
  QuarterSine table{};
  for (int i = 0; i <= sine_samples; ++i) {
    const std::int64_t x = round_div(half_pi * i, std::int64_t{sine_samples});
    const std::int64_t x_squared = shift_nearest(x * x, bits);
    std::int64_t term = x;
    std::int64_t sum = x;
    for (std::int64_t k = 1; k < 12; ++k) {
      term = round_div(-shift_nearest(term * x_squared, bits), 2 * k * (2 * k + 1));
      sum += term;
    }
    table[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(shift_nearest(sum, bits - 15));
  }
  return table;
}

inline constexpr QuarterSine quarter_sine = make_quarter_sine();
static_assert(sizeof(quarter_sine) == 514);
static_assert(quarter_sine[0] == 0 && quarter_sine[128] == 23170 && quarter_sine[256] == 32768);

}  // namespace detail

/// Table of 256 samples a quarter turn, straight lines between them.
struct SineTable256Linear {
  static constexpr Bound bound = lsb_q15(1001);

  [[nodiscard]] constexpr Fixed<15> operator()(Angle angle) const noexcept {
    const auto steps = static_cast<unsigned>(angle.steps());
    // steps: half (1 bit), falling quarter (1 bit), sample (8 bits), fraction (6 bits).
    const unsigned sample = steps >> 6U & 255U;
    const auto fraction = static_cast<int>(steps & 63U);
    const bool falling = (steps & 0x4000U) != 0;
    const int from = detail::quarter_sine[falling ? 256U - sample : sample];
    const int to = detail::quarter_sine[falling ? 255U - sample : sample + 1U];
    const int value = from + (((to - from) * fraction + 32) >> 6);
    return Fixed<15>::from_raw((steps & 0x8000U) != 0 ? -value : value);
  }
};

/// The sine of an angle, -1 .. 1, by the rung of your choice.
template <Rung R = SineTable256Linear>
[[nodiscard]] constexpr Fixed<15> sine(Angle angle) noexcept {
  return R{}(angle);
}

/// The cosine of an angle: the sine a quarter turn further on, exactly.
template <Rung R = SineTable256Linear>
[[nodiscard]] constexpr Fixed<15> cosine(Angle angle) noexcept {
  return R{}(angle + quarter_turn);
}

static_assert(sine(quarter_turn).raw() == 32768 && cosine(half_turn).raw() == -32768);

}  // namespace intaglio::number
