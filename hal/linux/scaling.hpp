// SPDX-License-Identifier: MIT
//
// How a picture of palette indices lies on a screen of real colours: enlarged by a whole number, in the
// middle.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace hal::linux_io {

/// Where the bits of a colour are in a pixel of 16, 24 or 32 bits.
struct PixelLayout {
  struct Channel {
    unsigned shift = 0;
    unsigned bits = 8;
  };
  int bytes = 4;
  Channel red{16, 8};
  Channel green{8, 8};
  Channel blue{0, 8};

  /// False: a channel isn't inside the pixel.
  [[nodiscard]] bool possible() const noexcept;
};

/// What 256 indices are in pixels of a layout.
class PixelPalette {
 public:
  /// The colours of entries from 0 on, RGBRGB…; the others are 0. The layout is `possible`.
  PixelPalette(const PixelLayout& layout, std::span<const std::uint8_t> rgb) noexcept;
  /// Pixels that are looked up: a byte that is its own index.
  static PixelPalette indices() noexcept;
  [[nodiscard]] std::uint32_t pixel(std::uint8_t index) const noexcept { return pixels_[index]; }
  /// Bytes of a pixel.
  [[nodiscard]] int bytes() const noexcept { return bytes_; }

 private:
  explicit PixelPalette(int bytes) noexcept : bytes_(bytes) {}
  int bytes_;
  std::array<std::uint32_t, 256> pixels_{};
};

struct Extent {
  int width = 0;
  int height = 0;
  friend bool operator==(const Extent&, const Extent&) = default;
};

/// Where a picture lies on a screen that is at least as large.
class Placement {
 public:
  /// Neither is empty.
  Placement(Extent picture, Extent screen) noexcept;
  [[nodiscard]] int scale() const noexcept { return scale_; }
  [[nodiscard]] Extent picture() const noexcept { return picture_; }

  /// Puts the whole picture (a byte a pixel, rows close together) on the screen; what is around it stays.
  void draw(std::span<const std::uint8_t> indices, const PixelPalette& palette,
            std::span<std::uint8_t> screen, std::size_t screen_stride) const noexcept;

 private:
  Extent picture_;
  int scale_;
  int left_;
  int top_;
};

}  // namespace hal::linux_io
