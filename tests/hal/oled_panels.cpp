// SPDX-License-Identifier: MIT
//
// OLED controllers turned, dimmed, asleep and behind a palette, against models that know only the data
// sheets.
#include <hal/mock/strict_ssd0323.hpp>
#include <hal/mock/strict_ssd1306.hpp>
#include <hal/mock/strict_ssd1322.hpp>
#include <hal/panels/expanded_panel.hpp>
#include <hal/panels/ssd0323.hpp>
#include <hal/panels/ssd1306.hpp>
#include <hal/panels/ssd1322.hpp>
#include <hal/sim/virtual_clock.hpp>
#include <tests/hal/turned_glass.hpp>
#include <tests/oracle/samples.hpp>

#include <array>
#include <cmath>

namespace {

using glass::Rotation;
using hal::mock::Pattern;
using hal::mock::StrictSsd0323;
using hal::mock::StrictSsd1306;
using hal::mock::StrictSsd1322;
using hal::panels::ExpandedPanel;
using hal::panels::I2cPort;
using hal::panels::SpiPort;
using hal::panels::Ssd0323;
using hal::panels::Ssd1306;
using hal::panels::Ssd1306Module;
using hal::panels::Ssd1322;

int same(int index, int, int) { return index; }

template <class Panel, class Model>
void shows_every_pixel(Panel& panel, const Model& model, Rotation rotation, unsigned seed, int rounds) {
  ASSERT_TRUE(panel.start().ok());
  ASSERT_TRUE(model.on());
  glass::random_writes_show(panel, model, rotation, seed, rounds, same);
  EXPECT_TRUE(glass::beam_runs_as_told(panel.capabilities(), model, rotation));
}

TEST(Ssd1322, EveryPixelArrivesInAllRotations) {
  for (const Rotation rotation : glass::rotations) {
    StrictSsd1322 model;
    SpiPort port(model.spi(), model.data_command());
    Ssd1322 panel(port, nullptr, nullptr, {.rotation = rotation});
    shows_every_pixel(panel, model, rotation, 60'001, oracle::samples(40, 400));
  }
}

TEST(Ssd0323, EveryPixelArrivesInAllRotations) {
  for (const Rotation rotation : glass::rotations) {
    StrictSsd0323 model;
    I2cPort port(model.i2c(), 0x3D);
    Ssd0323 panel(port, nullptr, {.rotation = rotation});
    shows_every_pixel(panel, model, rotation, 60'002, oracle::samples(60, 600));
  }
}

TEST(Ssd1306, EveryPixelArrivesInAllRotationsOnAllRelatives) {
  struct Case {
    const Ssd1306Module* module;
    int memory_columns;
  };
  const std::array<Case, 4> cases{{{&hal::panels::ssd1306_128x64, 128},
                                   {&hal::panels::ssd1306_128x32, 128},
                                   {&hal::panels::sh1106_128x64, 132},
                                   {&hal::panels::ssd0303_96x16, 132}}};
  for (const Case& c : cases)
    for (const Rotation rotation : glass::rotations) {
      const Ssd1306Module& m = *c.module;
      SCOPED_TRACE(std::to_string(m.width) + "x" + std::to_string(m.height));
      StrictSsd1306 model(m.width, m.height, m.column_offset, 0x3C, c.memory_columns);
      SpiPort port(model.spi(), model.data_command());
      Ssd1306 panel(port, m, nullptr, {.rotation = rotation});
      shows_every_pixel(panel, model, rotation, 60'003, oracle::samples(60, 600));
    }
}

TEST(OledPanels, FaultsAreReportedAndLeaveNoTrace) {
  glass::faults_leave_no_trace(
      [](const auto& use) {
        StrictSsd1322 model;
        SpiPort port(model.spi(), model.data_command());
        Ssd1322 panel(port, nullptr, nullptr, {.rotation = Rotation::by_270});
        use(panel, model, Rotation::by_270, same);
      },
      17);
  glass::faults_leave_no_trace(
      [](const auto& use) {
        StrictSsd0323 model;
        SpiPort port(model.spi(), model.data_command());
        Ssd0323 panel(port, nullptr, {.rotation = Rotation::by_90});
        use(panel, model, Rotation::by_90, same);
      },
      5);
  glass::faults_leave_no_trace([](const auto& use) {
    StrictSsd1306 model(128, 64);
    I2cPort port(model.i2c(), 0x3C);
    Ssd1306 panel(port);
    use(panel, model, Rotation::by_0, same);
  });
  glass::faults_leave_no_trace([](const auto& use) {
    StrictSsd1306 model(128, 64);
    I2cPort port(model.i2c(), 0x3C, hal::panels::I2cFraming::single);
    Ssd1306 panel(port, hal::panels::ssd1306_128x64, nullptr, {.rotation = Rotation::by_90});
    use(panel, model, Rotation::by_90, same);
  });
}

TEST(OledPanels, NegativeContrastAndSleepReachTheController) {
  StrictSsd1322 model;
  SpiPort port(model.spi(), model.data_command());
  Ssd1322 panel(port, nullptr, nullptr, {.negative = true, .contrast = 33});
  ASSERT_TRUE(panel.start().ok());
  EXPECT_EQ(model.contrast(), 33);
  EXPECT_EQ(model.displayed().at(100, 50), 15) << "the negative of black";
  ASSERT_TRUE(panel.set_contrast(44).ok());
  EXPECT_EQ(model.contrast(), 44);
  ASSERT_TRUE(panel.sleep(true).ok());
  EXPECT_FALSE(model.on());
  ASSERT_TRUE(panel.sleep(false).ok());
  EXPECT_TRUE(model.on());
  ASSERT_TRUE(panel.stop().ok());
  EXPECT_FALSE(model.on());
  StrictSsd1306 mono(128, 64);
  SpiPort mono_port(mono.spi(), mono.data_command());
  Ssd1306 mono_panel(mono_port, hal::panels::ssd1306_128x64, nullptr, {.negative = true});
  ASSERT_TRUE(mono_panel.start().ok());
  EXPECT_EQ(mono.displayed().at(5, 5), 1);
  EXPECT_EQ(mono.contrast(), 0xCF) << "the module's own";
  ASSERT_TRUE(mono_panel.set_contrast(1).ok());
  EXPECT_EQ(mono.contrast(), 1);
  Ssd1306 dim(mono_port, hal::panels::ssd1306_128x64, nullptr, {.contrast = 22});
  ASSERT_TRUE(dim.start().ok());
  EXPECT_EQ(mono.contrast(), 22);
}

TEST(Ssd1322, OfMoreThan64RowsDrivesEachRowAlone) {
  for (const int height : {64, 65, 128}) {
    StrictSsd1322 model;
    std::string told;
    model.on_breach([&](std::string_view what) { told += what; });
    SpiPort port(model.spi(), model.data_command());
    Ssd1322 panel(port, nullptr, nullptr, {.height = height});
    ASSERT_TRUE(panel.start().ok());
    EXPECT_EQ(told.find("two rows at once"), std::string::npos) << height << ": " << told;
  }
}

TEST(Ssd1322, GreysAreEvenToTheEye) {
  StrictSsd1322 model;
  SpiPort port(model.spi(), model.data_command());
  Ssd1322 panel(port);
  ASSERT_TRUE(panel.start().ok());
  for (int grey = 0; grey < 16; ++grey) {
    const double coded = grey / 15.0;
    const double light = coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
    EXPECT_NEAR(model.pulse_width(grey), 180 * light, 1.2) << grey;
  }
}

TEST(Ssd1322, OptionsThatCannotBeAreRefusedAndNothingIsSent) {
  const std::array<hal::panels::Ssd1322Options, 7> all{{{.width = 255},
                                                        {.width = 0},
                                                        {.width = 484, .column_offset = 0},
                                                        {.height = 129},
                                                        {.column_offset = 57},
                                                        {.column_offset = -1},
                                                        {.refresh_millihertz = 0}}};
  for (const auto& options : all) {
    StrictSsd1322 model;
    SpiPort port(model.spi(), model.data_command());
    Ssd1322 panel(port, nullptr, nullptr, options);
    EXPECT_EQ(panel.start(), hal::Status(hal::Error::invalid, hal::Part::panel));
    EXPECT_EQ(model.transfers(), 0);
  }
}

TEST(OledPanels, OptionsThatCannotBeAreRefusedAndNothingIsSent) {
  StrictSsd0323 grey;
  SpiPort grey_port(grey.spi(), grey.data_command());
  const std::array<hal::panels::Ssd0323Options, 4> options{
      {{.contrast = 128}, {.offset = 80}, {.refresh_millihertz = 0}, {.rotation = static_cast<Rotation>(4)}}};
  for (const auto& o : options) {
    Ssd0323 panel(grey_port, nullptr, o);
    EXPECT_EQ(panel.start(), hal::Status(hal::Error::invalid, hal::Part::panel));
  }
  StrictSsd1306 mono(128, 64);
  SpiPort mono_port(mono.spi(), mono.data_command());
  const std::array<Ssd1306Module, 7> modules{{{},
                                              {.width = 128, .height = 65},
                                              {.width = 129, .height = 64},
                                              {.width = 128, .height = 64, .column_offset = 1},
                                              {.width = 8, .height = 8, .column_offset = -1},
                                              {.width = 8, .height = 8, .memory_columns = INT32_MAX},
                                              {.width = 8, .height = 8, .refresh_millihertz = 0}}};
  for (const Ssd1306Module& module : modules) {
    Ssd1306 panel(mono_port, module);
    EXPECT_EQ(panel.start(), hal::Status(hal::Error::invalid, hal::Part::panel));
  }
  EXPECT_EQ(grey.transfers() + mono.transfers(), 0);
}

TEST(OledPanels, OptionsAtTheirLimitsAreTaken) {
  const std::array<hal::panels::Ssd1322Options, 4> grey{
      {{.width = 4}, {.width = 480, .column_offset = 0}, {.height = 128}, {.height = 16}}};
  for (const auto& options : grey) {
    StrictSsd1322 model;
    model.on_breach([](std::string_view) {});  // Its glass has another size.
    SpiPort port(model.spi(), model.data_command());
    Ssd1322 panel(port, nullptr, nullptr, options);
    EXPECT_TRUE(panel.start().ok());
    EXPECT_EQ(panel.capabilities().width, options.width);
    EXPECT_EQ(panel.capabilities().height, options.height);
  }
  StrictSsd0323 model;
  SpiPort port(model.spi(), model.data_command());
  EXPECT_TRUE(Ssd0323(port, nullptr, {.contrast = 127, .offset = 79}).start().ok());
  StrictSsd1306 mono(132, 64, 0, 0x3C, 132);
  SpiPort mono_port(mono.spi(), mono.data_command());
  Ssd1306Module widest = hal::panels::sh1106_128x64;
  widest.width = 132;
  widest.column_offset = 0;
  Ssd1306 panel(mono_port, widest);
  shows_every_pixel(panel, mono, Rotation::by_0, 60'004, 20);
}

/// Any colours.
std::vector<std::uint8_t> colours() {
  std::vector<std::uint8_t> all(768);
  std::mt19937 random(77);
  for (std::uint8_t& channel : all) channel = static_cast<std::uint8_t>(random());
  std::fill(all.begin() + 3, all.begin() + 6, std::uint8_t{255});
  std::fill(all.begin(), all.begin() + 3, std::uint8_t{0});
  return all;
}

double luma(const std::vector<std::uint8_t>& palette, int index) {
  const auto i = static_cast<std::size_t>(index) * 3;
  return 0.2126 * palette[i] + 0.7152 * palette[i + 1] + 0.0722 * palette[i + 2];
}

TEST(ExpandedPanel, ShowsTheNearestGreyOfEachColour) {
  const std::vector<std::uint8_t> palette = colours();
  for (const Rotation rotation : glass::rotations) {
    StrictSsd1322 model;
    SpiPort port(model.spi(), model.data_command());
    Ssd1322 panel(port, nullptr, nullptr, {.rotation = rotation});
    std::array<std::uint8_t, 200> workspace{};
    ExpandedPanel expanded(panel, workspace);
    EXPECT_TRUE(expanded.capabilities().palette_on_write);
    EXPECT_EQ(expanded.capabilities().palette_entries, 256);
    ASSERT_TRUE(panel.start().ok());
    ASSERT_TRUE(expanded.load_palette(palette).ok());
    const auto nearest = [&](int index, int, int) {
      return static_cast<int>(std::lround(luma(palette, index) * 15 / 255));
    };
    // Weights in 1/256 may round a luma up or down by one: colours on the border of a level are left out.
    glass::Writer writer(expanded, 61'000, nearest);
    for (int round = 0; round < 6; ++round) {
      ASSERT_TRUE(writer.write(round == 0).ok());
      const Pattern seen = glass::picture(model.displayed(), rotation);
      int far = 0;
      int other = 0;
      for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
        const int off = std::abs(seen.pixels[i] - writer.expected().pixels[i]);
        far += off > 1 ? 1 : 0;
        other += off == 1 ? 1 : 0;
      }
      EXPECT_EQ(far, 0);
      EXPECT_LT(other, static_cast<int>(seen.pixels.size() / 20));
    }
  }
}

TEST(ExpandedPanel, DithersTheSameWhateverThePartsItIsWrittenIn) {
  const std::vector<std::uint8_t> palette = colours();
  Pattern first;
  for (const std::size_t size : {std::size_t{8}, std::size_t{72}, std::size_t{128}, std::size_t{5000}}) {
    StrictSsd1306 model(128, 64);
    SpiPort port(model.spi(), model.data_command());
    Ssd1306 panel(port);
    std::vector<std::uint8_t> workspace(size);
    ExpandedPanel expanded(panel, workspace);
    ASSERT_TRUE(panel.start().ok());
    ASSERT_TRUE(expanded.load_palette(palette).ok());
    std::vector<std::uint8_t> pixels(std::size_t{128} * 64);
    std::mt19937 random(3);
    for (std::uint8_t& pixel : pixels) pixel = static_cast<std::uint8_t>(random());
    if (size == 5000) {
      for (int y = 0; y < 64; y += 16)
        for (int x = 0; x < 128; x += 24) {
          const int width = std::min(24, 128 - x);
          const auto at = static_cast<std::size_t>(y * 128 + x);
          ASSERT_TRUE(expanded.write({x, y, width, 16}, std::span(pixels).subspan(at), 128).ok());
        }
    } else {
      ASSERT_TRUE(expanded.write({0, 0, 128, 64}, pixels, 128).ok());
    }
    if (first.pixels.empty()) first = model.displayed();
    EXPECT_EQ(side_by_side(first, model.displayed(), false), "") << size;
  }
}

/// The book's matrix of thresholds, by its recursion from [[0, 2], [3, 1]].
int recursive_threshold(int size, int x, int y) {
  if (size == 1) return 0;
  constexpr std::array<std::array<int, 2>, 2> smallest{{{0, 2}, {3, 1}}};
  const int half = size / 2;
  const int quarter = smallest[static_cast<std::size_t>(y / half)][static_cast<std::size_t>(x / half)];
  return 4 * recursive_threshold(half, x % half, y % half) + quarter;
}

TEST(ExpandedPanel, ThresholdsAreTheRecursiveMatrixAndMakeNoStripes) {
  for (int y = 0; y < 8; ++y) {
    int row = 0;
    int column = 0;
    for (int x = 0; x < 8; ++x) {
      EXPECT_EQ(static_cast<int>(hal::panels::bayer_threshold(x, y)), recursive_threshold(8, x, y));
      row += hal::panels::bayer_threshold(x, y) < 32 ? 1 : 0;
      column += hal::panels::bayer_threshold(y, x) < 32 ? 1 : 0;
    }
    EXPECT_EQ(row, 4);
    EXPECT_EQ(column, 4);
  }
}

TEST(ExpandedPanel, DitherGivesTheLightOfTheGrey) {
  int last = -1;
  for (unsigned grey = 0; grey < 256; ++grey) {
    int lit = 0;
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) {
        lit += hal::panels::dithered(grey, x, y) ? 1 : 0;
        EXPECT_EQ(hal::panels::dithered(grey, x, y), hal::panels::dithered(grey, x + 8, y + 16));
      }
    const double coded = grey / 255.0;
    const double light = coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
    EXPECT_NEAR(hal::panels::light_of(grey) / 65280.0, light, 0.004) << grey;
    EXPECT_NEAR(lit, 64 * light, 0.5 + 64 * 0.004) << grey;
    EXPECT_GE(lit, last) << "brighter, but fewer pixels";
    last = lit;
  }
  EXPECT_EQ(last, 64);
  EXPECT_FALSE(hal::panels::dithered(0, 0, 0));
}

TEST(ExpandedPanel, ATooSmallWorkspaceAndAPanelWithColoursAreRefused) {
  StrictSsd1306 model(128, 64);
  SpiPort port(model.spi(), model.data_command());
  Ssd1306 panel(port);
  ASSERT_TRUE(panel.start().ok());
  const int before = model.transfers();
  std::array<std::uint8_t, 7> workspace{};
  ExpandedPanel small(panel, workspace);
  const std::array<std::uint8_t, 64> pixels{};
  EXPECT_EQ(small.write({0, 0, 8, 8}, pixels, 8), hal::Status(hal::Error::invalid, hal::Part::buffer));
  std::array<std::uint8_t, 8> enough{};
  ExpandedPanel once(panel, enough);
  ExpandedPanel twice(once, workspace);
  EXPECT_EQ(twice.write({0, 0, 8, 8}, pixels, 8), hal::Status(hal::Error::unsupported, hal::Part::panel));
  EXPECT_EQ(model.transfers(), before);
  EXPECT_TRUE(once.write({0, 0, 8, 8}, pixels, 8).ok());
}

}  // namespace
