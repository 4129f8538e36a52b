// SPDX-License-Identifier: MIT
//
// The drivers of display controllers, against models of the controllers that know only the data sheets.
#include <hal/mock/doubles.hpp>
#include <hal/mock/strict_ssd0323.hpp>
#include <hal/mock/strict_ssd1306.hpp>
#include <hal/panels/ssd0323.hpp>
#include <hal/panels/ssd1306.hpp>
#include <hal/sim/catalog.hpp>
#include <hal/sim/virtual_clock.hpp>
#include <tests/hal/turned_glass.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace {

using hal::Error;
using hal::Part;
using hal::Status;
using hal::mock::Pattern;
using hal::mock::StrictSsd0323;
using hal::mock::StrictSsd1306;
using hal::panels::I2cFraming;
using hal::panels::I2cPort;
using hal::panels::SpiPort;
using hal::panels::Ssd0323;
using hal::panels::Ssd1306;

/// Sends random rectangles, whole frames among them, and compares every pixel of the glass after each.
template <class Model>
void random_writes_show(hal::Panel& panel, const Model& model, unsigned seed, int rounds) {
  ASSERT_TRUE(model.on());
  glass::random_writes_show(panel, model, glass::Rotation::by_0, seed, rounds,
                            [](int index, int, int) { return index; });
}

/// Breaks the wire at every transfer in turn: the driver must say so every time.
template <class Model, class MakePanel>
void faults_are_reported(Model make_model, MakePanel make_panel) {
  int transfers = 0;
  {
    auto model = make_model();
    make_panel(*model, [&](auto& panel) {
      EXPECT_TRUE(panel.start().ok());
      const hal::Capabilities& c = panel.capabilities();
      const std::vector<std::uint8_t> pixels(4096 + 64);
      EXPECT_TRUE(panel.write({0, 0, c.width, c.height}, pixels, c.width * c.bits_per_pixel / 8 + 1).ok());
    });
    transfers = model->transfers();
  }
  ASSERT_GT(transfers, 10);
  for (int good = 0; good < transfers; ++good) {
    auto model = make_model();
    model->fail_after(good);
    make_panel(*model, [&](auto& panel) {
      const Status started = panel.start();
      if (!started.ok()) {
        EXPECT_EQ(started.error(), Error::bus);
        return;
      }
      const hal::Capabilities& c = panel.capabilities();
      const std::vector<std::uint8_t> pixels(4096 + 64);
      const Status written =
          panel.write({0, 0, c.width, c.height}, pixels, c.width * c.bits_per_pixel / 8 + 1);
      EXPECT_EQ(written.error(), Error::bus) << good;
    });
    EXPECT_EQ(model->transfers(), good) << "a driver that goes on after a fault";
  }
}

