// SPDX-License-Identifier: MIT
//
// The checksum of the report protocol: CRC-32 as in Ethernet, zip and PNG (reflected polynomial 0xEDB88320,
// register starts and ends inverted). Check value: "123456789" gives 0xCBF43926.
//
// Four bits a step from a table of 64 bytes: about 10 instructions a byte.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace hal::hid {

class Crc32 {
 public:
  constexpr void add(std::span<const std::uint8_t> bytes) noexcept {
    for (const std::uint8_t byte : bytes) {
      state_ ^= byte;
      state_ = state_ >> 4U ^ table[state_ & 15U];
      state_ = state_ >> 4U ^ table[state_ & 15U];
    }
  }
  /// The checksum of all bytes so far.
  [[nodiscard]] constexpr std::uint32_t value() const noexcept { return ~state_; }

 private:
  static constexpr auto table = [] {
    std::array<std::uint32_t, 16> entries{};
    for (std::uint32_t nibble = 0; nibble < 16; ++nibble) {
      std::uint32_t state = nibble;
      for (int bit = 0; bit < 4; ++bit) state = (state & 1U) != 0 ? state >> 1U ^ 0xEDB88320U : state >> 1U;
      entries[nibble] = state;
    }
    return entries;
  }();

  std::uint32_t state_ = 0xFFFFFFFFU;
};

}  // namespace hal::hid
