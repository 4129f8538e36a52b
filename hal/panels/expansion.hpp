// SPDX-License-Identifier: MIT
//
// Palettes applied while pixels are sent: a program draws indices, a panel takes colours.
//
// Rules:
// - RGB565: each channel is rounded to the nearest of its 32 or 64 levels, halves up; high byte first.
// - Grey: luma of Rec. 709 in 1/256 (54, 183 and 19 for red, green and blue), then the nearest level.
// - Dither: a pixel is lit if the light of its grey exceeds the threshold of its place in an 8x8 Bayer
//   matrix (book 11.2.1), which repeats over the panel from its corner; so what a place shows depends on
//   colour and place alone, and neighbouring partial writes fit. Light of grey g is (g/255)^2 * (0.71 + 0.29
//   * g/255), within 0.4 % of full light of the sRGB curve.
// Bit budget: the largest product is 255^3 * 256, below 2^32.
#pragma once

#include <hal/panel.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace hal::panels {

/// A row of indices of 1, 2, 4 or 8 bits.
struct IndexRow {
  std::span<const std::uint8_t> bytes;
  int bits = 8;
  BitOrder order = BitOrder::msb_first;

  /// Index `x`; it lies in the row.
  [[nodiscard]] constexpr unsigned at(int x) const noexcept {
    const auto bit = static_cast<unsigned>(x) * static_cast<unsigned>(bits);
    const auto width = static_cast<unsigned>(bits);
    const unsigned place = order == BitOrder::msb_first ? 8U - width - bit % 8U : bit % 8U;
    return static_cast<unsigned>(bytes[bit / 8U]) >> place & ((1U << width) - 1U);
  }
};

[[nodiscard]] constexpr std::uint16_t rgb565(unsigned red, unsigned green, unsigned blue) noexcept {
  const auto level = [](unsigned channel, unsigned most) { return (channel * most + 127U) / 255U; };
  return static_cast<std::uint16_t>(level(red, 31) << 11U | level(green, 63) << 5U | level(blue, 31));
}

/// Luma of a colour, 0..255.
[[nodiscard]] constexpr std::uint8_t grey_of(unsigned red, unsigned green, unsigned blue) noexcept {
  return static_cast<std::uint8_t>((54U * red + 183U * green + 19U * blue + 128U) >> 8U);
}

/// Light that grey 0..255 means, in 1/65280 of white's; rounded down.
[[nodiscard]] constexpr unsigned light_of(unsigned grey) noexcept {
  return grey * grey * (181U + 74U * grey / 255U) * 256U / (255U * 255U);
}

/// Threshold of a place, 0..63: every value once in 8x8 places.
[[nodiscard]] constexpr unsigned bayer_threshold(int x, int y) noexcept {
  const unsigned rows = static_cast<unsigned>(y);
  const unsigned mixed = rows ^ static_cast<unsigned>(x);
  unsigned threshold = 0;
  for (unsigned bit = 0; bit < 3; ++bit)
    threshold = threshold << 2U | (mixed >> bit & 1U) << 1U | (rows >> bit & 1U);
  return threshold;
}

/// True if the dithered pixel at (x, y) of the panel is lit: with none at grey 0, with all at 255.
[[nodiscard]] constexpr bool dithered(unsigned grey, int x, int y) noexcept {
  return light_of(grey) * 64U > bayer_threshold(x, y) * 65280U + 32640U;
}

/// Colours as a TFT takes them.
class Rgb565Palette {
 public:
  /// Colours from entry 0 on, 3 bytes each, at most 256.
  void load(std::span<const std::uint8_t> colours) noexcept {
    for (std::size_t i = 0; i < colours.size() / 3; ++i)
      words_[i] = rgb565(colours[3 * i], colours[3 * i + 1], colours[3 * i + 2]);
  }
  /// Writes pixels `first` to `first` + `count` - 1 of a row, two bytes each.
  void expand(const IndexRow& row, int first, int count, std::span<std::uint8_t> out) const noexcept {
    for (int i = 0; i < count; ++i) {
      const unsigned word = words_[row.at(first + i)];
      out[2 * static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(word >> 8U);
      out[2 * static_cast<std::size_t>(i) + 1] = static_cast<std::uint8_t>(word & 255U);
    }
  }

 private:
  std::array<std::uint16_t, 256> words_{};
};

}  // namespace hal::panels
