// SPDX-License-Identifier: MIT
//
// Other ways to a sine: rungs beside the table of 256 samples of sine.hpp.
//
// Rule: an angle is folded into the first quarter, x = 0..16384, the rung answers there with 2^15 times the
// sine, and the sign is put back. So every rung is odd, symmetric about a quarter turn and exact at quarters.
// - the table's nearest sample, without the line to the next;
// - 64 samples a quarter turn and straight lines;
// - a parabola, x*(2 - x); the same, with a share of its own square mixed in; Bhaskara's quotient of two;
// - polynomials in x, x^3, x^5 (and x^7), through the ends, their other coefficients searched for the least
//   error including all roundings;
// - CORDIC: 18 turns by angles whose tangents are powers of two.
//
// Error bounds: the largest over all 65,536 angles, which a test goes through. The polynomials can fall by
// one lsb where the sine rises by less than one; the others never fall. Bit budget: no product leaves 32 bits
// unsigned, see each rung; no table but those named. Textbook: none. Worst known inputs: angles half-way
// between two samples next to zero; 27 degrees for the parabola.
#pragma once

#include <intaglio/number/angle.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/number/fixed.hpp>
#include <intaglio/number/sine.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace intaglio::number {

namespace detail {

/// `quarter(x)`, x = 0..16384 steps of the first quarter, unfolded to all angles.
template <class Quarter>
[[nodiscard]] constexpr Fixed<15> sine_by_quarter(Angle angle, Quarter quarter) noexcept {
  const auto steps = static_cast<unsigned>(angle.steps());
  const unsigned within = steps & 0x3FFFU;
  const auto value = static_cast<int>(quarter((steps & 0x4000U) != 0 ? 0x4000U - within : within));
  return Fixed<15>::from_raw((steps & 0x8000U) != 0 ? -value : value);
}

/// Every fourth sample; the last twice, for the line that begins there.
[[nodiscard]] consteval std::array<std::uint16_t, 66> make_sparse_sine() {
  std::array<std::uint16_t, 66> table{};
  for (std::size_t i = 0; i <= 64; ++i) table[i] = quarter_sine[i * 4];
  table[65] = table[64];
  return table;
}
inline constexpr std::array<std::uint16_t, 66> sparse_sine = make_sparse_sine();

inline constexpr int cordic_turns = 18;
/// Angles of tangent 2^-i, in 2^-30 of a quarter turn.
[[nodiscard]] consteval std::array<std::int32_t, cordic_turns> make_cordic_angles() {
  constexpr std::int64_t half_pi = 1'686'629'713;  // pi/2 in 2^-30.
  constexpr std::int64_t one = std::int64_t{1} << 30U;
  std::array<std::int32_t, cordic_turns> angles{1 << 29};
  for (int i = 1; i < cordic_turns; ++i) {
    // x - x^3/3 + x^5/5 - ..., x = 2^-i.
    std::int64_t sum = 0;
    for (int k = 1; k * i <= 30; k += 2) sum += round_div((one >> (k * i)) * (k % 4 == 1 ? 1 : -1), k);
    angles[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(round_div(sum * one, half_pi));
  }
  return angles;
}
inline constexpr std::array<std::int32_t, cordic_turns> cordic_angles = make_cordic_angles();

}  // namespace detail

/// The nearest of 256 samples a quarter turn. Table: the 514 bytes of `SineTable256Linear`.
struct SineTable256Nearest {
  static constexpr Bound bound = lsb_q15(100'749);

  [[nodiscard]] constexpr Fixed<15> operator()(Angle angle) const noexcept {
    return detail::sine_by_quarter(angle, [](unsigned x) { return detail::quarter_sine[(x + 32) >> 6U]; });
  }
};

/// Table of 64 samples a quarter turn, straight lines between them. Table: 132 bytes.
struct SineTable64Linear {
  static constexpr Bound bound = lsb_q15(3'119);
  static constexpr std::string_view slack = "small angles are not where straight lines are worst";

  [[nodiscard]] constexpr Fixed<15> operator()(Angle angle) const noexcept {
    return detail::sine_by_quarter(angle, [](unsigned x) {
      const unsigned sample = x >> 8U;
      const unsigned from = detail::sparse_sine[sample];
      // At most 804 a sample, times 256.
      return from + (((detail::sparse_sine[sample + 1] - from) * (x & 255U) + 128) >> 8U);
    });
  }
};

/// A parabola through 0, 90 and 180 degrees: x*(2 - x). 2^28 + 2^12.
struct SineParabola {
  static constexpr Bound bound = lsb_q15(1'835'822);
  static constexpr std::string_view slack = "small angles are not where a parabola is worst";

