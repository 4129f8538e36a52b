// SPDX-License-Identifier: MIT
#include <intaglio/number/long_division.hpp>
#include <tests/oracle/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using intaglio::number::long_divide;
using intaglio::number::LongDivision;
using intaglio::number::detail::long_divide_by_steps;

/// quotient * d + remainder = n with 0 <= remainder < d, both ways.
bool is_exact(std::uint64_t n, std::uint32_t d) {
  for (const LongDivision& division : {long_divide(n, d), long_divide_by_steps(n, d)}) {
    const unsigned __int128 product = static_cast<unsigned __int128>(division.quotient) * d;
    if (product + division.remainder != n || division.remainder >= d) return false;
  }
  return true;
}

/// The largest dividend that the precondition allows.
std::uint64_t largest(std::uint32_t d) {
  return std::min<std::uint64_t>((std::uint64_t{d} << 32U) - 1U, (std::uint64_t{1} << 63U) - 1U);
}

TEST(LongDivision, IsExactForAllSmallNumbers) {
  for (std::uint32_t d = 1; d < 300; ++d)
    for (std::uint64_t n = 0; n < 300; ++n) ASSERT_TRUE(is_exact(n, d)) << n << '/' << d;
}

TEST(LongDivision, IsExactAtTheEndsOfItsDomain) {
  for (const std::uint32_t d : {1U, 2U, 3U, 0x7FFFFFFFU, 0x80000000U, 0x80000001U, 0xFFFFFFFEU, 0xFFFFFFFFU})
    for (std::uint64_t i = 0; i < 70; ++i) {
      ASSERT_TRUE(is_exact(largest(d) - i, d)) << i << ' ' << d;
      ASSERT_TRUE(is_exact(std::min(largest(d), std::uint64_t{d} * i), d)) << i << ' ' << d;
    }
}

TEST(LongDivision, IsExactForRandomNumbersOfAllSizes) {
  oracle::Random random(20260107);
  for (int i = 0; i < 200'000; ++i) {
    const auto d = static_cast<std::uint32_t>(random.bits() >> (32U + random.bits() % 32U)) | 1U;
    const std::uint64_t n = (random.bits() >> (random.bits() % 64U)) % (largest(d) + 1U);
    ASSERT_TRUE(is_exact(n, d)) << n << '/' << d << ", " << random.seed_text();
  }
}

}  // namespace
