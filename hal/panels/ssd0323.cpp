// SPDX-License-Identifier: MIT
#include <hal/panels/ssd0323.hpp>

#include <array>

namespace hal::panels {

namespace {

namespace cmd {
constexpr std::uint8_t column_window = 0x15;
constexpr std::uint8_t row_window = 0x75;
constexpr std::uint8_t contrast = 0x81;
constexpr std::uint8_t full_current = 0x86;
constexpr std::uint8_t remap = 0xA0;
constexpr std::uint8_t start_line = 0xA1;
constexpr std::uint8_t offset = 0xA2;
constexpr std::uint8_t normal_display = 0xA4;
constexpr std::uint8_t multiplex_ratio = 0xA8;
constexpr std::uint8_t master_configuration = 0xAD;
constexpr std::uint8_t display_off = 0xAE;
constexpr std::uint8_t display_on = 0xAF;
constexpr std::uint8_t phase_length = 0xB1;
constexpr std::uint8_t row_period = 0xB2;
constexpr std::uint8_t clock_divide = 0xB3;
constexpr std::uint8_t grey_table = 0xB8;
constexpr std::uint8_t precharge_voltage = 0xBC;
constexpr std::uint8_t vcomh = 0xBE;
constexpr std::uint8_t segment_low_voltage = 0xBF;
}  // namespace cmd

// Nibble remap (high nibble left), COM remap, COM split odd/even; addresses run along the row.
constexpr std::uint8_t remap_bits = 0x02 | 0x10 | 0x40;

/// 0, 17, 34 … 255.
constexpr auto greys = [] {
  std::array<std::uint8_t, 48> colours{};
  for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = static_cast<std::uint8_t>(i / 3 * 17);
  return colours;
}();

Capabilities capabilities_of(const Ssd0323Options& options) noexcept {
  return {.width = Ssd0323::width,
          .height = Ssd0323::height,
          .bits_per_pixel = 4,
          .bit_order = BitOrder::msb_first,
          .fixed_palette = greys,
          .x_alignment = 2,
          .refresh_millihertz = options.refresh_millihertz};
}

}  // namespace

Ssd0323::Ssd0323(CommandPort& port, Clock* frame_clock, const Ssd0323Options& options) noexcept
    : WritePanel(capabilities_of(options), frame_clock), port_(&port), options_(options) {}

Status Ssd0323::start() noexcept {
  // The voltages and timings are those the maker of the 128x64 glass gives for it.
  // clang-format off
  const auto setup = std::to_array<std::uint8_t>({
      cmd::display_off,
      cmd::clock_divide, 0x91,
      cmd::multiplex_ratio, height - 1,
      cmd::offset, options_.offset,
      cmd::start_line, 0,
      cmd::master_configuration, 0x02,
      cmd::remap, remap_bits,
      cmd::full_current,
      cmd::grey_table, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76,
      cmd::contrast, options_.contrast,
      cmd::row_period, 0x51,
      cmd::phase_length, 0x55,
      cmd::precharge_voltage, 0x10,
      cmd::vcomh, 0x1C,
      cmd::segment_low_voltage, 0x0F,
      cmd::normal_display,
  });
  // clang-format on
  if (const Status s = port_->command(setup); !s.ok()) return s;
  // The memory holds noise; it is cleared before anyone sees it.
  if (const Status s = set_window({0, 0, width, height}); !s.ok()) return s;
  constexpr std::array<std::uint8_t, width / 2> black{};
  for (int y = 0; y < height; ++y)
    if (const Status s = port_->data(black); !s.ok()) return s;
  constexpr std::array<std::uint8_t, 1> on{cmd::display_on};
  return port_->command(on);
}

Status Ssd0323::set_window(const Rect& area) noexcept {
  const std::array<std::uint8_t, 6> window{cmd::column_window,
                                           static_cast<std::uint8_t>(area.x / 2),
                                           static_cast<std::uint8_t>((area.x + area.width) / 2 - 1),
                                           cmd::row_window,
                                           static_cast<std::uint8_t>(area.y),
                                           static_cast<std::uint8_t>(area.y + area.height - 1)};
  return port_->command(window);
}

Status Ssd0323::do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept {
  if (const Status s = set_window(area); !s.ok()) return s;
  const auto row_bytes = static_cast<std::size_t>(area.width / 2);
  const auto step = static_cast<std::size_t>(stride);
  // Rows that lie close together go out in one transfer.
  if (step == row_bytes) return port_->data(pixels.first(row_bytes * static_cast<std::size_t>(area.height)));
  for (std::size_t y = 0; y < static_cast<std::size_t>(area.height); ++y)
    if (const Status s = port_->data(pixels.subspan(y * step, row_bytes)); !s.ok()) return s;
  return {};
}

}  // namespace hal::panels