  [[nodiscard]] static constexpr unsigned quarter(unsigned x) noexcept {
    return (x * (0x8000U - x) + (1U << 12U)) >> 13U;
  }
  [[nodiscard]] constexpr Fixed<15> operator()(Angle angle) const noexcept {
    return detail::sine_by_quarter(angle, quarter);
  }
};

/// The parabola p, less a share of its distance to its square: p - 0.224*(p - p*p). 2^30 + 2^14, and 2^13 *
/// 14682.
struct SineParabolaCorrected {
  static constexpr Bound bound = lsb_q15(31'089);

  [[nodiscard]] constexpr Fixed<15> operator()(Angle angle) const noexcept {
    return detail::sine_by_quarter(angle, [](unsigned x) {
      const unsigned p = SineParabola::quarter(x);
      const unsigned square = (p * p + (1U << 14U)) >> 15U;
      return p - (((p - square) * 14'682 + (1U << 15U)) >> 16U);
    });
  }
};

/// Bhaskara's quotient: 4w / (5 - w) with w = 4 times the share of half a turn times its rest. w has 14 bits,
/// so the dividend at most 2^31 + 2^16. One division.
struct SineBhaskara {
  static constexpr Bound bound = lsb_q15(53'782);
  static constexpr std::string_view slack = "small angles are not where the quotient is worst";

  [[nodiscard]] constexpr Fixed<15> operator()(Angle angle) const noexcept {
    return detail::sine_by_quarter(angle, [](unsigned x) {
      const unsigned w = x * (0x8000U - x) >> 14U;
      const unsigned divisor = 5 * (1U << 14U) - w;
      return ((w << 17U) + divisor / 2) / divisor;
    });
  }
};

/// x*(a - x^2*(b - x^2*c)). x^2 in 2^-15, coefficients in 2^-16: at most 102905 * 2^14 < 2^31.
struct SinePolynomial5 {
  static constexpr Bound bound = lsb_q15(3'484);
  static constexpr std::string_view slack = "small angles are not where the polynomial is worst";

  [[nodiscard]] constexpr Fixed<15> operator()(Angle angle) const noexcept {
    constexpr unsigned a = 102'905;
    constexpr unsigned b = 42'046;
    constexpr unsigned c = (1U << 16U) - a + b;
    return detail::sine_by_quarter(angle, [](unsigned x) {
      const unsigned square = (x * x + (1U << 12U)) >> 13U;
      const unsigned inner = b - (c * square >> 15U);
      const unsigned outer = a - ((inner * square + (1U << 14U)) >> 15U);
      return (outer * x + (1U << 14U)) >> 15U;
    });
  }
};

/// x*(a - x^2*(b - x^2*(c - x^2*d))). x^2 in 2^-15, coefficients in 2^-17: at most 205886 * 2^14 < 2^31.7.
struct SinePolynomial7 {
  static constexpr Bound bound = lsb_q15(848);

  [[nodiscard]] constexpr Fixed<15> operator()(Angle angle) const noexcept {
    constexpr unsigned a = 205'886;
    constexpr unsigned b = 84'651;
    constexpr unsigned c = 10'394;
    constexpr unsigned d = a - b + c - (1U << 17U);
    return detail::sine_by_quarter(angle, [](unsigned x) {
      const unsigned square = (x * x + (1U << 12U)) >> 13U;
      const unsigned inmost = c - (d * square >> 15U);
      const unsigned inner = b - ((inmost * square + (1U << 14U)) >> 15U);
      const unsigned outer = a - ((inner * square + (1U << 14U)) >> 15U);
      return (outer * x + (1U << 15U)) >> 16U;
    });
  }
};

/// 18 turns from the x axis, each by the angle of tangent 2^-i towards the one asked for; no multiplication.
/// Coordinates in 2^-30 begin shortened by what the turns lengthen them; a turn's 2^-17 left over is 1/4 lsb.
/// Table: 72 bytes.
struct SineCordic {
  static constexpr Bound bound = lsb_q15(729);

  [[nodiscard]] constexpr Fixed<15> operator()(Angle angle) const noexcept {
    return detail::sine_by_quarter(angle, [](unsigned x) {
      auto rest = static_cast<std::int32_t>(x << 16U);
      std::int32_t along = 652'032'874;
      std::int32_t across = 0;
      for (int i = 0; i < detail::cordic_turns; ++i) {
        const std::int32_t along_step = across >> i;
        const std::int32_t across_step = along >> i;
        const std::int32_t turn = detail::cordic_angles[static_cast<std::size_t>(i)];
        if (rest >= 0) {
          along -= along_step;
          across += across_step;
          rest -= turn;
        } else {
          along += along_step;
          across -= across_step;
          rest += turn;
        }
      }
      return (across + (1 << 14)) >> 15;
    });
  }
};

/// The rungs that compute a sine.
using SineFamily =
    Family<SineTable256Nearest, SineParabola, SineParabolaCorrected, SineBhaskara, SineTable64Linear,
           SinePolynomial5, SineTable256Linear, SinePolynomial7, SineCordic>;

}  // namespace intaglio::number
