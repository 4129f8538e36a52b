// SPDX-License-Identifier: MIT
#include <hal/panels/expansion.hpp>
#include <hal/panels/ssd1322.hpp>

namespace hal::panels {

namespace {

namespace cmd {
constexpr std::uint8_t use_grey_table = 0x00;
constexpr std::uint8_t column_window = 0x15;
constexpr std::uint8_t memory_write = 0x5C;
constexpr std::uint8_t row_window = 0x75;
constexpr std::uint8_t remap = 0xA0;
constexpr std::uint8_t start_line = 0xA1;
constexpr std::uint8_t offset = 0xA2;
constexpr std::uint8_t normal_display = 0xA6;
constexpr std::uint8_t inverse_display = 0xA7;
constexpr std::uint8_t whole_display = 0xA9;
constexpr std::uint8_t internal_supply = 0xAB;
constexpr std::uint8_t display_off = 0xAE;
constexpr std::uint8_t display_on = 0xAF;
constexpr std::uint8_t phase_length = 0xB1;
constexpr std::uint8_t clock_divide = 0xB3;
constexpr std::uint8_t enhancement_a = 0xB4;
constexpr std::uint8_t free_pins = 0xB5;
constexpr std::uint8_t second_precharge = 0xB6;
constexpr std::uint8_t grey_table = 0xB8;
constexpr std::uint8_t precharge_voltage = 0xBB;
constexpr std::uint8_t vcomh = 0xBE;
constexpr std::uint8_t contrast = 0xC1;
constexpr std::uint8_t master_current = 0xC7;
constexpr std::uint8_t multiplex_ratio = 0xCA;
constexpr std::uint8_t enhancement_b = 0xD1;
constexpr std::uint8_t lock = 0xFD;
}  // namespace cmd

constexpr std::uint8_t unlocked = 0x12;

// Bits of the remap register; addresses run along the row.
constexpr unsigned remap_columns = 0x02;
constexpr unsigned remap_nibbles = 0x04;
constexpr unsigned remap_rows = 0x10;
constexpr std::uint8_t one_row_at_a_time = 0x01;
constexpr std::uint8_t two_rows_at_once = 0x11;
// With more rows a row is driven alone.
constexpr int most_rows_of_two = 64;

constexpr std::array<std::uint8_t, 4> remap_bits{remap_nibbles | remap_rows,
                                                 remap_nibbles | remap_columns | remap_rows,
                                                 remap_nibbles | remap_columns, remap_nibbles};

/// Pulse widths of greys 1..15: light in 180 steps, to the nearest.
constexpr auto pulse_widths = [] {
  std::array<std::uint8_t, 15> widths{};
  for (std::size_t i = 0; i < widths.size(); ++i)
    widths[i] =
        static_cast<std::uint8_t>((light_of(17U * (static_cast<unsigned>(i) + 1U)) * 180U + 32640U) / 65280U);
  return widths;
}();
static_assert(pulse_widths.front() == 1 && pulse_widths.back() == 180);

constexpr int column_pixels = 4;

bool valid(const Ssd1322Options& o) noexcept {
  return o.width >= column_pixels && o.width <= Ssd1322::memory_columns * column_pixels &&
         o.width % column_pixels == 0 && o.height >= 16 && o.height <= Ssd1322::memory_rows &&
         o.column_offset >= 0 && o.column_offset <= Ssd1322::memory_columns - o.width / column_pixels &&
         o.refresh_millihertz >= 1 && o.rotation <= Rotation::by_270;
}

Ssd1322Options harmless(const Ssd1322Options& options) noexcept {
  return valid(options) ? options : Ssd1322Options{};
}

Capabilities capabilities_of(const Ssd1322Options& o) noexcept {
  return grey_capabilities(o.width, o.height, column_pixels, o.rotation, o.refresh_millihertz);
}

}  // namespace

Ssd1322::Ssd1322(CommandPort& port, Clock* frame_clock, VblankSource* vblank,
                 const Ssd1322Options& options) noexcept
    : BusPanel(capabilities_of(harmless(options)), frame_clock, vblank),
      port_(&port),
      options_(harmless(options)),
      valid_(valid(options)) {}

Status Ssd1322::do_start() noexcept {
  if (!valid_) return {Error::invalid, Part::panel};
  const std::uint8_t rows_at_once =
      options_.height <= most_rows_of_two ? two_rows_at_once : one_row_at_a_time;
  // clang-format off
  const auto setup = std::to_array<std::uint8_t>({
      cmd::lock, 1, unlocked,
      cmd::display_off, 0,
      cmd::clock_divide, 1, 0x91,
      cmd::multiplex_ratio, 1, static_cast<std::uint8_t>(options_.height - 1),
      cmd::offset, 1, 0,
      cmd::start_line, 1, 0,
      cmd::remap, 2, remap_bits[static_cast<std::size_t>(options_.rotation)], rows_at_once,
      cmd::free_pins, 1, 0x00,
      cmd::internal_supply, 1, 0x01,
      cmd::enhancement_a, 2, 0xA0, 0xFD,
      cmd::contrast, 1, options_.contrast,
      cmd::master_current, 1, 0x0F,
      cmd::phase_length, 1, 0xE2,
      cmd::enhancement_b, 2, 0x82, 0x20,
      cmd::precharge_voltage, 1, 0x1F,
      cmd::second_precharge, 1, 0x08,
      cmd::vcomh, 1, 0x07,
      cmd::whole_display, 0,
      options_.negative ? cmd::inverse_display : cmd::normal_display, 0,
  });
  // clang-format on
  if (const Status s = port_->sequence(setup); !s.ok()) return s;
  if (const Status s = port_->command(cmd::grey_table, pulse_widths); !s.ok()) return s;
  if (const Status s = port_->command(cmd::use_grey_table, {}); !s.ok()) return s;
  // The memory holds noise; it is cleared before anyone sees it.
  const Capabilities& c = capabilities();
  if (const Status s = set_window({0, 0, c.width, c.height}); !s.ok()) return s;
  if (const Status s = send_black(*port_, c.width * c.height / 2); !s.ok()) return s;
  return do_sleep(false);
}

Status Ssd1322::do_sleep(bool asleep) noexcept {
  return port_->command(asleep ? cmd::display_off : cmd::display_on, {});
}

Status Ssd1322::do_set_contrast(std::uint8_t contrast) noexcept {
  return port_->command(cmd::contrast, {&contrast, 1});
}

Status Ssd1322::set_window(const Rect& area) noexcept {
  const Rect r = swaps_sides(options_.rotation) ? Rect{area.y, area.x, area.height, area.width} : area;
  // Remapped columns count from the other end.
  const bool mirrored = (remap_bits[static_cast<std::size_t>(options_.rotation)] & remap_columns) != 0;
  const int first = mirrored ? memory_columns - options_.column_offset - options_.width / column_pixels
                             : options_.column_offset;
  const std::array<std::uint8_t, 2> columns{
      static_cast<std::uint8_t>(first + r.x / column_pixels),
      static_cast<std::uint8_t>(first + (r.x + r.width) / column_pixels - 1)};
  const std::array<std::uint8_t, 2> rows{static_cast<std::uint8_t>(r.y),
                                         static_cast<std::uint8_t>(r.y + r.height - 1)};
  if (const Status s = port_->command(cmd::column_window, columns); !s.ok()) return s;
  if (const Status s = port_->command(cmd::row_window, rows); !s.ok()) return s;
  return port_->command(cmd::memory_write, {});
}

Status Ssd1322::do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept {
  if (const Status s = set_window(area); !s.ok()) return s;
  return send_greys(*port_, area.width, area.height, pixels, stride, swaps_sides(options_.rotation));
}

}  // namespace hal::panels
