// SPDX-License-Identifier: MIT
//
// Noise that is the same on every machine and in every order of asking: a hash of the place it is for.
// SplitMix64's finisher (Steele, Lea, Flood 2014).
#pragma once

#include <cstdint>

namespace hal::sim {

[[nodiscard]] constexpr std::uint64_t noise(std::uint64_t place) {
  std::uint64_t z = place + 0x9E3779B97F4A7C15U;
  z = (z ^ z >> 30U) * 0xBF58476D1CE4E5B9U;
  z = (z ^ z >> 27U) * 0x94D049BB133111EBU;
  return z ^ z >> 31U;
}

/// Evenly spread over 0..most, both included (to within 2^-64 times most).
[[nodiscard]] constexpr std::uint64_t noise_up_to(std::uint64_t most, std::uint64_t place) {
  return most + 1U == 0 ? noise(place) : noise(place) % (most + 1U);
}

}  // namespace hal::sim
