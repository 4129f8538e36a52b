// SPDX-License-Identifier: MIT
//
// Panels that a command line wires up, with models of the controllers at the ends of the wires.
#include <hal/linux/monotonic_clock.hpp>
#include <hal/mock/strict_dcs.hpp>
#include <hal/mock/strict_ssd0323.hpp>
#include <hal/mock/strict_ssd1306.hpp>
#include <hal/sim/catalog.hpp>
#include <hal/sim/panel.hpp>
#include <host/attach/attach.hpp>
#include <host/failure.hpp>
#include <tests/hal/linux/fake_gpio.hpp>
#include <tests/hal/linux/spi_decoder.hpp>
#include <tests/host/attach/test_card.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>

namespace {

using fake_gpio::kernel;
using host::AttachOptions;
using testing::AllOf;
using testing::HasSubstr;

AttachOptions by_hand(const char* panel) {
  AttachOptions options;
  options.panel = panel;
  options.bitbang = "SCK,MOSI,CS";
  options.data_command = "DC";
  return options;
}

class Wired : public testing::Test {
 protected:
  Wired() {
    fake_gpio::reset();
    fake_gpio::Chip chip{"display", std::vector<fake_gpio::Line>(8)};
    const char* const names[] = {"TE", "DC", "RST", "SCK", "MOSI", "CS"};
    for (std::size_t i = 0; i < std::size(names); ++i) chip.lines[i].name = names[i];
    kernel().chips["/dev/gpiochip0"] = chip;
  }
  ~Wired() override {
    kernel().on_set = [](const fake_gpio::Chip&) {};
    EXPECT_EQ(kernel().held, 0) << "lines are still held";
  }

  template <class Model>
  void put_at_the_ends(Model& model) {
    const fake_gpio::SpiLines lines{.clock = 3, .data = 4, .select = 5, .data_command = 1};
    kernel().on_set = [decoder = fake_gpio::SpiDecoder(lines, model.spi(), model.data_command())](
                          const fake_gpio::Chip& chip) mutable { decoder(chip); };
  }

