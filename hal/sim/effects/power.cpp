// SPDX-License-Identifier: MIT
#include <hal/sim/effects/power.hpp>

#include <array>
#include <bit>

namespace hal::sim {

namespace {

/// The integer nearest to the root of x.
constexpr std::uint64_t root(std::uint64_t x) {
  std::uint64_t low = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 31U; bit > 0; bit >>= 1U)
    if ((low | bit) * (low | bit) <= x) low |= bit;
  return x - low * low > low ? low + 1U : low;
}

/// Entry i: 2^-(2^-i) in 1/2^32.
constexpr std::array<std::uint64_t, 33> make_roots() {
  std::array<std::uint64_t, 33> roots{};
  roots[0] = std::uint64_t{1} << 31U;
  for (std::size_t i = 1; i < roots.size(); ++i) roots[i] = root(roots[i - 1] << 32U);
  return roots;
}

constexpr auto roots = make_roots();

}  // namespace

std::uint64_t log2_of(std::uint32_t x) {
  const auto whole = static_cast<unsigned>(std::bit_width(x)) - 1U;
  std::uint64_t mantissa = std::uint64_t{x} << (31U - whole);  // 1..2 in 1/2^31
  std::uint64_t fraction = 0;
  for (int i = 0; i < 32; ++i) {
    mantissa = (mantissa * mantissa + (std::uint64_t{1} << 30U)) >> 31U;
    const std::uint64_t bit = mantissa >> 32U;
    mantissa >>= bit;
    fraction = fraction << 1U | bit;
  }
  return std::uint64_t{whole} << 32U | fraction;
}

std::uint64_t two_to_minus(std::uint64_t y) {
  if (y >> 32U >= 34U) return 0;
  std::uint64_t value = std::uint64_t{1} << 32U;
  for (unsigned i = 1; i <= 32; ++i)
    if ((y >> (32U - i) & 1U) != 0) value = (value * roots[i] + (std::uint64_t{1} << 31U)) >> 32U;
  const std::uint64_t halvings = y >> 32U;
  return halvings == 0 ? value : (value + (std::uint64_t{1} << (halvings - 1U))) >> halvings;
}

std::uint64_t power(std::uint32_t numerator, std::uint32_t denominator, int hundredths) {
  if (numerator == 0) return 0;
  // Both logarithms are below 2^37, their product with 500 below 2^46.
  const std::uint64_t far =
      (log2_of(denominator) - log2_of(numerator)) * static_cast<std::uint64_t>(hundredths);
  return two_to_minus((far + 50U) / 100U);
}

}  // namespace hal::sim
