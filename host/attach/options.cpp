// SPDX-License-Identifier: MIT
#include <host/attach/attach.hpp>

#include <CLI/CLI.hpp>

namespace host {

void add_attach_options(CLI::App& app, AttachOptions& options) {
  const std::string group = "Real panels (lines of GPIO are numbers, names, or CHIP:LINE)";
  app.add_option("--spi", options.spi, "SPI device of the panel, as /dev/spidev0.0")->group(group);
  app.add_option("--spi-hz", options.spi_hertz, "Clock of the SPI device")
      ->check(CLI::Range(std::uint32_t{1000}, std::uint32_t{200'000'000}))
      ->capture_default_str()
      ->group(group);
  app.add_option("--spi-mode", options.spi_mode, "Polarity and phase of the clock")
      ->check(CLI::Range(0, 3))
      ->capture_default_str()
      ->group(group);
  app.add_option("--i2c", options.i2c, "I2C bus of the panel, as /dev/i2c-1")->group(group);
  app.add_option("--address", options.address, "Address of the panel on it (default: its usual one)")
      ->check(CLI::Range(0x03, 0x77))
      ->group(group);
  app.add_option("--bitbang", options.bitbang, "SPI by lines of GPIO: SCK,MOSI,CS or SCK,MOSI")->group(group);
  app.add_option("--gpio", options.gpio, "GPIO chip of lines that name none")
      ->capture_default_str()
      ->group(group);
  app.add_option("--dc", options.data_command, "Line that tells data from commands")->group(group);
  app.add_option("--reset", options.reset, "Line that resets the panel, low")->group(group);
  app.add_option("--te", options.te, "Line on which the panel tells its VBLANK (tearing effect)")
      ->group(group);
  app.add_option("--size", options.size, "Size of a TFT's glass, as 240x240 (default: as its name says)")
      ->group(group);
  app.add_option("--offset", options.offset, "Where that glass begins in the controller's memory, as 0,80")
      ->group(group);
  app.add_flag("--bgr", options.bgr, "A TFT that shows red as blue")->group(group);
  app.add_flag("--mirror", options.mirror, "A TFT that shows left on the right")->group(group);
  app.add_option("--rotate", options.rotate, "Turn the picture clockwise, degrees")
      ->check(CLI::IsMember({0, 90, 180, 270}))
      ->group(group);
  app.add_flag("--invert", options.invert, "Show the negative")->group(group);
  app.add_flag("--dither", options.dither,
               "Draw 256 colours on a panel of greys, which shows the nearest, or dithers if it has but two")
      ->group(group);
  app.add_option("--contrast", options.contrast, "Contrast or brightness, 0 to 255")
      ->check(CLI::Range(0, 255))
      ->group(group);
  app.add_option_function<int>(
         "--refresh",
         [&options](int hertz) { options.refresh_millihertz = static_cast<std::uint32_t>(hertz) * 1000U; },
         "Refreshes a second, where the panel tells none or its TE line is silent (default: its usual)")
      ->check(CLI::Range(1, 1000))
      ->group(group);
}

}  // namespace host