TEST(Ssd0323, EveryPixelArrivesOverSpi) {
  StrictSsd0323 model;
  SpiPort port(model.spi(), model.data_command());
  Ssd0323 panel(port);
  ASSERT_TRUE(panel.start().ok());
  random_writes_show(panel, model, 40'001, 300);
}

TEST(Ssd0323, AWriteSendsItsWindowAndNotAByteMore) {
  StrictSsd0323 model;
  SpiPort port(model.spi(), model.data_command());
  Ssd0323 panel(port);
  ASSERT_TRUE(panel.start().ok());
  const auto commands = model.command_bytes();
  const auto data = model.data_bytes();
  const std::vector<std::uint8_t> pixels(64);
  ASSERT_TRUE(panel.write({10, 20, 8, 16}, pixels, 4).ok());
  EXPECT_EQ(model.command_bytes() - commands, 6U);
  EXPECT_EQ(model.data_bytes() - data, 64U);
}

TEST(Ssd0323, RowsCloseTogetherGoOutInOneTransfer) {
  StrictSsd0323 model;
  SpiPort port(model.spi(), model.data_command());
  Ssd0323 panel(port);
  ASSERT_TRUE(panel.start().ok());
  const int before = model.transfers();
  const std::vector<std::uint8_t> pixels(4096);
  ASSERT_TRUE(panel.write({0, 0, 128, 64}, pixels, 64).ok());
  EXPECT_EQ(model.transfers() - before, 3) << "window, line, pixels";
}

TEST(Ssd0323, NoiseIsNeverShown) {
  StrictSsd0323 model;
  SpiPort port(model.spi(), model.data_command());
  Ssd0323 panel(port);
  ASSERT_NE(model.memory(), Pattern::blank(128, 64)) << "the memory holds noise at power-on";
  ASSERT_TRUE(panel.start().ok());
  EXPECT_EQ(model.memory(), Pattern::blank(128, 64));
}

TEST(Ssd0323, FaultsOfBusAndPinAreReportedAndEndTheTransfer) {
  const auto make_panel = [](StrictSsd0323& model, auto use) {
    SpiPort port(model.spi(), model.data_command());
    Ssd0323 panel(port);
    use(panel);
  };
  faults_are_reported([] { return std::make_unique<StrictSsd0323>(); }, make_panel);
}

TEST(Ssd0323, IsThePanelOfTheSimulatorsCatalogue) {
  StrictSsd0323 model;
  SpiPort port(model.spi(), model.data_command());
  const Ssd0323 panel(port);
  const hal::Capabilities& c = panel.capabilities();
  const hal::sim::PanelSpec simulated = *hal::sim::find_panel("oled");
  const hal::Capabilities& s = simulated.capabilities;
  EXPECT_EQ(c.width, s.width);
  EXPECT_EQ(c.height, s.height);
  EXPECT_EQ(c.bits_per_pixel, s.bits_per_pixel);
  EXPECT_EQ(c.bit_order, s.bit_order);
  EXPECT_EQ(c.x_alignment, s.x_alignment);
  EXPECT_EQ(c.y_alignment, s.y_alignment);
  EXPECT_TRUE(std::ranges::equal(c.fixed_palette, simulated.fixed_colours));
}

TEST(Ssd1306, EveryPixelArrivesOverSpi) {
  StrictSsd1306 model(128, 64);
  SpiPort port(model.spi(), model.data_command());
  Ssd1306 panel(port);
  ASSERT_TRUE(panel.start().ok());
  random_writes_show(panel, model, 40'010, 300);
}

TEST(Ssd1306, EveryPixelArrivesOverI2c) {
  StrictSsd1306 model(128, 64, 0, 0x3D);
  I2cPort port(model.i2c(), 0x3D);
  Ssd1306 panel(port);
  ASSERT_TRUE(panel.start().ok());
  random_writes_show(panel, model, 40'011, 300);
}

TEST(Ssd1306, RelativesShowEveryPixelToo) {
  {
    StrictSsd1306 model(128, 32);
    I2cPort port(model.i2c(), 0x3C);
    Ssd1306 panel(port, hal::panels::ssd1306_128x32);
    ASSERT_TRUE(panel.start().ok());
    random_writes_show(panel, model, 40'012, 100);
  }
  {
    StrictSsd1306 model(128, 64, 2, 0x3C, 132);
    SpiPort port(model.spi(), model.data_command());
    Ssd1306 panel(port, hal::panels::sh1106_128x64);
    ASSERT_TRUE(panel.start().ok());
    random_writes_show(panel, model, 40'013, 100);
  }
  {
    StrictSsd1306 model(96, 16, 36, 0x3C, 132);
    I2cPort port(model.i2c(), 0x3C, I2cFraming::single);
    Ssd1306 panel(port, hal::panels::ssd0303_96x16);
    ASSERT_TRUE(panel.start().ok());
    random_writes_show(panel, model, 40'014, 100);
  }
}

TEST(Ssd1306, AHeightThatIsNoMultipleOfEightEndsInAPartPage) {
  StrictSsd1306 model(128, 20);
  I2cPort port(model.i2c(), 0x3C);
  hal::panels::Ssd1306Module module = hal::panels::ssd1306_128x32;
  module.height = 20;
  Ssd1306 panel(port, module);
  ASSERT_TRUE(panel.start().ok());
  random_writes_show(panel, model, 40'015, 100);
}

TEST(Ssd1306, SingleFramingSendsOneCommandByteATransaction) {
  testing::StrictMock<hal::mock::MockI2cBus> bus;
  I2cPort port(bus, 0x3D, I2cFraming::single);
  using testing::ElementsAre;
  const testing::InSequence in_order;
  EXPECT_CALL(bus, do_write(0x3D, ElementsAre(0x80), ElementsAre(0xAE)));
  EXPECT_CALL(bus, do_write(0x3D, ElementsAre(0x80), ElementsAre(0x40)));
  EXPECT_CALL(bus, do_write(0x3D, ElementsAre(0x40), ElementsAre(1, 2, 3)));
  const std::array<std::uint8_t, 2> commands{0xAE, 0x40};
  const std::array<std::uint8_t, 3> data{1, 2, 3};
  EXPECT_TRUE(port.command(commands).ok());
  EXPECT_TRUE(port.data(data).ok());
}

TEST(Ssd1306, FaultsAreReportedAndEndTheTransfer) {
  const auto over_i2c = [](StrictSsd1306& model, auto use) {
    I2cPort port(model.i2c(), 0x3C);
    Ssd1306 panel(port);
    use(panel);
  };
  const auto over_spi = [](StrictSsd1306& model, auto use) {
    SpiPort port(model.spi(), model.data_command());
    Ssd1306 panel(port);
    use(panel);
  };
  const auto make_model = [] { return std::make_unique<StrictSsd1306>(128, 64); };
  faults_are_reported(make_model, over_i2c);
  faults_are_reported(make_model, over_spi);
}

TEST(Drivers, TakeNoPaletteAndNoShow) {
  StrictSsd1306 model(128, 64);
  I2cPort port(model.i2c(), 0x3C);
  Ssd1306 panel(port);
  EXPECT_EQ(panel.show(0, {}), Status(Error::unsupported, Part::buffer));
  const std::array<std::uint8_t, 3> colour{};
  EXPECT_EQ(panel.load_palette(colour), Status(Error::unsupported, Part::palette));
  EXPECT_FALSE(panel.show_pending());
  EXPECT_TRUE(panel.buffer(0).empty());
  EXPECT_EQ(panel.capabilities().fixed_palette.size(), 6U);
}

TEST(FrameClock, TicksAtTheRefreshRate) {
  hal::sim::VirtualClock clock;
  StrictSsd0323 model;
  SpiPort port(model.spi(), model.data_command());
  Ssd0323 panel(port, &clock, {.refresh_millihertz = 50'000});
  hal::Clock& time = clock;
  clock.advance(123);
  EXPECT_EQ(panel.vblank_count(), 0U);
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(time.now(), 123U + 20'000'000U);
  EXPECT_EQ(panel.vblank_count(), 1U);
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(time.now(), 123U + 40'000'000U);
  clock.advance(59'999'999);
  EXPECT_EQ(panel.vblank_count(), 4U);
  clock.advance(1);
  EXPECT_EQ(panel.vblank_count(), 5U);
}

TEST(FrameClock, WithoutAClockEveryWaitIsATick) {
  StrictSsd0323 model;
  SpiPort port(model.spi(), model.data_command());
  Ssd0323 panel(port);
  EXPECT_EQ(panel.vblank_count(), 0U);
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(panel.vblank_count(), 1U);
}

}  // namespace