  static std::string refusal(const AttachOptions& options) {
    try {
      static_cast<void>(host::attach(options));
    } catch (const host::Failure& failure) {
      return failure.what();
    }
    return "it was accepted";
  }
};

/// What the simulator shows of the test card after so many frames.
hal::mock::Pattern simulated(const char* panel_name, std::uint32_t frames) {
  hal::sim::VirtualClock clock;
  hal::sim::Panel panel(*hal::sim::find_panel(panel_name), clock);
  EXPECT_TRUE(host::run_test_card(panel, frames).ok());
  const hal::sim::Picture picture = panel.displayed();
  hal::mock::Pattern pattern = hal::mock::Pattern::blank(picture.width, picture.height);
  const int greys = (1 << panel.capabilities().bits_per_pixel) - 1;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      pattern.at(x, y) = picture.rgb[static_cast<std::size_t>(y * picture.width + x) * 3U] * greys / 255;
  return pattern;
}

template <class Model>
void shows_what_the_simulator_shows(Model& model, const char* real, const char* simulated_name) {
  constexpr std::uint32_t frames = 3;
  {
    const auto attached = host::attach(by_hand(real));
    EXPECT_TRUE(host::run_test_card(attached->panel(), frames).ok());
    EXPECT_TRUE(model.on());
    EXPECT_EQ(side_by_side(simulated(simulated_name, frames), model.displayed(), false), "");
  }
  EXPECT_FALSE(model.on()) << "left on";
}

TEST_F(Wired, AnSsd1306ShowsWhatTheSimulatorShowsAndIsLeftBlank) {
  hal::mock::StrictSsd1306 model(128, 64);
  put_at_the_ends(model);
  shows_what_the_simulator_shows(model, "ssd1306", "ssd1306");
}

TEST_F(Wired, AnSsd0323ShowsWhatTheSimulatorShowsAndIsLeftBlank) {
  hal::mock::StrictSsd0323 model;
  put_at_the_ends(model);
  shows_what_the_simulator_shows(model, "ssd0323", "oled");
}

TEST_F(Wired, AnSt7789IsTurnedInvertedAndToldToPulseItsTeLine) {
  hal::linux_io::MonotonicClock clock;
  hal::mock::StrictSt7789 model(clock);
  put_at_the_ends(model);
  AttachOptions options = by_hand("st7789");
  options.rotate = 90;
  options.invert = true;
  options.te = "TE";
  {
    const auto attached = host::attach(options);
    hal::Panel& panel = attached->panel();
    EXPECT_EQ(panel.capabilities().width, 320);
    EXPECT_TRUE(panel.capabilities().vblank_signal);
    EXPECT_EQ(model.tearing(), hal::mock::StrictSt7789::Tearing::vblank);
    const std::vector<std::uint8_t> black_red{0, 0, 0, 255, 0, 0};
    ASSERT_TRUE(panel.load_palette(black_red).ok());
    const std::vector<std::uint8_t> pixels{0, 1, 1, 1, 0, 1};
    ASSERT_TRUE(panel.write({10, 20, 3, 2}, pixels, 3).ok());
    // Turned clockwise: the picture's rows run down the glass, from its right edge on. Negative: red is cyan.
    const hal::mock::Pattern glass = model.displayed();
    constexpr int cyan = 0x07FF;
    constexpr int white = 0xFFFF;
    for (int i = 0; i < 6; ++i)
      EXPECT_EQ(glass.at(239 - (20 + i / 3), 10 + i % 3),
                pixels[static_cast<std::size_t>(i)] == 0 ? white : cyan)
          << i;
  }
  EXPECT_FALSE(model.on());
}

TEST_F(Wired, ATftTakesAnotherGlass) {
  hal::linux_io::MonotonicClock clock;
  hal::mock::StrictSt7789 model(clock, {.width = 20,
                                        .height = 12,
                                        .column_offset = 7,
                                        .row_offset = 30,
                                        .mirrored = true,
                                        .bgr = true,
                                        .inverted = true});
  put_at_the_ends(model);
  AttachOptions options = by_hand("st7789");
  options.size = "20x12";
  options.offset = "7,30";
  options.mirror = true;
  options.bgr = true;
  const auto attached = host::attach(options);
  hal::Panel& panel = attached->panel();
  ASSERT_TRUE(panel.load_palette(std::vector<std::uint8_t>{0, 0, 0, 255, 0, 0}).ok());
  std::vector<std::uint8_t> pixels(20 * 12);
  pixels[3 * 20 + 5] = 1;
  ASSERT_TRUE(panel.write({0, 0, 20, 12}, pixels, 20).ok());
  const hal::mock::Pattern glass = model.displayed();
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 20; ++x) ASSERT_EQ(glass.at(x, y), x == 5 && y == 3 ? 0xF800 : 0) << x << ' ' << y;
}

TEST_F(Wired, APanelOfTwoColoursDithersAPictureOf256) {
  hal::mock::StrictSsd1306 model(128, 64);
  put_at_the_ends(model);
  AttachOptions options = by_hand("ssd1306");
  options.dither = true;
  const auto attached = host::attach(options);
  hal::Panel& panel = attached->panel();
  EXPECT_EQ(panel.capabilities().palette_entries, 256);
  const std::vector<std::uint8_t> grey(3, 128);
  ASSERT_TRUE(panel.load_palette(grey).ok());
  const std::vector<std::uint8_t> pixels(128 * 64);
  ASSERT_TRUE(panel.write({0, 0, 128, 64}, pixels, 128).ok());
  const hal::mock::Pattern glass = model.displayed();
  int lit = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 128; ++x) lit += glass.at(x, y);
  EXPECT_NEAR(lit, 2048, 1024) << "half the code is less than half the light";
}

TEST_F(Wired, APanelThatKeepsItsPictureIsLeftOn) {
  hal::mock::StrictSsd1306 model(128, 64);
  put_at_the_ends(model);
  {
    const auto attached = host::attach(by_hand("ssd1306"));
    EXPECT_TRUE(attached->keep());
  }
  EXPECT_TRUE(model.on());
}

TEST_F(Wired, AChipPulledOutMidFrameEndsTheRunWithItsName) {
  hal::mock::StrictSsd1306 model(128, 64);
  put_at_the_ends(model);
  const auto attached = host::attach(by_hand("ssd1306"));
  kernel().calls_left = 1000;
  kernel().error = ENODEV;
  const intaglio::Status status = host::run_test_card(attached->panel(), 5);
  EXPECT_EQ(status.error(), intaglio::Error::device);
  EXPECT_THAT(attached->fault(), AllOf(HasSubstr("of gpiochip0"), HasSubstr("the device is gone")));
}

