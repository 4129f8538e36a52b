// SPDX-License-Identifier: MIT
//
// Angles as a binary fraction of a turn.
//
// Rule: 65536 steps are one turn, so adding, subtracting and scaling wrap by themselves and never drift: 360
// steps of one degree each, made one by one from whole degrees, end where they began. Positive angles turn
// from +x towards +y; y grows downwards, so that is clockwise on the screen.
//
// Error bound: from_degrees and from_ratio round to the nearest step, at most half of 360/65536 degree.
// Bit budget: degrees are reduced to one turn first, then 359 * 8192 / 45 has 22 bits.
#pragma once

#include <intaglio/number/division.hpp>
#include <intaglio/number/mul_div.hpp>

#include <cstdint>

namespace intaglio::number {

/// An angle modulo one turn, in steps of 1/65536 turn.
class Angle {
 public:
  /// Steps in a turn.
  static constexpr int turn = 65536;

  /// Angle zero, towards +x.
  constexpr Angle() noexcept = default;
  /// So many steps; whole turns fall away.
  [[nodiscard]] static constexpr Angle from_steps(int steps) noexcept {
    return Angle(static_cast<std::uint16_t>(steps));
  }
  /// The step nearest to so many degrees, any int; whole turns fall away exactly.
  [[nodiscard]] static constexpr Angle from_degrees(int degrees) noexcept {
    return from_steps(round_div((degrees % 360) * 8192, 45));
  }
  /// The step nearest to `part` / `whole` of a turn. A `whole` of 0 gives angle zero.
  [[nodiscard]] static constexpr Angle from_ratio(std::int64_t part, std::int64_t whole) noexcept {
    if (whole == 0 || whole == -1) return {};
    return from_steps(static_cast<int>(mul_div_nearest(part % whole, turn, whole)));
  }

  /// 0 .. 65535.
  [[nodiscard]] constexpr int steps() const noexcept { return steps_; }
  /// -32768 .. 32767: the short way round.
  [[nodiscard]] constexpr int signed_steps() const noexcept { return static_cast<std::int16_t>(steps_); }
  /// 0 .. 360: the nearest whole degree, ties upwards; so 360 is what the last 91 steps round to.
  [[nodiscard]] constexpr int degrees_nearest() const noexcept { return round_div(steps_ * 45, 8192); }

  friend constexpr Angle operator+(Angle a, Angle b) noexcept { return from_steps(a.steps_ + b.steps_); }
  friend constexpr Angle operator-(Angle a, Angle b) noexcept { return from_steps(a.steps_ - b.steps_); }
  friend constexpr Angle operator-(Angle a) noexcept { return from_steps(-a.steps_); }
  /// The angle taken so many times, modulo a turn, for every int.
  friend constexpr Angle operator*(Angle a, int times) noexcept {
    return Angle(static_cast<std::uint16_t>(unsigned{a.steps_} * static_cast<unsigned>(times)));
  }
  constexpr Angle& operator+=(Angle other) noexcept { return *this = *this + other; }
  constexpr Angle& operator-=(Angle other) noexcept { return *this = *this - other; }
  friend constexpr bool operator==(Angle, Angle) noexcept = default;

 private:
  constexpr explicit Angle(std::uint16_t steps) noexcept : steps_(steps) {}

  std::uint16_t steps_ = 0;
};

/// A quarter turn, 90 degrees.
inline constexpr Angle quarter_turn = Angle::from_steps(Angle::turn / 4);
/// Half a turn, 180 degrees.
inline constexpr Angle half_turn = Angle::from_steps(Angle::turn / 2);

static_assert(Angle::from_degrees(90) == quarter_turn && Angle::from_degrees(-180) == half_turn);

}  // namespace intaglio::number
