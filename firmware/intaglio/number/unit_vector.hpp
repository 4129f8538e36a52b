// SPDX-License-Identifier: MIT
//
// Vectors of three components, brought to length one.
//
// Rule: components are shifted up until the largest has 15 bits, so that n, the square of the length, lies in
// 2^28 .. 3 * 2^30; each is then multiplied by 2^31 / sqrt(n) from a rung of reciprocal_root.hpp, or divided
// by the root of n, and rounded to nearest. Signs are put back last: a mirrored vector has the mirrored
// answer. The zero vector stays as it is.
//
// Domain: components of -32767 .. 32767; -32768 counts as -32767. Error bounds: of each component, against
// the exact one. A factor that is off by e of itself moves a component by at most 2^15 * e, and the rounding
// by 1/2; e is the bound of the reciprocal root, and what its floor drops, at most sqrt(3) * 2^-16; for the
// division, 2^-14 of the root's. Bit budget: no component is longer than the vector, so a product stays below
// 2^31 * (1 + e) + 2^15, unsigned. Textbook: none. Worst known inputs: vectors along a diagonal, whose
// reciprocal is shortest.
#pragma once

#include <intaglio/number/bound.hpp>
#include <intaglio/number/fixed.hpp>
#include <intaglio/number/reciprocal_root.hpp>
#include <intaglio/number/root.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace intaglio::number {

/// Components x, y, z.
using Components = std::array<std::int16_t, 3>;
/// Components of a vector of length one.
using UnitVector = std::array<Fixed<15>, 3>;

namespace detail {

/// Each component's magnitude, shifted, by `scale(magnitude, n)`.
template <class Factor, class Scale>
[[nodiscard]] constexpr UnitVector unit_vector(const Components& vector, Factor factor,
                                               Scale scale) noexcept {
  std::array<std::uint32_t, 3> sizes{};
  std::uint32_t any = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto size = static_cast<std::uint32_t>(vector[i] < 0 ? -vector[i] : vector[i]);
    sizes[i] = size - (size >> 15U);
    any |= sizes[i];
  }
  if (any == 0) return {};
  const auto shift = static_cast<unsigned>(std::countl_zero(any)) - 17U;
  std::uint32_t square = 0;
  for (std::uint32_t& size : sizes) {
    size <<= shift;
    square += size * size;
  }
  const std::uint32_t with = factor(square);
  UnitVector unit{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto raw = static_cast<std::int32_t>(scale(sizes[i], with));
    unit[i] = Fixed<15>::from_raw(vector[i] < 0 ? -raw : raw);
  }
  return unit;
}

template <class Root>
struct UnitByReciprocal {
  [[nodiscard]] constexpr UnitVector operator()(const Components& vector) const noexcept {
    return unit_vector(vector, Root{}, [](std::uint32_t size, std::uint32_t reciprocal) {
      return (size * reciprocal + (1U << 15U)) >> 16U;
    });
  }
};

}  // namespace detail

/// By the reciprocal root's table. Table: 192 bytes.
struct UnitTable : detail::UnitByReciprocal<ReciprocalRootTable> {
  static constexpr Bound bound = lsb_q15(152'400);
};
/// With a Newton step. Table: 192 bytes.
struct UnitNewton : detail::UnitByReciprocal<ReciprocalRootNewton> {
  static constexpr Bound bound = lsb_q15(2'580);
};
/// With the exact reciprocal root. Table: 192 bytes.
struct UnitNewtonExact : detail::UnitByReciprocal<ReciprocalRootNewtonExact> {
  static constexpr Bound bound = lsb_q15(1'367);
};
/// By the root, three divisions.
struct UnitRootDivision {
  static constexpr Bound bound = lsb_q15(2'501);

  [[nodiscard]] constexpr UnitVector operator()(const Components& vector) const noexcept {
    return detail::unit_vector(
        vector, [](std::uint32_t square) { return isqrt(square); },
        [](std::uint32_t size, std::uint32_t root) { return ((size << 15U) + root / 2) / root; });
  }
};

/// The rungs that bring a vector to length one.
using NormaliseFamily = Family<UnitTable, UnitNewton, UnitNewtonExact, UnitRootDivision>;

}  // namespace intaglio::number
