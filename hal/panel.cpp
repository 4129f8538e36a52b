// SPDX-License-Identifier: MIT
//
// The argument checks of `hal::Panel`, once for all drivers.
// Bit budget: rectangles are compared after checking that no side is negative and none exceeds the panel's,
// so x + width stays below 2^31 for panels up to 2^30 pixels wide; byte counts are formed in 64 bits.
#include <hal/panel.hpp>

namespace hal {

namespace {

bool multiple(int value, int of, int end) noexcept { return value % of == 0 || value == end; }

}  // namespace

std::span<std::uint8_t> Panel::buffer(int index) noexcept {
  if (index < 0 || index >= capabilities().buffers) return {};
  return do_buffer(index);
}

Status Panel::refuse(Error error, Part part) noexcept {
  const Status status(error, part);
  do_refused(status);
  return status;
}

Status Panel::check_palette(std::span<const std::uint8_t> palette) noexcept {
  const auto most = static_cast<std::size_t>(capabilities().palette_entries);
  if (palette.size() % 3U != 0 || palette.size() / 3U > most) return refuse(Error::invalid, Part::palette);
  return {};
}

Status Panel::show(int index, std::span<const std::uint8_t> palette) noexcept {
  const Capabilities& c = capabilities();
  if (c.buffers == 0) return refuse(Error::unsupported, Part::buffer);
  if (index < 0 || index >= c.buffers) return refuse(Error::invalid, Part::buffer);
  if (const Status s = check_palette(palette); !s.ok()) return s;
  return do_show(index, palette);
}

Status Panel::write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept {
  const Capabilities& c = capabilities();
  if (c.buffers != 0) return refuse(Error::unsupported, Part::buffer);
  if (area.x < 0 || area.y < 0 || area.width < 1 || area.height < 1 || area.x >= c.width ||
      area.y >= c.height || area.width > c.width - area.x || area.height > c.height - area.y)
    return refuse(Error::invalid, Part::rectangle);
  if (area.x % c.x_alignment != 0 || area.y % c.y_alignment != 0 ||
      !multiple(area.x + area.width, c.x_alignment, c.width) ||
      !multiple(area.y + area.height, c.y_alignment, c.height))
    return refuse(Error::misaligned, Part::rectangle);
  const auto row_bytes = (static_cast<std::int64_t>(area.width) * c.bits_per_pixel + 7) / 8;
  if (stride < row_bytes) return refuse(Error::invalid, Part::stride);
  const auto needed = static_cast<std::int64_t>(area.height - 1) * stride + row_bytes;
  if (static_cast<std::int64_t>(pixels.size()) < needed) return refuse(Error::invalid, Part::pixels);
  return do_write(area, pixels, stride);
}

Status Panel::load_palette(std::span<const std::uint8_t> palette) noexcept {
  const Capabilities& c = capabilities();
  if (c.palette_entries == 0) return refuse(Error::unsupported, Part::palette);
  if (const Status s = check_palette(palette); !s.ok()) return s;
  return do_load_palette(palette);
}

}  // namespace hal
