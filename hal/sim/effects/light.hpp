// SPDX-License-Identifier: MIT
//
// Codes and light: the sRGB transfer function of IEC 61966-2-1, in integers.
//
// Rule: light counts in 1/2^24 of full light. A code is decoded to within 1/2^24; light is encoded as the
// code nearest to it on the scale of codes (thresholds are the decoded halves, to within 1/2^24).
#pragma once

#include <array>
#include <cstdint>

namespace hal::sim {

using Light = std::int32_t;
inline constexpr Light full_light = Light{1} << 24;

[[nodiscard]] Light decode(std::uint8_t code);
/// `light` beyond 0..full_light is cut.
[[nodiscard]] std::uint8_t encode(Light light);

}  // namespace hal::sim
