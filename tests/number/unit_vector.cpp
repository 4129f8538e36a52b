// SPDX-License-Identifier: MIT
#include <intaglio/number/unit_vector.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/samples.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace {

namespace number = intaglio::number;
using number::Components;

Components vector_of(int x, int y, int z) {
  return {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), static_cast<std::int16_t>(z)};
}

template <class R>
int missed(const Components& vector) {
  const double length = std::hypot(vector[0], vector[1], vector[2]);
  const number::UnitVector unit = R{}(vector);
  int misses = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double exact = length == 0 ? 0 : vector[i] / length * 32768;
    misses += std::fabs(unit[i].raw() - exact) * 1000 > R::bound.thousandths;
  }
  return misses;
}
template <class... R>
int misses(number::Family<R...> /*rungs*/, const Components& vector) {
  return (... + missed<R>(vector));
}

/// How many of a family's rungs answer the mirrored vector with other than the mirrored answer.
template <class... R>
int crooked(number::Family<R...> /*rungs*/, int x, int y, int z) {
  const auto one = [&](const auto& rung) {
    const number::UnitVector there = rung(vector_of(x, y, z));
    const number::UnitVector back = rung(vector_of(-x, -y, -z));
    return there[0] != -back[0] || there[1] != -back[1] || there[2] != -back[2];
  };
  return (... + one(R{}));
}

TEST(UnitVector, EveryRungStaysWithinItsBound) {
  int missed = 0;
  for (int x = -12; x <= 12; ++x)
    for (int y = -12; y <= 12; ++y)
      for (int z = -12; z <= 12; ++z) missed += misses(number::NormaliseFamily{}, vector_of(x, y, z));
  oracle::Random random(20261127);
  const auto any = [&] { return random.between(-32767, 32767) >> random.between(0, 12); };
  for (int i = oracle::samples(50'000, 5'000'000); i > 0; --i) {
    const int x = any();
    const int y = any();
    missed += misses(number::NormaliseFamily{}, vector_of(x, y, any()));
  }
  EXPECT_EQ(missed, 0) << random.seed_text();
}

TEST(UnitVector, MirroredVectorsHaveMirroredAnswers) {
  int wrong = 0;
  for (int x = -9; x <= 9; ++x)
    for (int y = -9; y <= 9; ++y) wrong += crooked(number::NormaliseFamily{}, x * 3001, y * 3001, 777);
  EXPECT_EQ(wrong, 0);
}

TEST(UnitVector, TheMostNegativeComponentCountsAsItsNeighbour) {
  EXPECT_EQ(number::UnitNewtonExact{}(vector_of(-32768, 5, -32768)),
            number::UnitNewtonExact{}(vector_of(-32767, 5, -32767)));
  EXPECT_EQ(number::UnitRootDivision{}(vector_of(-32768, 0, 0))[0].raw(), -32768);
}

}  // namespace
