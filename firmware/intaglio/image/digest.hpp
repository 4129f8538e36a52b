// SPDX-License-Identifier: MIT
//
// Digests of frames: one number that says whether two machines drew the same picture.
//
// Rule: CRC-32 as in Ethernet, zip and PNG (reflected polynomial 0xEDB88320, register starts and ends
// inverted) over: width and height as 32-bit little-endian numbers, the palette's bytes RGBRGB..., then one
// byte a pixel, its index, row by row from the top. Format, bit order, stride and padding don't count: the
// same picture has the same digest however it is stored, and however it is cut into bands.
//
// Four bits a step from a table of 64 bytes: about 10 instructions a byte. Check value: "123456789" gives
// 0xCBF43926.
#pragma once

#include <intaglio/image/surface.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::image {

/// CRC-32 of a stream of bytes.
class Crc32 {
 public:
  constexpr void add(std::uint8_t byte) noexcept {
    state_ ^= byte;
    state_ = state_ >> 4U ^ table[state_ & 15U];
    state_ = state_ >> 4U ^ table[state_ & 15U];
  }
  constexpr void add(std::span<const std::uint8_t> bytes) noexcept {
    for (const std::uint8_t byte : bytes) add(byte);
  }
  /// The checksum of all bytes so far.
  [[nodiscard]] constexpr std::uint32_t value() const noexcept { return ~state_; }

 private:
  static constexpr auto table = [] {
    constexpr std::uint32_t polynomial = 0xEDB88320U;
    std::array<std::uint32_t, 16> entries{};
    for (std::uint32_t nibble = 0; nibble < 16; ++nibble) {
      std::uint32_t state = nibble;
      for (int bit = 0; bit < 4; ++bit) state = (state & 1U) != 0 ? state >> 1U ^ polynomial : state >> 1U;
      entries[nibble] = state;
    }
    return entries;
  }();

  std::uint32_t state_ = 0xFFFFFFFFU;
};

/// The digest of a frame that arrives whole or in bands.
class FrameDigest {
 public:
  /// Starts the digest of a frame of this size, shown with this palette.
  constexpr FrameDigest(linear::Size size, std::span<const std::uint8_t> palette_rgb) noexcept {
    add_number(static_cast<std::uint32_t>(size.width));
    add_number(static_cast<std::uint32_t>(size.height));
    crc_.add(palette_rgb);
  }

  /// Adds the next rows of the frame, from the top.
  template <PixelFormat F, class Byte>
  constexpr void add(const PixelView<F, Byte>& rows) noexcept {
    const linear::Rect& b = rows.bounds();
    for (int y = b.y; y < b.bottom(); ++y)
      for (int x = b.x; x < b.right(); ++x) crc_.add(static_cast<std::uint8_t>(rows.get(x, y)));
  }

  /// The digest of what was added so far.
  [[nodiscard]] constexpr std::uint32_t value() const noexcept { return crc_.value(); }

 private:
  constexpr void add_number(std::uint32_t number) noexcept {
    for (unsigned shift = 0; shift < 32; shift += 8) crc_.add(static_cast<std::uint8_t>(number >> shift));
  }

  Crc32 crc_;
};

/// The digest of a whole frame.
template <PixelFormat F, class Byte>
[[nodiscard]] constexpr std::uint32_t digest(const PixelView<F, Byte>& frame,
                                             std::span<const std::uint8_t> palette_rgb) noexcept {
  FrameDigest result(frame.size(), palette_rgb);
  result.add(frame);
  return result.value();
}

}  // namespace intaglio::image
