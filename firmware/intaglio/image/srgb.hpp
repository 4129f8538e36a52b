// SPDX-License-Identifier: MIT
//
// sRGB and linear light.
//
// Rule: a code c of 0 .. 255 stands for the light  c/255/12.92  up to 0.04045 and  ((c/255 +
// 0.055)/1.055)^2.4 above (IEC 61966-2-1). `linear_of` is that light times 65535, rounded to nearest;
// `srgb_of` is the code whose light is nearest, ties to the brighter. srgb_of(linear_of(c)) = c for every c.
//
// Error bound: 1/2 of 1/65535 for `linear_of` (every entry is the nearest, held by a test); see ramp.hpp for
// what that means in codes. Table: 512 bytes. Cost of `srgb_of`: eight steps of a binary search.
//
// The table is made at compile time with integers only: x^2.4 = x^2 * r, where r is the fifth root of x^2,
// found bit by bit in 2^-31.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace intaglio::image {

namespace detail {

using LinearTable = std::array<std::uint16_t, 256>;

/// a * b in 2^-31, for a, b of 0 .. 1; rounded, as an error here would grow fivefold.
[[nodiscard]] consteval std::uint64_t multiply_q31(std::uint64_t a, std::uint64_t b) {
  return (a * b + (1ULL << 30U)) >> 31U;
}

/// The largest r with r^5 <= a, both in 2^-31.
[[nodiscard]] consteval std::uint64_t fifth_root_q31(std::uint64_t a) {
  std::uint64_t root = 0;
  for (std::uint64_t bit = 1ULL << 31U; bit != 0; bit >>= 1U) {
    const std::uint64_t r = root + bit;
    if (r > 1ULL << 31U) continue;
    const std::uint64_t r2 = multiply_q31(r, r);
    if (multiply_q31(multiply_q31(r2, r2), r) <= a) root = r;
  }
  return root;
}

/// The light of half a code times `halves`, 0 .. 510, in 2^-31; off by a few 2^-31.
[[nodiscard]] consteval std::uint64_t light_q31(std::uint64_t halves) {
  if (halves * 100'000 <= 4'045 * 510) return ((halves << 31U) * 100 + 510 * 1292 / 2) / (510 * 1292);
  // (code/255 + 0.055) / 1.055 = (1000 code + 14025) / 269025.
  const std::uint64_t x = (((1000 * halves + 28050) << 31U) + 538050 / 2) / 538050;
  const std::uint64_t square = multiply_q31(x, x);
  return multiply_q31(square, fifth_root_q31(square));
}

[[nodiscard]] consteval LinearTable make_linear_table() {
  LinearTable table{};
  for (std::size_t code = 0; code < table.size(); ++code)
    table[code] = static_cast<std::uint16_t>((light_q31(2 * code) * 65535 + (1ULL << 30U)) >> 31U);
  return table;
}

inline constexpr LinearTable linear_table = make_linear_table();
static_assert(linear_table[0] == 0 && linear_table[255] == 65535);

}  // namespace detail

/// The light of an sRGB code, 0 .. 65535.
[[nodiscard]] constexpr std::uint16_t linear_of(std::uint8_t code) noexcept {
  return detail::linear_table[code];
}

/// The sRGB code whose light is nearest.
[[nodiscard]] constexpr std::uint8_t srgb_of(std::uint16_t light) noexcept {
  // The largest code that is at least half-way up from the code below it; its binary digits from the top.
  unsigned code = 0;
  for (unsigned bit = 128; bit != 0; bit >>= 1U) {
    const unsigned trial = code | bit;
    const unsigned twice_half_way = unsigned{detail::linear_table[trial - 1]} + detail::linear_table[trial];
    if (2U * light >= twice_half_way) code = trial;
  }
  return static_cast<std::uint8_t>(code);
}

}  // namespace intaglio::image
