// SPDX-License-Identifier: MIT
#include <hal/linux/screen_panel.hpp>

#include <algorithm>

namespace hal::linux_io {

namespace {

std::string text_of(std::uint64_t width, std::uint64_t height) {
  return std::to_string(width) + 'x' + std::to_string(height);
}

std::string text_of(Extent size) { return std::to_string(size.width) + 'x' + std::to_string(size.height); }

}  // namespace

void ScreenPanel::Picture::load(std::span<const std::uint8_t> rgb) noexcept {
  std::ranges::copy(rgb, colours.begin());
}

Extent ScreenPanel::checked_size(const DeviceFile& file, std::uint64_t width, std::uint64_t height) {
  constexpr std::uint64_t longest_side = 32'768;
  if (width < 1 || height < 1 || width > longest_side || height > longest_side)
    throw DeviceError(file.name() + ": its driver says " + text_of(width, height) +
                      " pixels, which no screen has");
  return {static_cast<int>(width), static_cast<int>(height)};
}

std::uint32_t ScreenPanel::likely_refresh(std::uint64_t millihertz) noexcept {
  return millihertz < 10'000 || millihertz > 500'000 ? 60'000U : static_cast<std::uint32_t>(millihertz);
}

void ScreenPanel::set_up(Extent asked, Extent screen, std::uint32_t refresh_millihertz, bool tells_vblanks) {
  const Extent size = asked == Extent{} ? screen : asked;
  if (size.width < 1 || size.height < 1 || size.width > screen.width || size.height > screen.height)
    throw DeviceError(name() + ": its screen has " + text_of(screen) + " pixels, too few for " +
                      text_of(size));
  placement_ = Placement(size, screen);
  capabilities_.width = size.width;
  capabilities_.height = size.height;
  capabilities_.bits_per_pixel = 8;
  capabilities_.palette_entries = 256;
  capabilities_.buffers = buffers;
  capabilities_.refresh_millihertz = refresh_millihertz;
  capabilities_.vblank_signal = tells_vblanks;
  const std::size_t bytes = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  memory_.assign(static_cast<std::size_t>(buffers) * bytes, 0);
  for (std::size_t i = 0; i < pictures_.size(); ++i)
    pictures_.at(i) = std::span(memory_).subspan(i * bytes, bytes);
  stride_ = size.width;
}

void ScreenPanel::draw_in(const std::array<std::span<std::uint8_t>, buffers>& pictures, int stride) noexcept {
  memory_ = {};
  pictures_ = pictures;
  stride_ = stride;
}

void ScreenPanel::draw(const Picture& picture, const PixelPalette& palette, std::span<std::uint8_t> screen,
                       std::size_t stride) const noexcept {
  placement_.draw(pictures_[static_cast<std::size_t>(picture.buffer)], palette, screen, stride);
}

}  // namespace hal::linux_io
