// SPDX-License-Identifier: MIT
#include <hal/panels/ili9341.hpp>
#include <hal/panels/modules.hpp>
#include <hal/panels/ssd0323.hpp>
#include <hal/panels/ssd1306.hpp>
#include <hal/panels/ssd1322.hpp>
#include <hal/panels/st7789.hpp>

#include <array>
#include <memory>
#include <type_traits>

namespace hal::panels {

namespace {

template <class Driver, class... Arguments>
BusPanel& place(ModuleStorage& storage, Arguments&&... arguments) noexcept {
  static_assert(sizeof(Driver) <= ModuleStorage::size && alignof(Driver) <= alignof(std::max_align_t));
  static_assert(std::is_trivially_destructible_v<Driver>, "storage is used again without more ado");
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): memory that holds no object yet
  auto* const at = reinterpret_cast<Driver*>(storage.data());
  return *std::construct_at(at, arguments...);
}

std::uint32_t refresh_of(const ModuleParts& parts, std::uint32_t own) noexcept {
  return parts.options.refresh_millihertz == 0 ? own : parts.options.refresh_millihertz;
}

/// An offset of the glass added to the module's; one that can't be becomes one that `start` refuses.
int beyond(int own, int more) noexcept {
  return more >= 0 && more < DcsPanel::memory_height ? own + more : -1;
}

DcsOptions dcs_options(const DcsOptions& module, const ModuleOptions& used) noexcept {
  DcsOptions options = module;
  const auto turns = static_cast<unsigned>(module.rotation) + static_cast<unsigned>(used.rotation);
  options.rotation = static_cast<Rotation>(turns % 4U);
  options.invert = module.invert != used.negative;
  options.te = used.te;
  options.te_line = used.te_line;
  options.scan_up = used.scan_up;
  if (used.refresh_millihertz != 0) options.refresh_millihertz = used.refresh_millihertz;
  options.contrast = used.contrast.value_or(module.contrast);
  options.workspace = used.workspace;
  const ModuleGlass& glass = used.glass;
  if (glass.width != 0) options.width = glass.width;
  if (glass.height != 0) options.height = glass.height;
  options.column_offset = beyond(module.column_offset, glass.column_offset);
  options.row_offset = beyond(module.row_offset, glass.row_offset);
  options.mirrored = module.mirrored != glass.mirrored;
  options.bgr = module.bgr != glass.bgr;
  return options;
}

template <class Driver, const DcsOptions& module>
BusPanel& make_dcs(ModuleStorage& storage, const ModuleParts& parts) noexcept {
  return place<Driver>(storage, *parts.port, *parts.clock, parts.vblank, dcs_options(module, parts.options));
}

template <const DcsOptions& module, int blank_lines>
BeamLines beam_of(const ModuleOptions& options) noexcept {
  return beam_lines(dcs_options(module, options), blank_lines);
}

BusPanel& make_ssd1322(ModuleStorage& storage, const ModuleParts& parts) noexcept {
  Ssd1322Options options;
  options.rotation = parts.options.rotation;
  options.negative = parts.options.negative;
  options.contrast = parts.options.contrast.value_or(options.contrast);
  options.refresh_millihertz = refresh_of(parts, options.refresh_millihertz);
  return place<Ssd1322>(storage, *parts.port, parts.clock, parts.vblank, options);
}

BusPanel& make_ssd0323(ModuleStorage& storage, const ModuleParts& parts) noexcept {
  Ssd0323Options options;
  options.rotation = parts.options.rotation;
  options.negative = parts.options.negative;
  options.refresh_millihertz = refresh_of(parts, options.refresh_millihertz);
  if (parts.options.contrast) options.contrast = static_cast<std::uint8_t>(*parts.options.contrast / 2);
  return place<Ssd0323>(storage, *parts.port, parts.clock, options);
}

template <const Ssd1306Module& module>
BusPanel& make_ssd1306(ModuleStorage& storage, const ModuleParts& parts) noexcept {
  const Ssd1306Options options{.rotation = parts.options.rotation,
                               .negative = parts.options.negative,
                               .contrast = parts.options.contrast};
  Ssd1306Module used = module;
  used.refresh_millihertz = refresh_of(parts, module.refresh_millihertz);
  return place<Ssd1306>(storage, *parts.port, used, parts.clock, options);
}

constexpr auto table = std::to_array<Module>({
    {.name = "st7789",
     .description = "ST7789 TFT, 256 of 65536 colours",
     .width = 240,
     .height = 320,
     .spi = true,
     .te = true,
     .any_glass = true,
     .beam = beam_of<st7789_240x320, st7789_blank_lines>,
     .make = make_dcs<St7789, st7789_240x320>},
    {.name = "st7789-240x240",
     .description = "the same with a square glass",
     .width = 240,
     .height = 240,
     .spi = true,
     .te = true,
     .any_glass = true,
     .beam = beam_of<st7789_240x240, st7789_blank_lines>,
     .make = make_dcs<St7789, st7789_240x240>},
    {.name = "st7789-135x240",
     .description = "the same with a narrow glass",
     .width = 135,
     .height = 240,
     .spi = true,
     .te = true,
     .any_glass = true,
     .beam = beam_of<st7789_135x240, st7789_blank_lines>,
     .make = make_dcs<St7789, st7789_135x240>},
    {.name = "ili9341",
     .description = "ILI9341 TFT, 256 of 65536 colours",
     .width = 240,
     .height = 320,
     .spi = true,
     .te = true,
     .any_glass = true,
     .refresh_millihertz = 61'000,
     .beam = beam_of<ili9341_240x320, ili9341_blank_lines>,
     .make = make_dcs<Ili9341, ili9341_240x320>},
    {.name = "ili9341-320x240",
     .description = "the same on its side",
     .width = 320,
     .height = 240,
     .spi = true,
     .te = true,
     .any_glass = true,
     .refresh_millihertz = 61'000,
     .beam = beam_of<ili9341_320x240, ili9341_blank_lines>,
     .make = make_dcs<Ili9341, ili9341_320x240>},
    {.name = "ssd1322",
     .description = "SSD1322 OLED, 16 greys",
     .width = 256,
     .height = 64,
     .spi = true,
     .make = make_ssd1322},
    {.name = "ssd0323",
     .description = "SSD0323 OLED, 16 greys",
     .width = 128,
     .height = 64,
     .spi = true,
     .i2c = true,
     .make = make_ssd0323},
    {.name = "ssd1306",
     .description = "SSD1306 OLED, white on black",
     .width = 128,
     .height = 64,
     .spi = true,
     .i2c = true,
     .make = make_ssd1306<ssd1306_128x64>},
    {.name = "ssd1306-128x32",
     .description = "the same with half the rows",
     .width = 128,
     .height = 32,
     .spi = true,
     .i2c = true,
     .make = make_ssd1306<ssd1306_128x32>},
    {.name = "sh1106",
     .description = "SH1106 OLED, white on black",
     .width = 128,
     .height = 64,
     .spi = true,
     .i2c = true,
     .make = make_ssd1306<sh1106_128x64>},
    {.name = "ssd0303",
     .description = "SSD0303 OLED, white on black",
     .width = 96,
     .height = 16,
     .i2c = true,
     .i2c_framing = I2cFraming::single,
     .make = make_ssd1306<ssd0303_96x16>},
});

}  // namespace

std::span<const Module> modules() noexcept { return table; }

const Module* find_module(std::string_view name) noexcept {
  for (const Module& module : table)
    if (module.name == name) return &module;
  return nullptr;
}

}  // namespace hal::panels
