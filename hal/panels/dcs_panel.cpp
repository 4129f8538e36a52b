// SPDX-License-Identifier: MIT
#include <hal/panels/dcs_panel.hpp>

#include <algorithm>
#include <array>

namespace hal::panels {

namespace {

namespace cmd {
constexpr std::uint8_t software_reset = 0x01;
constexpr std::uint8_t sleep_in = 0x10;
constexpr std::uint8_t sleep_out = 0x11;
constexpr std::uint8_t normal_mode = 0x13;
constexpr std::uint8_t inversion_off = 0x20;
constexpr std::uint8_t inversion_on = 0x21;
constexpr std::uint8_t display_off = 0x28;
constexpr std::uint8_t display_on = 0x29;
constexpr std::uint8_t column_window = 0x2A;
constexpr std::uint8_t row_window = 0x2B;
constexpr std::uint8_t memory_write = 0x2C;
constexpr std::uint8_t tearing_off = 0x34;
constexpr std::uint8_t tearing_on = 0x35;
constexpr std::uint8_t address_mode = 0x36;
constexpr std::uint8_t pixel_format = 0x3A;
constexpr std::uint8_t tearing_line = 0x44;
constexpr std::uint8_t brightness = 0x51;
constexpr std::uint8_t brightness_control = 0x53;
}  // namespace cmd

// Bits of the address mode.
constexpr unsigned mirror_rows = 0x80;
constexpr unsigned mirror_columns = 0x40;
constexpr unsigned exchange = 0x20;
constexpr unsigned refresh_up = 0x10;
constexpr unsigned blue_first = 0x08;

constexpr std::uint8_t rgb565_pixels = 0x55;
// The brightness register drives the back light.
constexpr std::uint8_t brightness_on = 0x24;

constexpr Nanoseconds after_command = 5'000'000;
constexpr Nanoseconds between_sleeps = 120'000'000;

constexpr std::size_t least_buffer = 256;

bool valid(const DcsOptions& o) noexcept {
  constexpr int width = DcsPanel::memory_width;
  constexpr int height = DcsPanel::memory_height;
  const auto inside = [](int offset, int length, int limit) {
    return length >= 1 && length <= limit && offset >= 0 && offset <= limit - length;
  };
  const int bits = o.bits_per_pixel;
  return inside(o.column_offset, o.width, width) && inside(o.row_offset, o.height, height) &&
         (bits == 1 || bits == 2 || bits == 4 || bits == 8) && o.te_line >= 0 && o.te_line < height &&
         (o.te_line == 0 || o.te != TearingEffect::vblank_and_hblank) && o.refresh_millihertz >= 1 &&
         o.rotation <= Rotation::by_270 && o.te <= TearingEffect::vblank_and_hblank;
}

/// Options that do no harm until `start` refuses them.
DcsOptions harmless(const DcsOptions& options) noexcept { return valid(options) ? options : DcsOptions{}; }

Capabilities capabilities_of(const DcsOptions& o) noexcept {
  const bool swapped = swaps_sides(o.rotation);
  return {.width = swapped ? o.height : o.width,
          .height = swapped ? o.width : o.height,
          .bits_per_pixel = o.bits_per_pixel,
          .bit_order = o.bit_order,
          .palette_entries = 1 << o.bits_per_pixel,
          .palette_on_write = true,
          // A row of a partial write begins with a byte.
          .x_alignment = 8 / o.bits_per_pixel,
          .scan = scan_over(o.rotation, o.scan_up),
          .refresh_millihertz = o.refresh_millihertz};
}

}  // namespace

DcsPanel::DcsPanel(CommandPort& port, Clock& clock, VblankSource* vblank, const DcsOptions& options,
                   std::span<const std::uint8_t> setup) noexcept
    : BusPanel(capabilities_of(harmless(options)), &clock, vblank),
      port_(&port),
      clock_(&clock),
      options_(harmless(options)),
      setup_(setup),
      valid_(valid(options)) {
  const unsigned mode = address_mode();
  const int columns = (mode & mirror_columns) != 0 ? memory_width - options_.column_offset - options_.width
                                                   : options_.column_offset;
  const int rows =
      (mode & mirror_rows) != 0 ? memory_height - options_.row_offset - options_.height : options_.row_offset;
  const bool swapped = (mode & exchange) != 0;
  column_shift_ = swapped ? rows : columns;
  row_shift_ = swapped ? columns : rows;
}

std::uint8_t DcsPanel::address_mode() const noexcept {
  constexpr std::array<unsigned, 4> turned{0, exchange | mirror_columns, mirror_columns | mirror_rows,
                                           exchange | mirror_rows};
  unsigned mode = turned[static_cast<std::size_t>(options_.rotation)];
  if (options_.mirrored) mode ^= mirror_columns;
  if (options_.scan_up) mode |= refresh_up;
  if (options_.bgr) mode |= blue_first;
  return static_cast<std::uint8_t>(mode);
}

Status DcsPanel::send(std::uint8_t code, std::span<const std::uint8_t> parameters) noexcept {
  if (ready_ != 0) {
    clock_->wait_until(ready_);
    ready_ = 0;
  }
  return port_->command(code, parameters);
}

Status DcsPanel::do_start() noexcept {
  if (!valid_) return {Error::invalid, Part::panel};
  if (const Status s = reset(); !s.ok()) return s;
  if (const Status s = do_sleep(false); !s.ok()) return s;
  if (const Status s = configure(); !s.ok()) return s;
  // The memory holds noise; it is cleared before anyone sees it.
  if (const Status s = clear(); !s.ok()) return s;
  return send(cmd::display_on);
}

Status DcsPanel::reset() noexcept {
  // A reset would meet a controller that is still waking up. What it was told before this driver knew it
  // can't be known; the pause after any command is waited for.
  const Nanoseconds awake = sleep_ == Sleep::asleep ? 0 : settled_;
  ready_ = std::max(clock_->now() + after_command, awake);
  const Status sent = send(cmd::software_reset);
  pause();
  sleep_ = sent.ok() ? Sleep::asleep : Sleep::unknown;
  return sent;
}

Status DcsPanel::configure() noexcept {
  if (const Status s = send(cmd::pixel_format, rgb565_pixels); !s.ok()) return s;
  if (const Status s = port_->sequence(setup_); !s.ok()) return s;
  if (const Status s = send(cmd::address_mode, address_mode()); !s.ok()) return s;
  if (const Status s = send(options_.invert ? cmd::inversion_on : cmd::inversion_off); !s.ok()) return s;
  if (const Status s = send(cmd::normal_mode); !s.ok()) return s;
  if (const Status s = send(cmd::brightness_control, brightness_on); !s.ok()) return s;
  if (const Status s = do_set_contrast(options_.contrast); !s.ok()) return s;
  if (options_.te == TearingEffect::off) return send(cmd::tearing_off);
  const std::uint8_t mode = options_.te == TearingEffect::vblank ? 0 : 1;
  if (const Status s = send(cmd::tearing_on, mode); !s.ok() || options_.te_line == 0) return s;
  const std::array<std::uint8_t, 2> line{static_cast<std::uint8_t>(options_.te_line >> 8),
                                         static_cast<std::uint8_t>(options_.te_line & 255)};
  return send(cmd::tearing_line, line);
}

Status DcsPanel::clear() noexcept {
  const Capabilities& c = capabilities();
  if (const Status s = set_window({0, 0, c.width, c.height}); !s.ok()) return s;
  constexpr std::array<std::uint8_t, least_buffer> black{};
  for (auto left = static_cast<std::size_t>(c.width) * static_cast<std::size_t>(c.height) * 2; left > 0;) {
    const std::size_t count = std::min(left, black.size());
    if (const Status s = port_->data(std::span(black).first(count)); !s.ok()) return s;
    left -= count;
  }
  return {};
}

Status DcsPanel::do_stop() noexcept {
  const Status blanked = send(cmd::display_off);
  const Status slept = do_sleep(true);
  return blanked.ok() ? slept : blanked;
}

Status DcsPanel::do_sleep(bool asleep) noexcept {
  const Sleep wanted = asleep ? Sleep::asleep : Sleep::awake;
  if (sleep_ == wanted) return {};
  clock_->wait_until(settled_);
  const Status sent = send(asleep ? cmd::sleep_in : cmd::sleep_out);
  // It may have arrived even if the bus failed.
  pause();
  sleep_ = sent.ok() ? wanted : Sleep::unknown;
  return sent;
}

void DcsPanel::pause() noexcept {
  const Nanoseconds now = clock_->now();
  ready_ = now + after_command;
  settled_ = now + between_sleeps;
}

Status DcsPanel::do_set_contrast(std::uint8_t contrast) noexcept { return send(cmd::brightness, contrast); }

Status DcsPanel::do_load_palette(std::span<const std::uint8_t> palette) noexcept {
  palette_.load(palette);
  return {};
}

Status DcsPanel::set_range(std::uint8_t code, int first, int count) noexcept {
  const int last = first + count - 1;
  const std::array<std::uint8_t, 4> range{
      static_cast<std::uint8_t>(first >> 8), static_cast<std::uint8_t>(first & 255),
      static_cast<std::uint8_t>(last >> 8), static_cast<std::uint8_t>(last & 255)};
  return send(code, range);
}

Status DcsPanel::set_window(const Rect& area) noexcept {
  if (const Status s = set_range(cmd::column_window, area.x + column_shift_, area.width); !s.ok()) return s;
  if (const Status s = set_range(cmd::row_window, area.y + row_shift_, area.height); !s.ok()) return s;
  return send(cmd::memory_write);
}

Status DcsPanel::do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept {
  if (const Status s = set_window(area); !s.ok()) return s;
  // `expand` writes every byte that is sent; clearing them first would take a store for each 4 bytes of every
  // write, dirty rectangles of a few pixels included.
  std::array<std::uint8_t, least_buffer> own;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  const std::span<std::uint8_t> buffer =
      options_.workspace.size() < own.size() ? std::span<std::uint8_t>(own) : options_.workspace;
  const std::size_t capacity = buffer.size() / 2;
  std::size_t filled = 0;  // Pixels in the buffer.
  for (int y = 0; y < area.height; ++y) {
    const auto start = static_cast<std::size_t>(y) * static_cast<std::size_t>(stride);
    const IndexRow row{pixels.subspan(start), options_.bits_per_pixel, options_.bit_order};
    for (int x = 0; x < area.width;) {
      const auto count = std::min(static_cast<std::size_t>(area.width - x), capacity - filled);
      palette_.expand(row, x, static_cast<int>(count), buffer.subspan(2 * filled));
      x += static_cast<int>(count);
      filled += count;
      if (filled < capacity) continue;
      if (const Status s = port_->data(buffer.first(2 * filled)); !s.ok()) return s;
      filled = 0;
    }
  }
  return filled == 0 ? Status{} : port_->data(buffer.first(2 * filled));
}

}  // namespace hal::panels
