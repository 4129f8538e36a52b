// SPDX-License-Identifier: MIT
//
// The table of modules: every name makes a driver that shows pictures on a model of its controller.
#include <hal/mock/strict_dcs.hpp>
#include <hal/mock/strict_ssd0323.hpp>
#include <hal/mock/strict_ssd1306.hpp>
#include <hal/mock/strict_ssd1322.hpp>
#include <hal/panels/modules.hpp>
#include <hal/sim/catalog.hpp>
#include <hal/sim/virtual_clock.hpp>
#include <tests/hal/turned_glass.hpp>

#include <memory>
#include <set>
#include <string>

namespace {

using glass::Rotation;
using hal::mock::Pattern;
using hal::mock::StrictController;
using hal::panels::Module;
using hal::panels::ModuleStorage;

/// The model of the controller that a module of this name has.
std::unique_ptr<StrictController> model_of(const std::string& name, hal::Clock& clock) {
  using namespace hal::mock;
  if (name == "st7789-240x240")
    return std::make_unique<StrictSt7789>(clock, DcsGlass{.height = 240, .inverted = true});
  if (name == "st7789-135x240")
    return std::make_unique<StrictSt7789>(
        clock,
        DcsGlass{.width = 135, .height = 240, .column_offset = 52, .row_offset = 40, .inverted = true});
  if (name == "st7789") return std::make_unique<StrictSt7789>(clock);
  if (name.starts_with("ili9341")) return std::make_unique<StrictIli9341>(clock);
  if (name == "ssd1322") return std::make_unique<StrictSsd1322>();
  if (name == "ssd0323") return std::make_unique<StrictSsd0323>();
  if (name == "ssd1306") return std::make_unique<StrictSsd1306>(128, 64);
  if (name == "ssd1306-128x32") return std::make_unique<StrictSsd1306>(128, 32);
  if (name == "sh1106") return std::make_unique<StrictSsd1306>(128, 64, 2, 0x3C, 132);
  if (name == "ssd0303") return std::make_unique<StrictSsd1306>(96, 16, 36, 0x3C, 132);
  return nullptr;
}

TEST(Modules, EveryNameMakesADriverThatShowsPictures) {
  std::set<std::string_view> names;
  ModuleStorage storage;
  for (const Module& module : hal::panels::modules()) {
    SCOPED_TRACE(module.name);
    EXPECT_TRUE(names.insert(module.name).second) << "twice";
    EXPECT_EQ(hal::panels::find_module(module.name), &module);
    EXPECT_TRUE(module.spi || module.i2c);
    for (const Rotation rotation : glass::rotations) {
      hal::sim::VirtualClock clock;
      const auto model = model_of(std::string(module.name), clock);
      ASSERT_NE(model, nullptr);
      hal::panels::SpiPort port(model->spi(), model->data_command());
      hal::panels::BusPanel& panel =
          module.make(storage, {.port = &port, .clock = &clock, .options = {.rotation = rotation}});
      const hal::Capabilities& c = panel.capabilities();
      EXPECT_EQ(c.refresh_millihertz, module.refresh_millihertz);
      const bool quarter = rotation == Rotation::by_90 || rotation == Rotation::by_270;
      EXPECT_EQ(quarter ? c.height : c.width, module.width);
      EXPECT_EQ(quarter ? c.width : c.height, module.height);
      ASSERT_TRUE(panel.start().ok());
      int entries = 1 << c.bits_per_pixel;
      if (c.palette_entries != 0) {
        // Colours that are their own indices, as RGB565 sees them.
        entries = 32;
        std::vector<std::uint8_t> palette(96);
        for (std::size_t i = 0; i < 32; ++i)
          palette[3 * i + 2] = static_cast<std::uint8_t>((i * 255 + 15) / 31);
        ASSERT_TRUE(panel.load_palette(palette).ok());
      }
      const auto row = static_cast<std::size_t>((c.width * c.bits_per_pixel + 7) / 8);
      std::vector<std::uint8_t> pixels(row * static_cast<std::size_t>(c.height));
      Pattern expected = Pattern::blank(c.width, c.height);
      for (int y = 0; y < c.height; ++y)
        for (int x = 0; x < c.width; ++x) {
          const int index = (x * 7 + y * 3 + x * y) % entries;
          const int bit = x * c.bits_per_pixel;
          std::uint8_t& byte = pixels[static_cast<std::size_t>(y) * row + static_cast<std::size_t>(bit / 8)];
          byte = static_cast<std::uint8_t>(byte | index << (8 - c.bits_per_pixel - bit % 8));
          expected.at(x, y) = index;
        }
      ASSERT_TRUE(panel.write({0, 0, c.width, c.height}, pixels, static_cast<int>(row)).ok());
      // A module that stands on its side in the table is one that is turned.
      const auto turns = static_cast<int>(rotation) + (module.name == "ili9341-320x240" ? 1 : 0);
      const Pattern seen = glass::picture(model->displayed(), static_cast<Rotation>(turns % 4));
      EXPECT_EQ(side_by_side(expected, seen, false), "");
      ASSERT_TRUE(panel.stop().ok());
    }
  }
  hal::sim::VirtualClock clock;
  const auto model = model_of("st7789", clock);
  hal::panels::SpiPort port(model->spi(), model->data_command());
  const hal::Capabilities& c =
      hal::panels::find_module("st7789")
          ->make(storage,
                 {.port = &port, .clock = &clock, .options = {.scan_up = true, .refresh_millihertz = 50'000}})
          .capabilities();
  EXPECT_EQ(c.refresh_millihertz, 50'000U);
  EXPECT_EQ(c.scan, hal::ScanDirection::up);
  EXPECT_EQ(hal::panels::find_module("st7788"), nullptr);
  EXPECT_EQ(hal::panels::find_module(""), nullptr);
}

/// Makes the module of this name on a model and starts it.
template <class Model>
hal::panels::BusPanel& started(ModuleStorage& storage, std::string_view name, Model& model,
                               hal::panels::SpiPort& port, hal::Clock& clock,
                               const hal::panels::ModuleOptions& options) {
  hal::panels::BusPanel& panel =
      hal::panels::find_module(name)->make(storage, {.port = &port, .clock = &clock, .options = options});
  EXPECT_TRUE(panel.start().ok()) << name;
  EXPECT_TRUE(model.on());
  return panel;
}

TEST(Modules, WhatIsAskedForReachesTheController) {
  using namespace hal::mock;
  ModuleStorage storage;
  const auto ask = [&]<class Model>(std::string_view name, Model& model, hal::Clock& clock,
                                    const hal::panels::ModuleOptions& options) {
    hal::panels::SpiPort port(model.spi(), model.data_command());
    started(storage, name, model, port, clock, options);
  };
  hal::panels::ModuleOptions options{.negative = true, .contrast = std::uint8_t{77}};
  hal::sim::VirtualClock clock;
  StrictSsd1322 greys;
  ask("ssd1322", greys, clock, options);
  EXPECT_EQ(greys.displayed().at(0, 0), 15) << "the negative of black";
  EXPECT_EQ(greys.contrast(), 77);
  StrictSsd0323 few_greys;
  ask("ssd0323", few_greys, clock, options);
  EXPECT_EQ(few_greys.displayed().at(0, 0), 15);
  StrictSsd1306 mono(128, 64);
  ask("ssd1306", mono, clock, options);
  EXPECT_EQ(mono.displayed().at(0, 0), 1);
  EXPECT_EQ(mono.contrast(), 77);
  options.te = hal::panels::TearingEffect::vblank;
  options.te_line = 5;
  StrictSt7789 tft(clock);
  ask("st7789", tft, clock, options);
  EXPECT_EQ(tft.displayed().at(0, 0), 0xFFFF);
  EXPECT_EQ(tft.brightness(), 77);
  EXPECT_EQ(tft.tearing(), StrictDcs::Tearing::vblank);
  EXPECT_EQ(tft.tearing_line(), 5);
}

TEST(Modules, AnyGlassIsHitInAllRotations) {
  // Beyond the offset of the module, 52 and 40.
  const hal::mock::DcsGlass mounted{.width = 20,
                                    .height = 30,
                                    .column_offset = 59,
                                    .row_offset = 49,
                                    .mirrored = true,
                                    .bgr = true,
                                    .inverted = true};
  const hal::panels::ModuleGlass glass{
      .width = 20, .height = 30, .column_offset = 7, .row_offset = 9, .mirrored = true, .bgr = true};
  std::vector<std::uint8_t> blues(768);
  for (std::size_t i = 0; i < 256; ++i)
    blues[3 * i + 2] = static_cast<std::uint8_t>((i % 32 * 255 + 15) / 31);
  ModuleStorage storage;
  for (const Rotation rotation : glass::rotations) {
    hal::sim::VirtualClock clock;
    hal::mock::StrictSt7789 model(clock, mounted);
    hal::panels::SpiPort port(model.spi(), model.data_command());
    hal::panels::BusPanel& panel =
        started(storage, "st7789-135x240", model, port, clock, {.rotation = rotation, .glass = glass});
    ASSERT_TRUE(panel.load_palette(blues).ok());
    glass::random_writes_show(panel, model, rotation, 70'001, 20,
                              [](int index, int, int) { return index % 32; });
  }
}

TEST(Modules, GlassThatLiesBesideTheMemoryIsRefused) {
  ModuleStorage storage;
  for (const int offset : {-1, -52, 320, INT32_MIN, INT32_MAX})
    for (const bool columns : {false, true}) {
      hal::sim::VirtualClock clock;
      const auto model = model_of("st7789-135x240", clock);
      hal::panels::SpiPort port(model->spi(), model->data_command());
      hal::panels::ModuleGlass glass;
      (columns ? glass.column_offset : glass.row_offset) = offset;
      hal::panels::BusPanel& panel =
          hal::panels::find_module("st7789-135x240")
              ->make(storage, {.port = &port, .clock = &clock, .options = {.glass = glass}});
      EXPECT_EQ(panel.start(), hal::Status(hal::Error::invalid, hal::Part::panel)) << offset;
      EXPECT_EQ(model->transfers(), 0);
    }
}

TEST(Modules, TellHowTheirBeamGoes) {
  using hal::panels::BeamLines;
  const auto lines = [](const char* name, const hal::panels::ModuleOptions& options = {}) {
    return hal::panels::find_module(name)->beam(options);
  };
  // The porches of the ST7789 are 12 and 12 lines, those of the ILI9341 2 and 2.
  EXPECT_EQ(lines("st7789"), (BeamLines{24, 344}));
  EXPECT_EQ(lines("st7789-240x240"), (BeamLines{24, 344}));
  EXPECT_EQ(lines("st7789-135x240"), (BeamLines{24 + 40, 344}));
  EXPECT_EQ(lines("ili9341"), (BeamLines{4, 324}));
  EXPECT_EQ(lines("ili9341-320x240", {.rotation = Rotation::by_180}), (BeamLines{4, 324}));
  EXPECT_EQ(lines("st7789-240x240", {.scan_up = true}), (BeamLines{24 + 80, 344}));
  EXPECT_EQ(lines("st7789-135x240", {.glass = {.height = 100, .row_offset = 10}}), (BeamLines{24 + 50, 344}));
  EXPECT_EQ(lines("st7789", {.scan_up = true, .glass = {.height = 100, .row_offset = 10}}),
            (BeamLines{24 + 210, 344}));
  EXPECT_EQ(lines("st7789", {.scan_up = true, .glass = {.height = INT32_MIN}}), (BeamLines{})) << "no glass";
  for (const Module& module : hal::panels::modules())
    EXPECT_EQ(module.beam != nullptr, module.te) << module.name;
}

TEST(Modules, OfTheSimulatorsCatalogueAreWhatItSimulates) {
  int simulated = 0;
  for (const Module& module : hal::panels::modules()) {
    const auto spec = hal::sim::find_panel(module.name);
    if (!spec) continue;
    ++simulated;
    SCOPED_TRACE(module.name);
    hal::sim::VirtualClock clock;
    const auto model = model_of(std::string(module.name), clock);
    hal::panels::SpiPort port(model->spi(), model->data_command());
    ModuleStorage storage;
    const hal::Capabilities& c = module.make(storage, {.port = &port, .clock = &clock}).capabilities();
    const hal::Capabilities& s = spec->capabilities;
    EXPECT_EQ(c.width, s.width);
    EXPECT_EQ(c.height, s.height);
    EXPECT_EQ(c.bits_per_pixel, s.bits_per_pixel);
    EXPECT_EQ(c.bit_order, s.bit_order);
    EXPECT_EQ(c.palette_entries, s.palette_entries);
    EXPECT_EQ(c.palette_on_write, s.palette_on_write);
    EXPECT_EQ(c.x_alignment, s.x_alignment);
    EXPECT_EQ(c.y_alignment, s.y_alignment);
    EXPECT_EQ(c.scan, s.scan);
    EXPECT_TRUE(std::ranges::equal(c.fixed_palette, spec->fixed_colours));
  }
  EXPECT_EQ(simulated, 6);
}

}  // namespace
