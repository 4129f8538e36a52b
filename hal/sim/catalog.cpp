// SPDX-License-Identifier: MIT
#include <hal/sim/catalog.hpp>

#include <array>
#include <charconv>

namespace hal::sim {

namespace {

/// The usual share of blanking, as of 240 in 262 and 480 in 525 lines.
int with_blanking(int height) { return height + (height + 10) / 11; }

/// Greys from black to white.
std::vector<std::uint8_t> greys(int count) {
  std::vector<std::uint8_t> colours;
  for (int i = 0; i < count; ++i)
    colours.insert(colours.end(), 3, static_cast<std::uint8_t>(i * 255 / (count - 1)));
  return colours;
}

PanelSpec rgb_lcd(std::string name, std::string description, int width, int height, int bits,
                  int palette_bits) {
  PanelSpec spec = paletted(width, height, bits, 2, BitOrder::lsb_first);
  spec.name = std::move(name);
  spec.description = std::move(description);
  spec.capabilities.palette_bits = palette_bits;
  spec.effects.depth = {{palette_bits, palette_bits, palette_bits}};
  spec.effects.response = {12'000'000, 8'000'000};
  return spec;
}

/// An OLED answers in microseconds, and its pixels are of one colour.
PanelSpec oled(std::string name, std::string description, int width, int height, int bits, int x_alignment,
               int y_alignment, const BusTiming& bus) {
  PanelSpec spec;
  spec.name = std::move(name);
  spec.description = std::move(description);
  spec.capabilities = {.width = width,
                       .height = height,
                       .bits_per_pixel = bits,
                       .x_alignment = x_alignment,
                       .y_alignment = y_alignment};
  spec.fixed_colours = greys(1 << bits);
  spec.total_lines = with_blanking(height);
  spec.effects.bus = bus;
  spec.effects.depth = {{bits, bits, bits}};
  spec.effects.response = {10'000, 10'000};
  spec.effects.grid = {6, Stripes::none};
  return spec;
}

/// A TFT controller that turns indices to colours while they are written.
PanelSpec tft(std::string name, std::string description, int width, int height, std::uint32_t hertz) {
  PanelSpec spec = paletted(width, height, 8, 0);
  spec.name = std::move(name);
  spec.description = std::move(description);
  spec.capabilities.palette_on_write = true;
  spec.effects.bus = {.hertz = hertz, .bits_per_pixel = 16};
  spec.effects.depth = {{5, 6, 5}};
  spec.effects.response = {12'000'000, 8'000'000};
  return spec;
}

std::vector<PanelSpec> make_catalog() {
  // A window of an SSD0323 is two commands of three bytes; a page of an SSD1306 three commands, each behind a
  // control byte, and the address in front of every transaction.
  constexpr BusTiming spi{.hertz = 4'000'000, .command_bytes = 6, .gap = 2'000};
  constexpr BusTiming i2c{.hertz = 400'000, .clocks_per_byte = 9, .command_bytes = 6, .gap = 5'000};
  std::vector<PanelSpec> panels;
  panels.push_back(
      rgb_lcd("clcd", "PL110 colour LCD, 256 of 32768 colours, double buffered", 320, 240, 8, 5));
  panels.push_back(rgb_lcd("clcd4", "the same with 16 colours", 320, 240, 4, 5));
  panels.push_back(rgb_lcd("clcd1", "the same with 2 colours", 320, 240, 1, 5));
  panels.push_back(rgb_lcd("vga", "256 of 16.7 million colours, double buffered", 640, 480, 8, 8));
  panels.push_back(oled("oled", "SSD0323 OLED behind SSI, 16 greys", 128, 64, 4, 2, 1, spi));
  panels.push_back(oled("ssd1306", "SSD1306 OLED behind I2C or SPI, white on black", 128, 64, 1, 8, 8, i2c));
  panels.push_back(oled("ssd0303", "SSD0303 OLED behind I2C, white on black", 96, 16, 1, 8, 8, i2c));
  panels.push_back(oled("ssd1322", "SSD1322 OLED behind SPI, 16 greys", 256, 64, 4, 4, 1, spi));
  panels.push_back(tft("st7789", "ST7789 TFT behind SPI, 256 of 65536 colours", 240, 320, 40'000'000));
  panels.push_back(tft("ili9341", "ILI9341 TFT behind SPI, 256 of 65536 colours", 240, 320, 10'000'000));
  panels.push_back(tft("ili9341-320x240", "the same on its side", 320, 240, 10'000'000));
  panels.back().capabilities.scan = ScanDirection::right;
  return panels;
}

/// "320x200x4" -> 320, 200, 4.
std::optional<std::array<int, 3>> three_numbers(std::string_view text) {
  std::array<int, 3> numbers{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && (at == end || *at++ != 'x')) return std::nullopt;
    const auto [next, error] = std::from_chars(at, end, numbers[i]);
    if (error != std::errc{}) return std::nullopt;
    at = next;
  }
  return at == end ? std::optional(numbers) : std::nullopt;
}

}  // namespace

std::span<const PanelSpec> catalog() {
  static const std::vector<PanelSpec> panels = make_catalog();
  return panels;
}

PanelSpec paletted(int width, int height, int bits_per_pixel, int buffers, BitOrder order) {
  PanelSpec spec;
  spec.name = std::to_string(width) + 'x' + std::to_string(height) + 'x' + std::to_string(bits_per_pixel);
  spec.description = "paletted panel with " + std::to_string(buffers) + " frame buffers";
  spec.capabilities = {.width = width,
                       .height = height,
                       .bits_per_pixel = bits_per_pixel,
                       .bit_order = order,
                       .palette_entries = 1 << bits_per_pixel,
                       .buffers = buffers,
                       .vblank_signal = true};
  spec.total_lines = with_blanking(height);
  return spec;
}

std::optional<PanelSpec> find_panel(std::string_view text) {
  for (const PanelSpec& panel : catalog())
    if (panel.name == text) return panel;
  const auto numbers = three_numbers(text);
  if (!numbers) return std::nullopt;
  const auto [width, height, bits] = *numbers;
  constexpr int most = 16384;
  if (width < 1 || width > most || height < 1 || height > most) return std::nullopt;
  if (bits != 1 && bits != 2 && bits != 4 && bits != 8) return std::nullopt;
  return paletted(width, height, bits);
}

}  // namespace hal::sim
