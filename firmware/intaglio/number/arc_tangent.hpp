// SPDX-License-Identifier: MIT
//
// The angle of a direction: from +x towards +y, in steps of 1/65536 turn.
//
// Rule: the direction is mirrored into the octant 0 <= y <= x, the rung answers there with 0..8192 steps, and
// the answer is mirrored back. So any int is welcome, mirrored directions have exactly mirrored angles, and
// the eight directions along axes and diagonals have theirs exactly; (0, 0) has angle zero. All rungs but
// CORDIC take the quotient z = y/x first, in 2^-15, rounded to nearest, after both are shifted down until x
// has 16 bits:
// - a straight line, 8192*z; the same and a parabola, z*(1 - z);
// - a polynomial in z, z^3, ... z^9 (Abramowitz and Stegun 4.4.49, off by 10^-5 radian);
// - 128 samples and straight lines between them;
// - CORDIC: 18 turns by angles whose tangents are powers of two, until y is used up.
//
// Error bounds: by parts. A curve's, with its rounding to a step, is the largest over all 32,769 quotients,
// which a test goes through; the quotient adds 0.16 step for its rounding and, beyond 16 bits, 0.32 for what
// the shift drops. Bit budget: a quotient's dividend stays below 2^31 + 2^15; see the rungs. Textbook: none.
// Worst known inputs: quotients near 0.52 for the straight line; INT_MIN.
#pragma once

#include <intaglio/number/angle.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/number/division.hpp>
#include <intaglio/number/sine_rungs.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace intaglio::number {

