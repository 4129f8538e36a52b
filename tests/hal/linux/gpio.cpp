// SPDX-License-Identifier: MIT
//
// Lines of GPIO over either libgpiod, above a kernel that isn't there.
#include "fake_gpio.hpp"
#include "spi_decoder.hpp"

#include <hal/linux/gpio.hpp>
#include <hal/mock/strict_ssd1306.hpp>
#include <hal/panels/ssd1306.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <random>

namespace {

using fake_gpio::kernel;
using hal::Error;
using hal::Part;
using hal::Status;
using hal::linux_io::BitBangSpi;
using hal::linux_io::DeviceError;
using hal::linux_io::line_address;
using hal::linux_io::LineAddress;
using hal::linux_io::OutputLine;
using hal::linux_io::TeLine;
using testing::AllOf;
using testing::HasSubstr;

constexpr hal::Nanoseconds ms = 1'000'000;
constexpr hal::Nanoseconds period = 1'000'000'000'000 / 60'000;

class Gpio : public testing::Test {
 protected:
  Gpio() {
    fake_gpio::reset();
    fake_gpio::Chip display{"display", std::vector<fake_gpio::Line>(8)};
    display.lines[0].name = "TE";
    display.lines[1].name = "DC";
    kernel().chips["/dev/gpiochip0"] = {"pinctrl", std::vector<fake_gpio::Line>(4)};
    kernel().chips["/dev/gpiochip3"] = display;
  }
  ~Gpio() override {
    EXPECT_EQ(kernel().held, 0) << "lines are still held";
    EXPECT_EQ(kernel().open, 0) << "chips are still open";
  }
  static int value(unsigned line) { return kernel().chips["/dev/gpiochip3"].lines[line].value; }
  static fake_gpio::Line& line(unsigned number) { return kernel().chips["/dev/gpiochip3"].lines[number]; }

