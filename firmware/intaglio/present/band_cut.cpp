// SPDX-License-Identifier: MIT
#include <intaglio/present/band_cut.hpp>

#include <algorithm>

namespace intaglio::present {

namespace {

int row_bytes(int width, int bits) noexcept { return (width * bits + 7) / 8; }

/// The least number of columns that can be sent alone: whole bytes, aligned.
int least_columns(const hal::Capabilities& panel, int bits) noexcept {
  int columns = panel.x_alignment;
  while (columns * bits % 8 != 0) columns += panel.x_alignment;
  return std::min(columns, panel.width);
}

}  // namespace

int band_rows(const hal::Capabilities& panel, int stride, std::size_t memory) noexcept {
  const std::size_t fitting = memory / static_cast<std::size_t>(stride);
  if (fitting >= static_cast<std::size_t>(panel.height)) return panel.height;
  const int rows = static_cast<int>(fitting);
  return rows - rows % panel.y_alignment;
}

linear::Rect BandCut::band(const hal::Capabilities& panel, int step) const noexcept {
  const int first = (backwards ? count - 1 - step : step) * lines;
  if (columns) return {first, 0, std::min(lines, panel.width - first), panel.height};
  return {0, first, panel.width, std::min(lines, panel.height - first)};
}

int BandCut::first_scanned(const hal::Capabilities& panel, int step) const noexcept {
  const linear::Rect r = band(panel, step);
  if (columns) return backwards ? panel.width - r.right() : r.x;
  return backwards ? panel.height - r.bottom() : r.y;
}

BandSizes BandCut::sizes(const hal::Capabilities& panel) const noexcept {
  return {columns ? panel.width : panel.height, lines_of(band(panel, 0)), lines};
}

BandCut rows_from_top(const hal::Capabilities& panel, int bits_per_pixel, std::size_t memory) noexcept {
  BandCut cut;
  cut.lines = band_rows(panel, row_bytes(panel.width, bits_per_pixel), memory);
  if (cut.lines > 0) cut.count = (panel.height - 1) / cut.lines + 1;
  return cut;
}

BandCut along_scan(const hal::Capabilities& panel, int bits_per_pixel, std::size_t memory) noexcept {
  using hal::ScanDirection;
  BandCut cut;
  if (panel.scan == ScanDirection::down || panel.scan == ScanDirection::up) {
    cut = rows_from_top(panel, bits_per_pixel, memory);
  } else {
    const auto all = static_cast<std::size_t>(row_bytes(panel.width, bits_per_pixel) * panel.height);
    const auto groups = static_cast<int>(std::min(memory, all) / least_memory(panel, bits_per_pixel, true));
    // The last group may be narrower, so all may fit where as many whole groups don't.
    cut.lines = memory < all ? groups * least_columns(panel, bits_per_pixel) : panel.width;
    cut.columns = true;
    if (cut.lines > 0) cut.count = (panel.width - 1) / cut.lines + 1;
  }
  cut.backwards = panel.scan == ScanDirection::up || panel.scan == ScanDirection::left;
  return cut;
}

BandCut cut_along_scan(const hal::Capabilities& panel, int bits_per_pixel, int lines) noexcept {
  using hal::ScanDirection;
  const bool columns = panel.scan == ScanDirection::left || panel.scan == ScanDirection::right;
  const int bytes = columns ? (lines * bits_per_pixel + 7) / 8 * panel.height
                            : lines * row_bytes(panel.width, bits_per_pixel);
  return along_scan(
      panel, bits_per_pixel,
      std::max<std::size_t>(static_cast<std::size_t>(bytes), least_memory(panel, bits_per_pixel, columns)));
}

std::uint32_t least_memory(const hal::Capabilities& panel, int bits_per_pixel, bool columns) noexcept {
  const int bytes = columns
                        ? row_bytes(least_columns(panel, bits_per_pixel), bits_per_pixel) * panel.height
                        : row_bytes(panel.width, bits_per_pixel) * std::min(panel.y_alignment, panel.height);
  return static_cast<std::uint32_t>(bytes);
}

}  // namespace intaglio::present