namespace detail {

[[nodiscard]] constexpr std::uint32_t magnitude(std::int32_t value) noexcept {
  const auto bits = static_cast<std::uint32_t>(value);
  return value < 0 ? 0U - bits : bits;
}

/// `octant(x, y)`, 0 <= y <= x, x > 0, unfolded to all directions.
template <class Octant>
[[nodiscard]] constexpr Angle angle_by_octant(std::int32_t x, std::int32_t y, Octant octant) noexcept {
  std::uint32_t along = magnitude(x);
  std::uint32_t across = magnitude(y);
  const bool steep = across > along;
  if (steep) std::swap(along, across);
  if (along == 0) return {};
  int steps = static_cast<int>(octant(along, across));
  if (steep) steps = Angle::turn / 4 - steps;
  if (x < 0) steps = Angle::turn / 2 - steps;
  return Angle::from_steps(y < 0 ? -steps : steps);
}

/// `curve(z)`, z = 0..2^15 for 0..1, unfolded to all directions.
template <class Curve>
[[nodiscard]] constexpr Angle angle_by_quotient(std::int32_t x, std::int32_t y, Curve curve) noexcept {
  return angle_by_octant(x, y, [&](std::uint32_t along, std::uint32_t across) {
    const auto bits = static_cast<unsigned>(std::bit_width(along));
    const unsigned shift = bits > 16 ? bits - 16 : 0;
    const std::uint32_t divisor = along >> shift;
    return curve((((across >> shift) << 15U) + divisor / 2) / divisor);
  });
}

/// Angles of quotients i/128 in quarters of a step; the last twice. Each is the one before and the angle
/// between, whose tangent is 128 / (128^2 + i*(i - 1)), by three terms of the series in 2^-30.
[[nodiscard]] consteval std::array<std::uint16_t, 130> make_arc_tangents() {
  constexpr std::int64_t half_pi = 1'686'629'713;  // pi/2 in 2^-30.
  std::array<std::uint16_t, 130> table{};
  std::int64_t angle = 0;
  for (int i = 1; i <= 128; ++i) {
    const std::int64_t x = round_div(std::int64_t{1} << 37U, std::int64_t{16'384 + i * (i - 1)});
    const std::int64_t square = x * x >> 30U;
    const std::int64_t cube = x * square >> 30U;
    angle += x - round_div(cube, 3) + round_div(cube * square >> 30U, 5);
    table[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(round_div(angle << 16U, half_pi));
  }
  table[129] = table[128];
  return table;
}
inline constexpr std::array<std::uint16_t, 130> arc_tangents = make_arc_tangents();
static_assert(arc_tangents[128] == 1U << 15U);

}  // namespace detail

/// 8192*z.
struct ArcTangentLinear {
  static constexpr Bound bound{742'481, Unit::angle_step};

  [[nodiscard]] static constexpr std::uint32_t curve(std::uint32_t z) noexcept { return (z + 2) >> 2U; }
  [[nodiscard]] constexpr Angle operator()(std::int32_t x, std::int32_t y) const noexcept {
    return detail::angle_by_quotient(x, y, curve);
  }
};

/// 8192*z + 2849*z*(1 - z): 2^28, and 2^13 * 2849.
struct ArcTangentParabola {
  static constexpr Bound bound{40'056, Unit::angle_step};

  [[nodiscard]] static constexpr std::uint32_t curve(std::uint32_t z) noexcept {
    const std::uint32_t parabola = z * (0x8000U - z) >> 15U;
    return ((z << 13U) + parabola * 2'849 + (1U << 14U)) >> 15U;
  }
  [[nodiscard]] constexpr Angle operator()(std::int32_t x, std::int32_t y) const noexcept {
    return detail::angle_by_quotient(x, y, curve);
  }
};

/// The polynomial of degree 9. Coefficients in 1/16 step: 55122 * 2^15 < 2^31 for all but the first, which is
/// halved before its product: 83432 * 2^15 < 2^31.4, unsigned.
struct ArcTangentPolynomial9 {
  static constexpr Bound bound{1'234, Unit::angle_step};

  [[nodiscard]] static constexpr std::uint32_t curve(std::uint32_t z) noexcept {
    const auto square = static_cast<std::int32_t>((z * z + (1U << 14U)) >> 15U);
    std::int32_t sum = 3'477;
    for (const std::int32_t coefficient : {-14'207, 30'063, -55'122, 166'864})
      sum = coefficient + (sum * square >> 15);
    return ((static_cast<std::uint32_t>(sum) >> 1U) * z + (1U << 17U)) >> 18U;
  }
  [[nodiscard]] constexpr Angle operator()(std::int32_t x, std::int32_t y) const noexcept {
    return detail::angle_by_quotient(x, y, curve);
  }
};

/// Table of 128 samples, straight lines between them: at most 326 * 256 added to 2^23. Table: 260 bytes.
struct ArcTangentTable128Linear {
  static constexpr Bound bound{1'128, Unit::angle_step};

  [[nodiscard]] static constexpr std::uint32_t curve(std::uint32_t z) noexcept {
    const std::uint32_t sample = z >> 8U;
    const std::uint32_t from = detail::arc_tangents[sample];
    return ((from << 8U) + (detail::arc_tangents[sample + 1] - from) * (z & 255U) + (1U << 9U)) >> 10U;
  }
  [[nodiscard]] constexpr Angle operator()(std::int32_t x, std::int32_t y) const noexcept {
    return detail::angle_by_quotient(x, y, curve);
  }
};

/// CORDIC, without a division: x begins with 29 bits, and turns lengthen sqrt(2) * 2^29 by 1.65, to below
/// 2^31. Angles in 2^-16 step; what the last turn leaves is 0.08 step, the rounding a half. Table: 72 bytes.
struct ArcTangentCordic {
  static constexpr Bound bound{581, Unit::angle_step};

  [[nodiscard]] constexpr Angle operator()(std::int32_t x, std::int32_t y) const noexcept {
    return detail::angle_by_octant(x, y, [](std::uint32_t first_along, std::uint32_t first_across) {
      const int shift = static_cast<int>(std::bit_width(first_along)) - 29;
      const auto scaled = [shift](std::uint32_t value) {
        return static_cast<std::int32_t>(shift > 0 ? value >> shift : value << -shift);
      };
      std::int32_t along = scaled(first_along);
      std::int32_t across = scaled(first_across);
      std::int32_t angle = 0;
      for (int i = 0; i < detail::cordic_turns; ++i) {
        const std::int32_t along_step = across >> i;
        const std::int32_t across_step = along >> i;
        const std::int32_t turn = detail::cordic_angles[static_cast<std::size_t>(i)];
        if (across >= 0) {
          along += along_step;
          across -= across_step;
          angle += turn;
        } else {
          along -= along_step;
          across += across_step;
          angle -= turn;
        }
      }
      return (angle + (1 << 15)) >> 16;
    });
  }
};

/// The rungs that compute an angle.
using ArcTangentFamily = Family<ArcTangentLinear, ArcTangentParabola, ArcTangentTable128Linear,
                                ArcTangentPolynomial9, ArcTangentCordic>;

}  // namespace intaglio::number
