// SPDX-License-Identifier: MIT
#include <hal/linux/scaling.hpp>

#include <algorithm>

namespace hal::linux_io {

namespace {

std::uint32_t placed(std::uint8_t value, const PixelLayout::Channel& channel) noexcept {
  // Of a channel with more bits the upper ones.
  const unsigned bits = std::min(channel.bits, 8U);
  return static_cast<std::uint32_t>(value) >> (8U - bits) << (channel.shift + channel.bits - bits);
}

void put(std::uint8_t* at, std::uint32_t pixel, int bytes) noexcept {
  for (int i = 0; i < bytes; ++i, pixel >>= 8U) at[i] = static_cast<std::uint8_t>(pixel & 0xFFU);
}

}  // namespace

bool PixelLayout::possible() const noexcept {
  const auto inside = [size = static_cast<unsigned>(bytes) * 8U](const Channel& channel) {
    return channel.bits <= size && channel.shift <= size - channel.bits && channel.shift < size;
  };
  return inside(red) && inside(green) && inside(blue);
}

PixelPalette::PixelPalette(const PixelLayout& layout, std::span<const std::uint8_t> rgb) noexcept
    : bytes_(layout.bytes) {
  const std::size_t entries = std::min(rgb.size() / 3U, pixels_.size());
  for (std::size_t i = 0; i < entries; ++i)
    pixels_[i] = placed(rgb[3U * i], layout.red) | placed(rgb[3U * i + 1U], layout.green) |
                 placed(rgb[3U * i + 2U], layout.blue);
}

PixelPalette PixelPalette::indices() noexcept {
  PixelPalette themselves(1);
  for (std::uint32_t i = 0; i < 256; ++i) themselves.pixels_[i] = i;
  return themselves;
}

Placement::Placement(Extent picture, Extent screen) noexcept
    : picture_(picture),
      scale_(std::max(1, std::min(screen.width / picture.width, screen.height / picture.height))),
      left_((screen.width - picture.width * scale_) / 2),
      top_((screen.height - picture.height * scale_) / 2) {}

void Placement::draw(std::span<const std::uint8_t> indices, const PixelPalette& palette,
                     std::span<std::uint8_t> screen, std::size_t screen_stride) const noexcept {
  const int bytes = palette.bytes();
  const auto width = static_cast<std::size_t>(picture_.width);
  const std::size_t row_bytes = width * static_cast<std::size_t>(scale_ * bytes);
  for (int y = 0; y < picture_.height; ++y) {
    std::uint8_t* const row = screen.data() + static_cast<std::size_t>(top_ + y * scale_) * screen_stride +
                              static_cast<std::size_t>(left_ * bytes);
    const std::span<const std::uint8_t> from = indices.subspan(static_cast<std::size_t>(y) * width, width);
    std::uint8_t* at = row;
    for (const std::uint8_t index : from) {
      const std::uint32_t pixel = palette.pixel(index);
      for (int i = 0; i < scale_; ++i, at += bytes) put(at, pixel, bytes);
    }
    for (int i = 1; i < scale_; ++i)
      std::copy_n(row, row_bytes, row + static_cast<std::size_t>(i) * screen_stride);
  }
}

}  // namespace hal::linux_io
