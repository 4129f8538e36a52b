// SPDX-License-Identifier: MIT
//
// Other ways to mix colours: rungs beside the one of ramp.hpp.
//
// Rule: true is the mixture of light (IEC 61966-2-1, real numbers), as a code with its fraction. The rungs:
// - `MixCodes` mixes the codes themselves, as most programs do;
// - `MixSquares` mixes their squares: a display's curve taken as x^2;
// - `MixTable16` is `mix`: light in 1/65535 by a table, back by binary search;
// - `MixTable32` the same in 2^-31, with a table of the lights half-way between codes as well.
// All give the ends exactly, and all are monotone.
//
// Error: of `MixCodes` at most that of half the rounding and max(encode(t) - t) = 73.22/255, for the curve
// between two codes is flatter than the whole; of `MixSquares` 9.86 (10 and 255, a fifth of the way) and the
// rounding of square and root; of `MixTable16` at most 0.571, by trying the two ends of every light +- 1; of
// `MixTable32` the rounding, and 1e-5 where a code is least wide.
// Bit budget: a difference of squares has 17 bits, times 2^14 parts; of lights 31, so 45.
// Textbook: section 1.4, on palettes. Worst known inputs: black to white, a twelfth of the way; dark ends.
//
// On Cortex-M3 a code takes 22 instructions by `MixCodes`, 95 by `MixSquares`, 116 by `MixTable16` with 512
// bytes of table, and 148 by `MixTable32` with 2044.
#pragma once

#include <intaglio/image/palette.hpp>
#include <intaglio/image/ramp.hpp>
#include <intaglio/image/srgb.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/number/division.hpp>
#include <intaglio/number/long_division.hpp>
#include <intaglio/number/root.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace intaglio::image {

/// A way to mix a channel: the code `part` / `whole` of the way from one to the other, 0 <= part <= whole,
/// 1 <= whole <= 2^14.
template <class R>
concept MixRung = number::Rung<R> && requires(const R& rung, std::uint8_t code) {
  { rung(code, code, 0, 1) } -> std::same_as<std::uint8_t>;
};

/// Linear in codes.
struct MixCodes {
  static constexpr number::Bound bound{73'720, number::Unit::palette_level};
  [[nodiscard]] constexpr std::uint8_t operator()(std::uint8_t from, std::uint8_t to, int part,
                                                  int whole) const noexcept {
    return static_cast<std::uint8_t>(from + number::round_div((to - from) * part, whole));
  }
};

/// Linear in squares of codes.
struct MixSquares {
  static constexpr number::Bound bound{10'370, number::Unit::palette_level};
  [[nodiscard]] constexpr std::uint8_t operator()(std::uint8_t from, std::uint8_t to, int part,
                                                  int whole) const noexcept {
    const int square = from * from + number::round_div((to * to - from * from) * part, whole);
    return static_cast<std::uint8_t>(number::isqrt_nearest(static_cast<std::uint32_t>(square)));
  }
};

/// Linear in light of 16 bits; the default.
struct MixTable16 {
  static constexpr number::Bound bound{571, number::Unit::palette_level};
  [[nodiscard]] constexpr std::uint8_t operator()(std::uint8_t from, std::uint8_t to, int part,
                                                  int whole) const noexcept {
    return detail::mix_channel(from, to, part, whole);
  }
};

namespace detail {

/// Lights of half codes in 2^-31: even places are those of codes.
using HalfCodeTable = std::array<std::uint32_t, 511>;

[[nodiscard]] consteval HalfCodeTable make_half_code_table() {
  HalfCodeTable table{};
  for (std::size_t halves = 0; halves < table.size(); ++halves)
    table[halves] = static_cast<std::uint32_t>(light_q31(halves));
  return table;
}

inline constexpr HalfCodeTable half_code_table = make_half_code_table();
static_assert(half_code_table[510] == 1U << 31U);

}  // namespace detail

/// Linear in light of 31 bits.
struct MixTable32 {
  static constexpr number::Bound bound{501, number::Unit::palette_level};
  [[nodiscard]] std::uint8_t operator()(std::uint8_t from, std::uint8_t to, int part,
                                        int whole) const noexcept {
    const auto& lights = detail::half_code_table;
    const bool falls = to < from;
    // From the darker to the brighter end, so that both ways are the same.
    const std::uint32_t low = lights[2U * (falls ? to : from)];
    const std::uint32_t high = lights[2U * (falls ? from : to)];
    const auto steps = static_cast<std::uint64_t>(falls ? whole - part : part);
    const std::uint32_t light =
        low + number::long_divide((high - low) * steps, static_cast<std::uint32_t>(whole)).quotient;
    unsigned code = 0;
    for (unsigned bit = 128; bit != 0; bit >>= 1U)
      if (light >= lights[2U * (code | bit) - 1U]) code |= bit;
    return static_cast<std::uint8_t>(code);
  }
};

/// The rungs of mixing, cheapest first.
using MixFamily = number::Family<MixCodes, MixSquares, MixTable16, MixTable32>;

/// The colour `part` / `whole` of the way from one to the other by a rung: `from` at 0 or less, `to` at
/// `whole` or more. `whole` is taken as 1 .. 2^14.
template <MixRung Rung>
[[nodiscard]] constexpr Rgb mix_by(Rgb from, Rgb to, int part, int whole) noexcept {
  whole = whole < 1 ? 1 : whole > mix_limit ? mix_limit : whole;
  part = part < 0 ? 0 : part > whole ? whole : part;
  constexpr Rung rung{};
  return {rung(from.r, to.r, part, whole), rung(from.g, to.g, part, whole), rung(from.b, to.b, part, whole)};
}

}  // namespace intaglio::image
