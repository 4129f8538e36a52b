// SPDX-License-Identifier: MIT
#include <intaglio/number/multiply_high.hpp>
#include <tests/oracle/random.hpp>

#include <gtest/gtest.h>

namespace {

using intaglio::number::multiply_high;
using intaglio::number::detail::multiply_high_by_halves;

/// True if both ways give the upper half of the exact product.
bool is_exact(std::uint32_t a, std::uint32_t b) {
  const auto high = static_cast<std::uint32_t>(static_cast<unsigned __int128>(a) * b >> 32U);
  return multiply_high(a, b) == high && multiply_high_by_halves(a, b) == high;
}

TEST(MultiplyHigh, IsExactWhereHalvesCarry) {
  for (const std::uint32_t a : {0U, 1U, 2U, 0xFFFFU, 0x10000U, 0x10001U, 0x7FFFFFFFU, 0x80000000U,
                                0xFFFF0000U, 0xFFFFFFFEU, 0xFFFFFFFFU})
    for (const std::uint32_t b : {0U, 1U, 2U, 0xFFFFU, 0x10000U, 0x10001U, 0x7FFFFFFFU, 0x80000000U,
                                  0xFFFF0000U, 0xFFFFFFFEU, 0xFFFFFFFFU})
      EXPECT_TRUE(is_exact(a, b)) << a << '*' << b;
}

TEST(MultiplyHigh, IsExactForNumbersOfAnySize) {
  oracle::Random random(95);
  int wrong = 0;
  for (int i = 0; i < 200000; ++i) {
    const auto a = static_cast<std::uint32_t>(random.bits()) >> i % 32;
    const auto b = static_cast<std::uint32_t>(random.bits()) >> i / 32 % 32;
    wrong += is_exact(a, b) ? 0 : 1;
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

}  // namespace
