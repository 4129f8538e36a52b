// SPDX-License-Identifier: MIT
//
// Oracle: CRC-32 by polynomial division, a bit at a time, and the digest of a frame spelled out.
#pragma once

#include <cstdint>
#include <vector>

namespace oracle {

inline std::uint32_t crc32(const std::vector<std::uint8_t>& bytes) {
  std::uint32_t remainder = 0xFFFFFFFFU;
  for (const std::uint8_t byte : bytes)
    for (unsigned bit = 0; bit < 8; ++bit) {
      const bool carry = ((remainder ^ static_cast<std::uint32_t>(byte) >> bit) & 1U) != 0;
      remainder >>= 1U;
      if (carry) remainder ^= 0xEDB88320U;
    }
  return remainder ^ 0xFFFFFFFFU;
}

/// Width, height (little-endian), palette, then one byte a pixel.
inline std::uint32_t frame_digest(std::uint32_t width, std::uint32_t height,
                                  const std::vector<std::uint8_t>& palette,
                                  const std::vector<std::uint8_t>& indices) {
  std::vector<std::uint8_t> stream;
  for (const std::uint32_t number : {width, height})
    for (const std::uint32_t divisor : {1U, 256U, 65536U, 16777216U})
      stream.push_back(static_cast<std::uint8_t>(number / divisor % 256U));
  stream.insert(stream.end(), palette.begin(), palette.end());
  stream.insert(stream.end(), indices.begin(), indices.end());
  return crc32(stream);
}

}  // namespace oracle