TEST_F(Wired, AFaultWhileStartingIsSaidAndGivesTheLinesBack) {
  kernel().calls_left = 200;
  kernel().error = EIO;
  EXPECT_THAT(refusal(by_hand("ssd1306")), AllOf(HasSubstr("ssd1306: GPIO line"), HasSubstr("of gpiochip0")));
}

TEST_F(Wired, AResetIsAPulseBeforeAnythingElse) {
  hal::mock::StrictSsd1306 model(128, 64);
  put_at_the_ends(model);
  AttachOptions options = by_hand("ssd1306");
  options.reset = "RST";
  std::vector<int> levels;
  kernel().on_set = [&, next = kernel().on_set](const fake_gpio::Chip& chip) {
    if (levels.empty() || levels.back() != chip.lines[2].value) levels.push_back(chip.lines[2].value);
    next(chip);
  };
  static_cast<void>(host::attach(options));
  EXPECT_THAT(levels, testing::ElementsAre(1, 0, 1));
}

TEST_F(Wired, OptionsThatMakeNoSenseAreSaid) {
  EXPECT_THAT(refusal({.panel = "ssd1306", .spi = "/dev/spidev0.0"}), HasSubstr("--dc"));
  AttachOptions options = by_hand("ssd1306");
  options.spi = "/dev/spidev0.0";
  EXPECT_THAT(refusal(options), HasSubstr("one of --spi, --i2c and --bitbang"));
  options = by_hand("ssd1306");
  options.bitbang = "SCK";
  EXPECT_THAT(refusal(options), HasSubstr("'SCK'"));
  options = by_hand("ssd1306");
  options.bitbang = "SCK,MOSI,DC";
  EXPECT_THAT(refusal(options), HasSubstr("GPIO line 1 (DC) of gpiochip0 is in use by 'intaglio'"));
  options = by_hand("ssd1306");
  options.te = "TE";
  EXPECT_THAT(refusal(options), HasSubstr("--te"));
  options = by_hand("st7789");
  options.dither = true;
  EXPECT_THAT(refusal(options), HasSubstr("--dither"));
  options = by_hand("ssd1306");
  options.size = "128x32";
  EXPECT_THAT(refusal(options), HasSubstr("ssd1306 knows no --size"));
  options = by_hand("st7789");
  for (const char* const size : {"64", "0x64", "64x", "64x64x8", "-1x5", "99999x1"}) {
    options.size = size;
    EXPECT_THAT(refusal(options), HasSubstr("--size is as 240x240")) << size;
  }
  options.size = "64x64";
  options.offset = "5";
  EXPECT_THAT(refusal(options), HasSubstr("--offset is as 0,80"));
  options.offset = "200,0";
  EXPECT_THAT(refusal(options), HasSubstr("can't be set up as the options say")) << "beyond the memory";
  EXPECT_THAT(refusal({.panel = "kms:/dev/dri/card0", .rotate = 90}), HasSubstr("knows no --rotate"));
  EXPECT_THAT(refusal({.panel = "fb:"}), HasSubstr("names no device"));
  for (const char* const size : {"320x", "x240", "320x240x8", "0x5", "320", ""})
    EXPECT_THAT(refusal({.panel = std::string("fb:/dev/fb0@") + size}), HasSubstr("as in @320x240")) << size;
  EXPECT_THAT(refusal(by_hand("ssd9999")), AllOf(HasSubstr("'ssd9999'"), HasSubstr("ssd1306")));
  EXPECT_THAT(refusal(by_hand("nowhere:1")), HasSubstr("no wires"));
  EXPECT_THAT(refusal({.panel = "nowhere:1"}), HasSubstr("'nowhere:'"));
}

TEST_F(Wired, WiresOrASchemeMeanARealPanel) {
  EXPECT_TRUE(host::means_attached(by_hand("ssd1306")));
  EXPECT_TRUE(host::means_attached({.panel = "kms:/dev/dri/card0"}));
  EXPECT_FALSE(host::means_attached({.panel = "ssd1306"}));
  EXPECT_FALSE(host::means_attached({.panel = "320x240x8"}));
}

}  // namespace
