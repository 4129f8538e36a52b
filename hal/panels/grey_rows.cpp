// SPDX-License-Identifier: MIT
#include <hal/panels/grey_rows.hpp>

namespace hal::panels {

namespace {

constexpr int chunk = 64;

/// Column `x` of the picture as bytes of the memory, two rows each.
Status send_column(CommandPort& port, int x, int height, std::span<const std::uint8_t> pixels,
                   std::size_t step) noexcept {
  const auto byte = static_cast<std::size_t>(x / 2);
  const unsigned shift = x % 2 == 0 ? 4 : 0;
  const auto grey = [&](int y) {
    return static_cast<unsigned>(pixels[static_cast<std::size_t>(y) * step + byte]) >> shift & 15U;
  };
  for (int y = 0; y < height; y += 2 * chunk) {
    std::array<std::uint8_t, chunk> bytes{};
    std::size_t count = 0;
    for (int pair = y; pair < height && count < bytes.size(); pair += 2)
      bytes[count++] = static_cast<std::uint8_t>(grey(pair) << 4U | grey(pair + 1));
    if (const Status s = port.data(std::span(bytes).first(count)); !s.ok()) return s;
  }
  return {};
}

}  // namespace

Status send_greys(CommandPort& port, int width, int height, std::span<const std::uint8_t> pixels, int stride,
                  bool turned) noexcept {
  const auto step = static_cast<std::size_t>(stride);
  if (turned) {
    for (int x = 0; x < width; ++x)
      if (const Status s = send_column(port, x, height, pixels, step); !s.ok()) return s;
    return {};
  }
  const auto row_bytes = static_cast<std::size_t>(width / 2);
  const auto rows = static_cast<std::size_t>(height);
  // Rows that lie close together go out in one transfer.
  if (step == row_bytes) return port.data(pixels.first(row_bytes * rows));
  for (std::size_t y = 0; y < rows; ++y)
    if (const Status s = port.data(pixels.subspan(y * step, row_bytes)); !s.ok()) return s;
  return {};
}

Status send_black(CommandPort& port, int bytes) noexcept {
  constexpr std::array<std::uint8_t, chunk> black{};
  for (; bytes > 0; bytes -= chunk) {
    const auto count = static_cast<std::size_t>(bytes < chunk ? bytes : chunk);
    if (const Status s = port.data(std::span(black).first(count)); !s.ok()) return s;
  }
  return {};
}

}  // namespace hal::panels
