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
constexpr std::uint8_t inverse_display = 0xA7;
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

// Bits of the remap register; addresses run along the row, and the rows are split odd and even.
constexpr unsigned remap_columns = 0x01;
constexpr unsigned remap_nibbles = 0x02;
constexpr unsigned remap_rows = 0x10;
constexpr unsigned split_rows = 0x40;

/// Turned by none: the high nibble is left and rows are remapped. Columns are mirrored by remapping columns
/// and nibbles both.
constexpr std::array<std::uint8_t, 4> remap_bits{split_rows | remap_nibbles | remap_rows,
                                                 split_rows | remap_columns | remap_rows,
                                                 split_rows | remap_columns, split_rows | remap_nibbles};

bool valid(const Ssd0323Options& o) noexcept {
  return o.contrast <= 127 && o.offset <= 79 && o.refresh_millihertz >= 1 && o.rotation <= Rotation::by_270;
}

/// Options that do no harm until `start` refuses them.
Ssd0323Options harmless(const Ssd0323Options& options) noexcept {
  return valid(options) ? options : Ssd0323Options{};
}

Capabilities capabilities_of(const Ssd0323Options& o) noexcept {
  return grey_capabilities(Ssd0323::width, Ssd0323::height, 2, o.rotation, o.refresh_millihertz);
}

}  // namespace

Ssd0323::Ssd0323(CommandPort& port, Clock* frame_clock, const Ssd0323Options& options) noexcept
    : BusPanel(capabilities_of(harmless(options)), frame_clock),
      port_(port),
      options_(harmless(options)),
      valid_(valid(options)) {}

Status Ssd0323::do_start() noexcept {
  if (!valid_) return {Error::invalid, Part::panel};
  // The voltages and timings are those the maker of the 128x64 glass gives for it.
  // clang-format off
  const auto setup = std::to_array<std::uint8_t>({
      cmd::display_off,
      cmd::clock_divide, 0x91,
      cmd::multiplex_ratio, height - 1,
      cmd::offset, options_.offset,
      cmd::start_line, 0,
      cmd::master_configuration, 0x02,
      cmd::remap, remap_bits[static_cast<std::size_t>(options_.rotation)],
      cmd::full_current,
      cmd::grey_table, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76,
      cmd::contrast, options_.contrast,
      cmd::row_period, 0x51,
      cmd::phase_length, 0x55,
      cmd::precharge_voltage, 0x10,
      cmd::vcomh, 0x1C,
      cmd::segment_low_voltage, 0x0F,
      options_.negative ? cmd::inverse_display : cmd::normal_display,
  });
  // clang-format on
  if (const Status s = port_.command(setup); !s.ok()) return s;
  // The memory holds noise; it is cleared before anyone sees it.
  const Capabilities& c = capabilities();
  if (const Status s = set_window({0, 0, c.width, c.height}); !s.ok()) return s;
  if (const Status s = send_black(port_.port(), width * height / 2); !s.ok()) return s;
  return do_sleep(false);
}

Status Ssd0323::do_sleep(bool asleep) noexcept {
  const std::uint8_t code = asleep ? cmd::display_off : cmd::display_on;
  return port_.command({&code, 1});
}

Status Ssd0323::do_set_contrast(std::uint8_t contrast) noexcept {
  const std::array<std::uint8_t, 2> command{cmd::contrast, static_cast<std::uint8_t>(contrast / 2)};
  return port_.command(command);
}

Status Ssd0323::set_window(const Rect& area) noexcept {
  const Rect r = swaps_sides(options_.rotation) ? Rect{area.y, area.x, area.height, area.width} : area;
  const std::array<std::uint8_t, 6> window{cmd::column_window,
                                           static_cast<std::uint8_t>(r.x / 2),
                                           static_cast<std::uint8_t>((r.x + r.width) / 2 - 1),
                                           cmd::row_window,
                                           static_cast<std::uint8_t>(r.y),
                                           static_cast<std::uint8_t>(r.y + r.height - 1)};
  return port_.command(window);
}

Status Ssd0323::do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept {
  if (const Status s = set_window(area); !s.ok()) return s;
  return send_greys(port_.port(), area.width, area.height, pixels, stride, swaps_sides(options_.rotation));
}

}  // namespace hal::panels
