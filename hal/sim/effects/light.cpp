// SPDX-License-Identifier: MIT
#include <hal/sim/effects/light.hpp>
#include <hal/sim/effects/power.hpp>

#include <algorithm>

namespace hal::sim {

namespace {

/// Light of the code halves / 2. halves <= 510.
Light decode_halves(std::uint32_t halves) {
  // 510 * 0.04045 = 20.6.
  const std::uint64_t scaled = halves <= 20U
                                   ? ((std::uint64_t{halves} << 32U) * 100U + 510U * 646U) / (510U * 1292U)
                                   : power(halves * 1000U + 28050U, 538050U, 240);
  return static_cast<Light>((scaled + 128U) >> 8U);
}

template <std::size_t N>
std::array<Light, N> make_table(std::uint32_t first) {
  std::array<Light, N> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) table[i] = decode_halves(2U * i + first);
  return table;
}

}  // namespace

Light decode(std::uint8_t code) {
  static const auto codes = make_table<256>(0);
  return codes[code];
}

std::uint8_t encode(Light light) {
  static const auto halves = make_table<255>(1);
  return static_cast<std::uint8_t>(std::upper_bound(halves.begin(), halves.end(), light) - halves.begin());
}

}  // namespace hal::sim
