// SPDX-License-Identifier: MIT
//
// Mixing colours, and ramps between two of them.
//
// Rule: colours are mixed as light: each channel is turned into linear light (srgb.hpp), interpolated there,
// rounded to nearest, and turned back. Half-way between black and white is thus code 188, which looks half as
// bright, and not 128. The ends of a ramp are exactly the colours asked for, and every channel is monotone.
//
// Error bound: at most 0.58 code from the exact value in real numbers (1/2 of the result's rounding, the rest
// where a dark code is only 20 of 65535 wide); held by a test against the exact ramp.
// Bit budget: a difference of light has 17 bits, times at most 2^14 steps: 31.
#pragma once

#include <intaglio/image/palette.hpp>
#include <intaglio/image/srgb.hpp>
#include <intaglio/number/division.hpp>
#include <intaglio/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::image {

/// The most steps between two colours.
inline constexpr int mix_limit = 1 << 14;

namespace detail {
[[nodiscard]] constexpr std::uint8_t mix_channel(std::uint8_t from, std::uint8_t to, int part,
                                                 int whole) noexcept {
  const int start = linear_of(from);
  const int light = start + number::round_div((linear_of(to) - start) * part, whole);
  return srgb_of(static_cast<std::uint16_t>(light));
}
}  // namespace detail

/// The colour `part` / `whole` of the way from one to the other: `from` at 0 or less, `to` at `whole` or
/// more. `whole` is taken as 1 .. 2^14.
[[nodiscard]] constexpr Rgb mix(Rgb from, Rgb to, int part, int whole) noexcept {
  whole = whole < 1 ? 1 : whole > mix_limit ? mix_limit : whole;
  if (part <= 0) return from;
  if (part >= whole) return to;
  return {detail::mix_channel(from.r, to.r, part, whole), detail::mix_channel(from.g, to.g, part, whole),
          detail::mix_channel(from.b, to.b, part, whole)};
}

/// Fills `steps` with colours from `from` to `to`, both included; a single step is `from`.
/// Errors: steps (none, or more than 2^14).
constexpr Status make_ramp(std::span<Rgb> steps, Rgb from, Rgb to) noexcept {
  if (steps.empty()) return {Error::empty, Argument::steps};
  if (steps.size() > static_cast<std::size_t>(mix_limit))
    return {Error::too_large, Argument::steps, mix_limit};
  const int last = static_cast<int>(steps.size()) - 1;
  for (int step = 0; step <= last; ++step) steps[static_cast<std::size_t>(step)] = mix(from, to, step, last);
  return {};
}

/// Sets the entries first .. first+steps-1 of a palette to colours from `from` to `to`, both included.
/// Errors: index (`first` is no entry), steps (none, or more than there are entries from `first` on:
/// `needed()` is how many fit). Nothing is changed on error.
template <int N>
constexpr Status set_ramp(Palette<N>& palette, int first, int steps, Rgb from, Rgb to) noexcept {
  if (!Palette<N>::has(first)) return {Error::out_of_range, Argument::index};
  if (steps < 1) return {Error::empty, Argument::steps};
  if (steps > N - first) return {Error::too_large, Argument::steps, static_cast<std::uint32_t>(N - first)};
  for (int step = 0; step < steps; ++step) palette.set(first + step, mix(from, to, step, steps - 1)).ignore();
  return {};
}

}  // namespace intaglio::image
