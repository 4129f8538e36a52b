// SPDX-License-Identifier: MIT
#include <hal/sim/effects/scan.hpp>

namespace hal::sim {

std::span<const std::uint8_t> line_pixels(const Capabilities& c, std::span<const std::uint8_t> memory,
                                          int stride, int line, std::vector<std::uint8_t>& column) {
  const auto bytes = static_cast<std::size_t>(stride);
  const auto bytes_of_line = static_cast<std::size_t>(line_bytes(c));
  if (c.scan == ScanDirection::down)
    return memory.subspan(static_cast<std::size_t>(line) * bytes, bytes_of_line);
  note_call(Effect::scan);
  const int place = place_of(c, line);
  if (!by_columns(c.scan)) return memory.subspan(static_cast<std::size_t>(place) * bytes, bytes_of_line);
  column.assign(bytes_of_line, 0);
  for (int y = 0; y < c.height; ++y) {
    const auto row = memory.subspan(static_cast<std::size_t>(y) * bytes);
    if (c.palette_on_write) {
      for (std::size_t i = 0; i < 3; ++i)
        column[3U * static_cast<std::size_t>(y) + i] = row[3U * static_cast<std::size_t>(place) + i];
    } else {
      set_pixel(column, y, c.bits_per_pixel, c.bit_order,
                pixel_at(row, place, c.bits_per_pixel, c.bit_order));
    }
  }
  return column;
}

}  // namespace hal::sim
