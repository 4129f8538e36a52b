// SPDX-License-Identifier: MIT
#include <hal/panels/expanded_panel.hpp>

#include <algorithm>

namespace hal::panels {

namespace {

Capabilities in_front_of(const Capabilities& inner) noexcept {
  Capabilities c = inner;
  c.bits_per_pixel = 8;
  c.bit_order = BitOrder::msb_first;
  c.palette_entries = 256;
  c.palette_bits = 8;
  c.palette_on_write = true;
  c.fixed_palette = {};
  return c;
}

bool expandable(const Capabilities& c) noexcept {
  const int bits = c.bits_per_pixel;
  return c.buffers == 0 && c.palette_entries == 0 && (bits == 1 || bits == 2 || bits == 4) &&
         c.fixed_palette.size() == std::size_t{3} << static_cast<unsigned>(bits);
}

std::size_t row_bytes(int width, int bits) noexcept {
  return (static_cast<std::size_t>(width) * static_cast<std::size_t>(bits) + 7U) / 8U;
}

}  // namespace

ExpandedPanel::ExpandedPanel(Panel& inner, std::span<std::uint8_t> workspace) noexcept
    : BufferlessPanel(in_front_of(inner.capabilities())), inner_(&inner), workspace_(workspace) {}

Status ExpandedPanel::do_load_palette(std::span<const std::uint8_t> palette) noexcept {
  for (std::size_t i = 0; i < palette.size() / 3; ++i)
    greys_[i] = grey_of(palette[3 * i], palette[3 * i + 1], palette[3 * i + 2]);
  return {};
}

unsigned ExpandedPanel::level(unsigned grey, int x, int y) const noexcept {
  const Capabilities& c = inner_->capabilities();
  const unsigned most = (1U << static_cast<unsigned>(c.bits_per_pixel)) - 1U;
  const unsigned up = most == 1 ? (dithered(grey, x, y) ? 1U : 0U) : (grey * most + 127U) / 255U;
  return c.fixed_palette.front() > c.fixed_palette.back() ? most - up : up;
}

Status ExpandedPanel::do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept {
  const Capabilities& c = inner_->capabilities();
  if (!expandable(c)) return {Error::unsupported, Part::panel};
  // Whole rows of blocks if one fits, else pieces of one.
  const std::size_t least_height = static_cast<std::size_t>(std::min(c.y_alignment, area.height));
  const std::size_t most_bytes = workspace_.size() / least_height;
  const int block_bits = c.x_alignment * c.bits_per_pixel;
  int columns = area.width;
  if (row_bytes(area.width, c.bits_per_pixel) > most_bytes) {
    columns = static_cast<int>(most_bytes * 8U) / block_bits * c.x_alignment;
    // The last piece may be narrower than a block, but none begins inside one.
    if (columns == 0) return {Error::invalid, Part::buffer};
  }
  const auto bytes = row_bytes(columns, c.bits_per_pixel);
  // No more than there are, so that the product fits.
  const std::size_t blocks =
      std::min(workspace_.size() / (bytes * least_height), static_cast<std::size_t>(area.height));
  const int rows = std::max(static_cast<int>(blocks) * c.y_alignment, 1);
  for (int y = 0; y < area.height; y += rows) {
    const auto start = static_cast<std::size_t>(y) * static_cast<std::size_t>(stride);
    for (int x = 0; x < area.width; x += columns) {
      const Rect part{area.x + x, area.y + y, std::min(columns, area.width - x),
                      std::min(rows, area.height - y)};
      if (const Status s = write_part(part, pixels.subspan(start), stride, x); !s.ok()) return s;
    }
  }
  return {};
}

Status ExpandedPanel::write_part(const Rect& part, std::span<const std::uint8_t> pixels, int stride,
                                 int first) noexcept {
  const Capabilities& c = inner_->capabilities();
  const auto bits = static_cast<unsigned>(c.bits_per_pixel);
  const auto bytes = row_bytes(part.width, c.bits_per_pixel);
  const auto used = workspace_.first(bytes * static_cast<std::size_t>(part.height));
  std::ranges::fill(used, std::uint8_t{0});
  for (int y = 0; y < part.height; ++y) {
    const auto source =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(stride) + static_cast<std::size_t>(first);
    const auto target = static_cast<std::size_t>(y) * bytes;
    for (int x = 0; x < part.width; ++x) {
      const unsigned grey = greys_[pixels[source + static_cast<std::size_t>(x)]];
      const unsigned bit = static_cast<unsigned>(x) * bits;
      const unsigned shift = c.bit_order == BitOrder::msb_first ? 8U - bits - bit % 8U : bit % 8U;
      std::uint8_t& byte = used[target + bit / 8U];
      byte = static_cast<std::uint8_t>(byte | level(grey, part.x + x, part.y + y) << shift);
    }
  }
  return inner_->write(part, used, static_cast<int>(bytes));
}

}  // namespace hal::panels
