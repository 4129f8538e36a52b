// SPDX-License-Identifier: MIT
#include <host/sim/options.hpp>

#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

namespace {

using host::Options;

std::variant<Options, int> parse(std::initializer_list<const char*> words) {
  std::vector<const char*> argv{"intaglio-sim"};
  argv.insert(argv.end(), words);
  return host::parse_command_line(static_cast<int>(argv.size()), argv.data());
}

TEST(SimOptions, ProgramAloneHasDefaults) {
  const auto parsed = parse({"gauges"});
  ASSERT_TRUE(std::holds_alternative<Options>(parsed));
  const Options& options = std::get<Options>(parsed);
  EXPECT_EQ(options.program, "gauges");
  EXPECT_EQ(options.panel, "clcd");
  EXPECT_FALSE(options.frames.has_value());
  EXPECT_EQ(options.frames_per_second, 60);
}

TEST(SimOptions, BadOnesEndWithAnErrorCode) {
  for (const std::initializer_list<const char*> words : {
           std::initializer_list<const char*>{},
           {"gauges", "--frames", "-1"},
           {"gauges", "--frames", "0"},
           {"gauges", "--frames", "many"},
           {"gauges", "--fps", "0"},
           {"gauges", "--scale", "0"},
           {"gauges", "--nonsense"},
           {"gauges", "map"},
           {"gauges", "--window", "--terminal"},
           {"gauges", "--digest", "--terminal"},
           {"gauges", "--buffers", "0"},
           {"gauges", "--late", "1"},
           {"gauges", "--order", "first"},
       }) {
    const auto parsed = parse(words);
    ASSERT_TRUE(std::holds_alternative<int>(parsed));
    EXPECT_NE(std::get<int>(parsed), 0);
  }
}

TEST(SimOptions, NamesOfThePaceAreThoseOfPresent) {
  const auto parsed = parse({"gauges", "--buffers", "3", "--late", "drop", "--order", "latest"});
  ASSERT_TRUE(std::holds_alternative<Options>(parsed));
  const Options& options = std::get<Options>(parsed);
  EXPECT_EQ(options.buffers, 3);
  EXPECT_EQ(options.late, intaglio::present::Late::drop);
  EXPECT_EQ(options.order, intaglio::present::Order::latest);
}

TEST(SimOptions, HelpIsNoError) {
  const auto parsed = parse({"--help"});
  ASSERT_TRUE(std::holds_alternative<int>(parsed));
  EXPECT_EQ(std::get<int>(parsed), 0);
}

TEST(SimOptions, WiresAndSchemesMeanARealPanel) {
  const auto parsed =
      parse({"gauges", "--panel",   "st7789", "--spi",  "/dev/spidev0.0", "--gpio",   "gpiochip1", "--dc",
             "25",     "--reset",   "RST",    "--te",   "gpiochip0:23",   "--spi-hz", "40000000",  "--rotate",
             "270",    "--address", "0x3D",   "--size", "240x240",        "--report", "counted"});
  ASSERT_TRUE(std::holds_alternative<Options>(parsed));
  const host::AttachOptions& attach = std::get<Options>(parsed).attach;
  EXPECT_TRUE(host::means_attached(attach));
  EXPECT_EQ(attach.panel, "st7789");
  EXPECT_EQ(attach.spi, "/dev/spidev0.0");
  EXPECT_EQ(attach.spi_hertz, 40'000'000U);
  EXPECT_EQ(attach.gpio, "gpiochip1");
  EXPECT_EQ(attach.data_command, "25");
  EXPECT_EQ(attach.reset, "RST");
  EXPECT_EQ(attach.te, "gpiochip0:23");
  EXPECT_EQ(attach.rotate, 270);
  EXPECT_EQ(attach.address, 0x3D);
  EXPECT_EQ(attach.size, "240x240");
  EXPECT_TRUE(host::means_attached(std::get<Options>(parse({"gauges", "--panel", "fb:/dev/fb0"})).attach));
  EXPECT_FALSE(host::means_attached(std::get<Options>(parse({"gauges", "--panel", "ssd1306"})).attach));
  const Options paced =
      std::get<Options>(parse({"gauges", "--panel", "fb:/dev/fb0", "--late", "drop", "--beam", "ignore"}));
  EXPECT_EQ(paced.late, intaglio::present::Late::drop);
  EXPECT_EQ(paced.chase, false);
}

TEST(SimOptions, WhatIsForSimulatedPanelsIsRefusedOnRealOnes) {
  for (const char* const option : {"--window", "--terminal", "--png=a", "--apng=a", "--effects=te",
                                   "--trace=a", "--explain", "--buffers=2", "--order=every"})
    EXPECT_TRUE(std::holds_alternative<int>(parse({"gauges", "--panel", "fb:/dev/fb0", option}))) << option;
  for (const char* const option :
       {"--report=a", "--beam=left", "--rotate=45", "--address=0x80", "--spi-mode=4", "--contrast=256"})
    EXPECT_TRUE(std::holds_alternative<int>(parse({"gauges", option}))) << option;
}

}  // namespace