  /// What can't be had is said in a text that holds all these words.
  template <class Make>
  static std::string refusal(Make make) {
    try {
      make();
    } catch (const DeviceError& error) {
      return error.what();
    }
    return "it was accepted";
  }
};

TEST_F(Gpio, AddressesNameAChipOrTakeTheDefault) {
  EXPECT_EQ(line_address("25", "gpiochip0"), (LineAddress{"gpiochip0", "25"}));
  EXPECT_EQ(line_address("DC", "lab"), (LineAddress{"lab", "DC"}));
  EXPECT_EQ(line_address("gpiochip1:5", "gpiochip0"), (LineAddress{"gpiochip1", "5"}));
}

TEST_F(Gpio, AChipGoesByNameNumberPathAndLabelAndALineByNumberAndName) {
  for (const char* const chip : {"gpiochip3", "3", "/dev/gpiochip3", "display"})
    for (const char* const name : {"DC", "1"}) {
      OutputLine dc({chip, name}, true);
      EXPECT_EQ(value(1), 1) << chip;
      EXPECT_EQ(line(1).consumer, "intaglio");
      EXPECT_TRUE(dc.set(false).ok());
      EXPECT_EQ(value(1), 0);
      EXPECT_TRUE(dc.set(true).ok());
      EXPECT_EQ(value(1), 1);
      EXPECT_EQ(dc.fault(), "");
    }
}

TEST_F(Gpio, WhatCanNotBeHadIsSaidWithChipAndLine) {
  const auto output = [](const char* chip, const char* name) {
    return refusal([=] { OutputLine({chip, name}, true); });
  };
  EXPECT_THAT(output("gpiochip7", "1"), HasSubstr("GPIO chip /dev/gpiochip7: there is no such device"));
  EXPECT_THAT(output("lab", "1"),
              AllOf(HasSubstr("'lab'"), HasSubstr("gpiochip0 [pinctrl], gpiochip3 [display]")));
  EXPECT_THAT(output("gpiochip3", "RESET"), HasSubstr("gpiochip3 has no line 'RESET'"));
  EXPECT_THAT(output("gpiochip3", "8"), HasSubstr("gpiochip3 has lines 0 to 7, no 8"));
  EXPECT_THAT(output("gpiochip3", ""), HasSubstr("no line ''"));
  EXPECT_THAT(output("gpiochip3", "-1"), HasSubstr("no line '-1'"));
  kernel().chips["/dev/gpiochip3"].open_error = EACCES;
  EXPECT_THAT(output("3", "1"), HasSubstr("/dev/gpiochip3: permission denied; "));
  kernel().chips["/dev/gpiochip3"].open_error = ENOTTY;
  EXPECT_THAT(output("3", "1"), HasSubstr("/dev/gpiochip3 is no GPIO chip"));
}

TEST_F(Gpio, WhyNoChipCanBeOpenedIsSaidWhereALabelIsLookedFor) {
  for (auto& [path, chip] : kernel().chips) chip.open_error = EACCES;
  const auto labelled = [] { return refusal([] { OutputLine({"lab", "1"}, true); }); };
  EXPECT_THAT(labelled(), HasSubstr("GPIO chip /dev/gpiochip0: permission denied; "));
  kernel().chips["/dev/gpiochip3"].open_error = 0;
  EXPECT_THAT(labelled(), HasSubstr("no GPIO chip is called 'lab'; there are gpiochip3 [display]"));
  kernel().chips.clear();
  EXPECT_THAT(labelled(), HasSubstr("no GPIO chip is called 'lab'; there is none"));
}

TEST_F(Gpio, AChipWithoutLinesIsSaid) {
  kernel().chips["/dev/gpiochip0"].lines.clear();
  EXPECT_THAT(refusal([] {
                OutputLine({"gpiochip0", "5"}, true);
              }),
              HasSubstr("GPIO chip gpiochip0 has no lines, no 5"));
}

TEST_F(Gpio, AHeldLineIsSaidWithItsHolder) {
  line(1).consumer = "spi0 CS0";
  const std::string said = refusal([] { OutputLine({"gpiochip3", "DC"}, true); });
  EXPECT_THAT(said, HasSubstr("GPIO line 1 (DC) of gpiochip3 is in use by 'spi0 CS0'"));
  // Of several lines it is the held one that is named, and the others are given back.
  EXPECT_THAT(refusal([] {
                BitBangSpi({{"gpiochip3", "5"}, {"gpiochip3", "1"}});
              }),
              HasSubstr("line 1 (DC) of gpiochip3 is in use by 'spi0 CS0'"));
  line(0).consumer = "touch";
  EXPECT_THAT(refusal([] {
                TeLine({"gpiochip3", "TE"}, kernel().clock, 60'000);
              }),
              HasSubstr("line 0 (TE) of gpiochip3 is in use by 'touch'"));
}

TEST_F(Gpio, LinesDrivenTogetherAreOfOneChipAndDifferent) {
  EXPECT_THAT(refusal([] {
                BitBangSpi({{"gpiochip3", "5"}, {"gpiochip0", "1"}});
              }),
              HasSubstr("one chip, not of gpiochip3 and gpiochip0"));
  EXPECT_THAT(refusal([] {
                BitBangSpi({{"gpiochip3", "5"}, {"gpiochip3", "5"}});
              }),
              HasSubstr("named twice"));
}

TEST_F(Gpio, LinesDrivenTogetherAreAFew) {
  EXPECT_THAT(refusal([] { BitBangSpi({}); }), HasSubstr("1 to 8 at a time, not 0"));
  const std::vector<LineAddress> nine(9, LineAddress{"gpiochip3", "5"});
  EXPECT_THAT(refusal([&] { BitBangSpi{nine}; }), HasSubstr("not 9"));
}

TEST_F(Gpio, AChipPulledOutIsAFaultThatNamesTheLine) {
  OutputLine dc({"gpiochip3", "DC"}, true);
  kernel().calls_left = 0;
  kernel().error = ENODEV;
  EXPECT_EQ(dc.set(false), Status(Error::disconnected, Part::pin));
  EXPECT_THAT(dc.fault(), AllOf(HasSubstr("GPIO line 1 (DC) of gpiochip3"), HasSubstr("the device is gone")));
  kernel().error = EIO;
  EXPECT_EQ(dc.set(false), Status(Error::bus, Part::pin));
}

/// Writes random frames through lines of GPIO to a model of the controller and compares the glass.
void frames_arrive(bool with_select) {
  hal::mock::StrictSsd1306 model(128, 64);
  const fake_gpio::SpiLines lines{
      .clock = 5, .data = 4, .select = 6, .data_command = 1, .selected_always = !with_select};
  fake_gpio::SpiDecoder decoder(lines, model.spi(), model.data_command());
  kernel().on_set = [&decoder](const fake_gpio::Chip& chip) { decoder(chip); };
  std::vector<LineAddress> wires{{"gpiochip3", "5"}, {"gpiochip3", "4"}};
  if (with_select) wires.push_back({"gpiochip3", "6"});
  OutputLine data_command({"gpiochip3", "DC"}, false);
  BitBangSpi bus(wires);
  hal::panels::SpiPort port(bus, data_command);
  hal::panels::Ssd1306 panel(port);
  ASSERT_TRUE(panel.start().ok());
  std::mt19937 random(60'501);
  std::vector<std::uint8_t> frame(128 * 64 / 8);
  for (int round = 0; round < 3; ++round) {
    for (std::uint8_t& byte : frame) byte = static_cast<std::uint8_t>(random());
    ASSERT_TRUE(panel.write({0, 0, 128, 64}, frame, 16).ok());
    hal::mock::Pattern expected = hal::mock::Pattern::blank(128, 64);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 128; ++x)
        expected.at(x, y) = frame[static_cast<std::size_t>(y * 16 + x / 8)] >> (7 - x % 8) & 1;
    EXPECT_EQ(side_by_side(expected, model.displayed(), false), "");
  }
  kernel().on_set = [](const fake_gpio::Chip&) {};
}

TEST_F(Gpio, AFrameByHandArrivesAtTheController) { frames_arrive(true); }
TEST_F(Gpio, AFrameByHandArrivesWithoutASelectLine) { frames_arrive(false); }

TEST_F(Gpio, ATransferByHandEndsAtTheFirstFault) {
  const std::vector<std::uint8_t> bytes(3, 0x5A);
  BitBangSpi bus({{"gpiochip3", "5"}, {"gpiochip3", "4"}, {"gpiochip3", "6"}});
  kernel().error = ENODEV;
  for (const int calls : {0, 1, 20, 49}) {
    kernel().calls_left = calls;
    EXPECT_EQ(bus.write(bytes), Status(Error::disconnected, Part::bus)) << calls;
    EXPECT_THAT(bus.fault(), HasSubstr("GPIO line 5, 4, 6 of gpiochip3"));
  }
  kernel().calls_left = 50;
  EXPECT_TRUE(bus.write(bytes).ok()) << "two calls a bit, and two to end";
}

TEST_F(Gpio, ATransferByHandIsDeselectedAfterAFaultToo) {
  const std::vector<std::uint8_t> bytes(3, 0x5A);
  BitBangSpi bus({{"gpiochip3", "5"}, {"gpiochip3", "4"}, {"gpiochip3", "6"}});
  kernel().error = EIO;
  kernel().failures = 1;
  kernel().calls_left = 21;
  EXPECT_EQ(bus.write(bytes), Status(Error::bus, Part::bus));
  EXPECT_EQ(value(6), 1);
}

class Te : public Gpio {
 protected:
  Te() { kernel().clock.wait_until(5'000 * ms); }
  void edges(int count, hal::Nanoseconds first) {
    for (int i = 0; i < count; ++i) kernel().edges.push_back(first + static_cast<unsigned>(i) * period);
  }
  static constexpr hal::Nanoseconds start = 5'000 * ms;
};

TEST_F(Te, EveryEdgeIsAVblankWithItsTime) {
  TeLine te({"gpiochip3", "TE"}, kernel().clock, 60'000);
  EXPECT_EQ(te.count(), 0U);
  EXPECT_EQ(te.last(), 0U);
  edges(600, start + 3 * ms);
  for (unsigned i = 0; i < 600; ++i) {
    ASSERT_TRUE(te.wait().ok());
    ASSERT_EQ(te.count(), i + 1);
    ASSERT_EQ(te.last(), start + 3 * ms + i * period);
    kernel().clock.advance(i % 16 * ms);  // The program draws.
  }
  EXPECT_EQ(te.silences(), 0U);
  EXPECT_EQ(te.take_notices(), "");
}

TEST_F(Te, AWaitEndsWithAnEdgeThatComesAfterIt) {
  TeLine te({"gpiochip3", "TE"}, kernel().clock, 60'000);
  edges(10, start + ms);
  kernel().clock.advance(4 * period);
  ASSERT_TRUE(te.wait().ok());
  EXPECT_EQ(te.count(), 5U) << "four were over already";
}

TEST_F(Te, EdgesThatTheKernelCouldNotKeepAreReckonedFromTheTimesOfTheOthers) {
  for (const int away : {15, 16, 17, 40, 100}) {
    kernel().edges.clear();
    TeLine te({"gpiochip3", "TE"}, kernel().clock, 60'000);
    const hal::Nanoseconds first = kernel().clock.now() + ms;
    // The line is two per cent slow.
    for (unsigned i = 0; i < 200; ++i) kernel().edges.push_back(first + i * (period + period / 50));
    for (int i = 0; i < 40; ++i) ASSERT_TRUE(te.wait().ok());
    const std::uint32_t before = te.count();
    kernel().clock.advance(static_cast<unsigned>(away) * (period + period / 50));
    ASSERT_TRUE(te.wait().ok());
    EXPECT_EQ(te.count() - before, static_cast<unsigned>(away) + 1U);
  }
}

TEST_F(Te, AJitteringLineIsCountedEdgeByEdge) {
  TeLine te({"gpiochip3", "TE"}, kernel().clock, 60'000);
  std::mt19937 random(60'502);
  for (unsigned i = 0; i < 300; ++i) kernel().edges.push_back(start + i * period + random() % (14 * ms));
  for (unsigned i = 0; i < 300; ++i) {
    ASSERT_TRUE(te.wait().ok());
    ASSERT_EQ(te.count(), i + 1);
  }
}

TEST_F(Te, ASilentLineIsStoodInForUntilItIsHeardAgain) {
  TeLine te({"gpiochip3", "TE"}, kernel().clock, 60'000);
  edges(3, start + ms);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(te.wait().ok());
  // Silent: the first wait takes a quarter of a second, and what the timer would have told meanwhile counts.
  ASSERT_TRUE(te.wait().ok());
  EXPECT_TRUE(te.silent());
  EXPECT_EQ(te.count(), 3U + 250 * ms / period);
  EXPECT_THAT(te.take_notices(), AllOf(HasSubstr("GPIO line 0 (TE) of gpiochip3"), HasSubstr("silent")));
  EXPECT_EQ(te.take_notices(), "");
  const std::uint32_t before = te.count();
  const hal::Nanoseconds began = kernel().clock.now();
  for (unsigned i = 1; i <= 30; ++i) {
    ASSERT_TRUE(te.wait().ok());
    EXPECT_EQ(te.count(), before + i);
  }
  EXPECT_LE(kernel().clock.now() - began, 30 * period);
  EXPECT_GT(kernel().clock.now() - began, 29 * period);
  // Heard again.
  const hal::Nanoseconds first = kernel().clock.now() + 5 * ms;
  edges(4, first);
  ASSERT_TRUE(te.wait().ok());
  EXPECT_EQ(te.last(), first);
  EXPECT_FALSE(te.silent());
  EXPECT_EQ(te.silences(), 1U);
  EXPECT_THAT(te.take_notices(), HasSubstr("heard again"));
}

TEST_F(Te, ALineThatNeverRestsDoesNotHoldTheProgram) {
  TeLine te({"gpiochip3", "TE"}, kernel().clock, 60'000);
  kernel().storm = true;
  EXPECT_TRUE(te.wait().ok());
  EXPECT_GT(te.count(), 0U);
}

TEST_F(Te, SignalsDoNotEndAWait) {
  TeLine te({"gpiochip3", "TE"}, kernel().clock, 60'000);
  edges(1, start + 12 * ms);
  kernel().signals = 3;
  ASSERT_TRUE(te.wait().ok());
  EXPECT_EQ(te.count(), 1U);
}

TEST_F(Te, ALinePulledOutIsAFaultThatNamesIt) {
  TeLine te({"gpiochip3", "TE"}, kernel().clock, 60'000);
  kernel().calls_left = 0;
  kernel().error = ENODEV;
  EXPECT_EQ(te.wait(), Status(Error::disconnected, Part::pin));
  EXPECT_THAT(te.fault(), AllOf(HasSubstr("GPIO line 0 (TE) of gpiochip3"), HasSubstr("gone")));
}

}  // namespace
