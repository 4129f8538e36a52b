// SPDX-License-Identifier: MIT
#include <hal/panels/ili9341.hpp>
#include <hal/panels/modules.hpp>
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

template <class Driver, const DcsOptions& module>
BusPanel& make_dcs(ModuleStorage& storage, const ModuleParts& parts) noexcept {
  DcsOptions options = module;
  const auto turns = static_cast<unsigned>(module.rotation) + static_cast<unsigned>(parts.options.rotation);
  options.rotation = static_cast<Rotation>(turns % 4U);
  options.invert = module.invert != parts.options.negative;
  options.te = parts.options.te;
  options.te_line = parts.options.te_line;
  options.contrast = parts.options.contrast.value_or(module.contrast);
  options.workspace = parts.options.workspace;
  return place<Driver>(storage, *parts.port, *parts.clock, parts.vblank, options);
}

constexpr auto table = std::to_array<Module>({
    {.name = "st7789",
     .description = "ST7789 TFT, 256 of 65536 colours",
     .width = 240,
     .height = 320,
     .spi = true,
     .te = true,
     .make = make_dcs<St7789, st7789_240x320>},
    {.name = "st7789-240x240",
     .description = "the same with a square glass",
     .width = 240,
     .height = 240,
     .spi = true,
     .te = true,
     .make = make_dcs<St7789, st7789_240x240>},
    {.name = "st7789-135x240",
     .description = "the same with a narrow glass",
     .width = 135,
     .height = 240,
     .spi = true,
     .te = true,
     .make = make_dcs<St7789, st7789_135x240>},
    {.name = "ili9341",
     .description = "ILI9341 TFT, 256 of 65536 colours",
     .width = 240,
     .height = 320,
     .spi = true,
     .te = true,
     .make = make_dcs<Ili9341, ili9341_240x320>},
    {.name = "ili9341-320x240",
     .description = "the same on its side",
     .width = 320,
     .height = 240,
     .spi = true,
     .te = true,
     .make = make_dcs<Ili9341, ili9341_320x240>},
});

}  // namespace

std::span<const Module> modules() noexcept { return table; }

const Module* find_module(std::string_view name) noexcept {
  for (const Module& module : table)
    if (module.name == name) return &module;
  return nullptr;
}

}  // namespace hal::panels
