// SPDX-License-Identifier: MIT
#include <intaglio/number/reciprocal.hpp>
#include <intaglio/number/root_rungs.hpp>
#include <tests/oracle/samples.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <utility>

namespace {

namespace number = intaglio::number;
using Wide = __int128;

/// |off| / value <= the bound in thousandths of a millionth.
bool within(number::Bound bound, std::int64_t off, std::int64_t value) {
  return Wide{std::abs(off)} * 1'000'000'000 <= Wide{bound.thousandths} * value;
}

/// How many rungs of a family miss their bound at `input`, where `exact` is right.
template <class... R>
int misses(number::Family<R...> /*rungs*/, std::int64_t exact, auto input) {
  const auto off = [&](const auto& rung) { return std::int64_t{rung(input)} - exact; };
  return (... + (R::bound.unit == number::Unit::lsb ? std::abs(off(R{})) * 1000 > R::bound.thousandths
                                                    : !within(R::bound, off(R{}), exact)));
}

TEST(Reciprocal, EveryRungStaysWithinItsBoundForEveryDivisor) {
  int missed = 0;
  for (int d = 1; d < 65536; ++d)
    missed += misses(number::ReciprocalFamily{}, (std::int64_t{1} << 31) / d, static_cast<std::uint16_t>(d));
  EXPECT_EQ(missed, 0);
}

TEST(Reciprocal, ANewtonStepIsNeverAboveTheFloor) {
  int above = 0;
  for (unsigned d = 1; d < 65536; ++d)
    above += number::ReciprocalTable256Newton{}(static_cast<std::uint16_t>(d)) > (1U << 31U) / d;
  EXPECT_EQ(above, 0);
}

/// floor(2^31 / sqrt(n)): a guess, moved to where it must be.
std::int64_t reciprocal_root(std::int64_t n) {
  constexpr Wide one = Wide{1} << 62;
  auto root = static_cast<std::int64_t>(0x1p31 / std::sqrt(static_cast<double>(n)));
  while (Wide{root} * root * n > one) --root;
  while (Wide{root + 1} * (root + 1) * n <= one) ++root;
  return root;
}

TEST(RootRungs, StayWithinTheirBoundsAtSmallNumbersAndAtSquaresAndTheirNeighbours) {
  EXPECT_EQ(misses(number::RootFamily{}, 0, 0U), 0);
  int missed = 0;
  for (std::int64_t root = 1; root < 65536; ++root) {
    for (const std::int64_t n : {root * root, root * root + 1, root * root + root, root * root + 2 * root}) {
      missed += misses(number::RootFamily{}, root, static_cast<std::uint32_t>(n));
      missed += misses(number::ReciprocalRootFamily{}, reciprocal_root(n), static_cast<std::uint32_t>(n));
    }
  }
  EXPECT_EQ(missed, 0);
}

TEST(RootRungs, ThoseThatClaimToBeExactAreForAllNumbers) {
  // Every number in the full run, every 65521st otherwise: that many are between two looks at the root.
  const std::int64_t step = oracle::samples<std::int64_t>(65521, 1);
  std::int64_t root = 0;
  int wrong = 0;
  for (std::int64_t n = 0; n <= 0xFFFFFFFF; n += step) {
    while ((root + 1) * (root + 1) <= n) ++root;
    const auto small = static_cast<std::uint32_t>(n);
    wrong += number::RootTableDivision{}(small) != root;
    wrong += number::RootReciprocalNewtonExact{}(small) != root;
  }
  EXPECT_EQ(wrong, 0);
}

}  // namespace
