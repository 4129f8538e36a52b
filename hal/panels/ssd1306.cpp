// SPDX-License-Identifier: MIT
#include <hal/panels/ssd1306.hpp>

#include <array>

namespace hal::panels {

namespace {

namespace cmd {
constexpr std::uint8_t column_low = 0x00;
constexpr std::uint8_t column_high = 0x10;
constexpr std::uint8_t memory_mode = 0x20;
constexpr std::uint8_t scroll_off = 0x2E;
constexpr std::uint8_t start_line = 0x40;
constexpr std::uint8_t contrast = 0x81;
constexpr std::uint8_t charge_pump = 0x8D;
constexpr std::uint8_t segments = 0xA0;
constexpr std::uint8_t show_memory = 0xA4;
constexpr std::uint8_t normal_display = 0xA6;
constexpr std::uint8_t inverse_display = 0xA7;
constexpr std::uint8_t multiplex_ratio = 0xA8;
constexpr std::uint8_t pump_control = 0xAD;
constexpr std::uint8_t display_off = 0xAE;
constexpr std::uint8_t display_on = 0xAF;
constexpr std::uint8_t page = 0xB0;
constexpr std::uint8_t rows = 0xC0;
constexpr std::uint8_t rows_reversed = 0xC8;
constexpr std::uint8_t offset = 0xD3;
constexpr std::uint8_t clock_divide = 0xD5;
constexpr std::uint8_t precharge = 0xD9;
constexpr std::uint8_t com_pins = 0xDA;
constexpr std::uint8_t vcomh = 0xDB;
}  // namespace cmd

constexpr std::uint8_t page_addressing = 2;

// The voltages and timings are those the datasheets give for modules with the built-in charge pump.
// clang-format off
constexpr auto setup_ssd1306_64 = std::to_array<std::uint8_t>({
    cmd::clock_divide, 0x80,
    cmd::multiplex_ratio, 63,
    cmd::offset, 0,
    cmd::start_line,
    cmd::charge_pump, 0x14,
    cmd::memory_mode, page_addressing,
    cmd::com_pins, 0x12,
    cmd::contrast, 0xCF,
    cmd::precharge, 0xF1,
    cmd::vcomh, 0x40,
    cmd::show_memory,
    cmd::scroll_off,
});
constexpr auto setup_ssd1306_32 = std::to_array<std::uint8_t>({
    cmd::clock_divide, 0x80,
    cmd::multiplex_ratio, 31,
    cmd::offset, 0,
    cmd::start_line,
    cmd::charge_pump, 0x14,
    cmd::memory_mode, page_addressing,
    cmd::com_pins, 0x02,
    cmd::contrast, 0x8F,
    cmd::precharge, 0xF1,
    cmd::vcomh, 0x40,
    cmd::show_memory,
    cmd::scroll_off,
});
constexpr auto setup_sh1106 = std::to_array<std::uint8_t>({
    cmd::clock_divide, 0x80,
    cmd::multiplex_ratio, 63,
    cmd::offset, 0,
    cmd::start_line,
    cmd::pump_control, 0x8B,
    cmd::com_pins, 0x12,
    cmd::contrast, 0x80,
    cmd::precharge, 0x22,
    cmd::vcomh, 0x35,
    cmd::show_memory,
});
constexpr auto setup_ssd0303 = std::to_array<std::uint8_t>({
    cmd::start_line,
    cmd::show_memory,
});
// clang-format on

constexpr std::array<std::uint8_t, 6> black_and_white{0, 0, 0, 255, 255, 255};

constexpr int page_rows = 8;
// Columns sent in one transfer.
constexpr int chunk = 16;

/// The leftmost pixel of a row is the topmost of a page.
std::uint8_t reversed_bits(unsigned byte) noexcept {
  byte = (byte & 0x55U) << 1U | (byte >> 1U & 0x55U);
  byte = (byte & 0x33U) << 2U | (byte >> 2U & 0x33U);
  return static_cast<std::uint8_t>(byte << 4U | byte >> 4U);
}

Capabilities capabilities_of(const Ssd1306Module& module, Rotation rotation) noexcept {
  const bool turned = swaps_sides(rotation);
  return {.width = turned ? module.height : module.width,
          .height = turned ? module.width : module.height,
          .bits_per_pixel = 1,
          .bit_order = BitOrder::msb_first,
          .fixed_palette = black_and_white,
          .x_alignment = 8,
          .y_alignment = turned ? 1 : page_rows,
          // The controllers are scanned in the order of their memory's rows, whichever way it is mapped.
          .scan = turned ? ScanDirection::right : ScanDirection::down,
          .refresh_millihertz = module.refresh_millihertz};
}

/// True if the picture's columns run against the glass's; and its rows.
bool mirrors_columns(Rotation r) noexcept { return r == Rotation::by_90 || r == Rotation::by_180; }
bool mirrors_rows(Rotation r) noexcept { return r == Rotation::by_180 || r == Rotation::by_270; }

bool valid(const Ssd1306Module& m, Rotation rotation) noexcept {
  return m.memory_columns >= 1 && m.memory_columns <= 132 && m.width >= 1 && m.width <= m.memory_columns &&
         m.height >= 1 && m.height <= 64 && m.column_offset >= 0 &&
         m.column_offset <= m.memory_columns - m.width && m.refresh_millihertz >= 1 &&
         rotation <= Rotation::by_270;
}

/// What does no harm until `start` refuses it.
const Ssd1306Module& harmless(const Ssd1306Module& module, Rotation rotation) noexcept {
  return valid(module, rotation) ? module : ssd1306_128x64;
}

}  // namespace

constinit const Ssd1306Module ssd1306_128x64{.width = 128, .height = 64, .setup = setup_ssd1306_64};
constinit const Ssd1306Module ssd1306_128x32{.width = 128, .height = 32, .setup = setup_ssd1306_32};
constinit const Ssd1306Module sh1106_128x64{
    .width = 128, .height = 64, .column_offset = 2, .memory_columns = 132, .setup = setup_sh1106};
constinit const Ssd1306Module ssd0303_96x16{.width = 96,
                                            .height = 16,
                                            .column_offset = 36,
                                            .memory_columns = 132,
                                            .segments_reversed = false,
                                            .setup = setup_ssd0303};

Ssd1306::Ssd1306(CommandPort& port, const Ssd1306Module& module, Clock* frame_clock,
                 const Ssd1306Options& options) noexcept
    : BusPanel(capabilities_of(harmless(module, options.rotation), options.rotation), frame_clock),
      port_(port),
      module_(harmless(module, options.rotation)),
      options_(options),
      valid_(valid(module, options.rotation)),
      first_column_(mirrors_columns(options.rotation)
                        ? module_.memory_columns - module_.column_offset - module_.width
                        : module_.column_offset) {}

Status Ssd1306::do_start() noexcept {
  if (!valid_) return {Error::invalid, Part::panel};
  if (const Status s = do_sleep(true); !s.ok()) return s;
  if (const Status s = port_.command(module_.setup); !s.ok()) return s;
  const bool reversed = module_.segments_reversed != mirrors_columns(options_.rotation);
  const std::array<std::uint8_t, 3> use{static_cast<std::uint8_t>(cmd::segments | (reversed ? 1U : 0U)),
                                        mirrors_rows(options_.rotation) ? cmd::rows : cmd::rows_reversed,
                                        options_.negative ? cmd::inverse_display : cmd::normal_display};
  if (const Status s = port_.command(use); !s.ok()) return s;
  if (options_.contrast)
    if (const Status s = do_set_contrast(*options_.contrast); !s.ok()) return s;
  // The memory holds noise; it is cleared before anyone sees it.
  constexpr std::array<std::uint8_t, 32> black{};
  for (int y = 0; y < module_.height; y += page_rows) {
    if (const Status s = set_position(y / page_rows, 0); !s.ok()) return s;
    for (int x = 0; x < module_.width; x += static_cast<int>(black.size())) {
      const int left = module_.width - x;
      const auto count =
          left < static_cast<int>(black.size()) ? static_cast<std::size_t>(left) : black.size();
      if (const Status s = port_.data(std::span(black).first(count)); !s.ok()) return s;
    }
  }
  return do_sleep(false);
}

Status Ssd1306::do_sleep(bool asleep) noexcept {
  const std::uint8_t code = asleep ? cmd::display_off : cmd::display_on;
  return port_.command({&code, 1});
}

Status Ssd1306::do_set_contrast(std::uint8_t contrast) noexcept {
  const std::array<std::uint8_t, 2> command{cmd::contrast, contrast};
  return port_.command(command);
}

Status Ssd1306::set_position(int page, int x) noexcept {
  const auto column = static_cast<unsigned>(x + first_column_);
  const std::array<std::uint8_t, 3> position{static_cast<std::uint8_t>(cmd::page + page),
                                             static_cast<std::uint8_t>(cmd::column_low | (column & 15U)),
                                             static_cast<std::uint8_t>(cmd::column_high | column >> 4U)};
  return port_.command(position);
}

Status Ssd1306::do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept {
  if (swaps_sides(options_.rotation)) return write_turned(area, pixels, stride);
  for (int y = 0; y < area.height; y += page_rows) {
    const auto first = static_cast<std::size_t>(y) * static_cast<std::size_t>(stride);
    const int rows = area.height - y < page_rows ? area.height - y : page_rows;
    const Status s = write_page((area.y + y) / page_rows, {area.x, area.y + y, area.width, rows},
                                pixels.subspan(first), stride);
    if (!s.ok()) return s;
  }
  return {};
}

Status Ssd1306::write_turned(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept {
  for (int x = 0; x < area.width; x += page_rows) {
    if (const Status s = set_position((area.x + x) / page_rows, area.y); !s.ok()) return s;
    for (int y = 0; y < area.height; y += chunk) {
      const int columns = area.height - y < chunk ? area.height - y : chunk;
      std::array<std::uint8_t, chunk> bytes{};
      for (int column = 0; column < columns; ++column) {
        const auto row = static_cast<std::size_t>(y + column) * static_cast<std::size_t>(stride);
        bytes[static_cast<std::size_t>(column)] =
            reversed_bits(pixels[row + static_cast<std::size_t>(x / 8)]);
      }
      const auto count = static_cast<std::size_t>(columns);
      if (const Status s = port_.data(std::span(bytes).first(count)); !s.ok()) return s;
    }
  }
  return {};
}

Status Ssd1306::write_page(int page, const Rect& area, std::span<const std::uint8_t> pixels,
                           int stride) noexcept {
  if (const Status s = set_position(page, area.x); !s.ok()) return s;
  for (int x = 0; x < area.width; x += chunk) {
    const int columns = area.width - x < chunk ? area.width - x : chunk;
    std::array<std::uint8_t, chunk> turned{};
    for (int column = 0; column < columns; ++column) {
      const auto byte = static_cast<std::size_t>((x + column) / 8);
      const unsigned shift = 7U - static_cast<unsigned>((x + column) % 8);
      unsigned bits = 0;
      for (int row = 0; row < area.height; ++row) {
        const auto first = static_cast<std::size_t>(row) * static_cast<std::size_t>(stride);
        bits |= (static_cast<unsigned>(pixels[first + byte]) >> shift & 1U) << static_cast<unsigned>(row);
      }
      turned[static_cast<std::size_t>(column)] = static_cast<std::uint8_t>(bits);
    }
    const auto count = static_cast<std::size_t>(columns);
    if (const Status s = port_.data(std::span(turned).first(count)); !s.ok()) return s;
  }
  return {};
}

}  // namespace hal::panels
