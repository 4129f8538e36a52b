// SPDX-License-Identifier: MIT
//
// The models of display controllers report every breach of the protocol.
#include <hal/mock/strict_dcs.hpp>
#include <hal/mock/strict_ssd0323.hpp>
#include <hal/mock/strict_ssd1306.hpp>
#include <hal/mock/strict_ssd1322.hpp>
#include <hal/sim/virtual_clock.hpp>

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <array>
#include <initializer_list>

namespace {

using hal::mock::Pattern;
using hal::mock::StrictSsd0323;
using hal::mock::StrictSsd1306;

void send(hal::mock::StrictController& chip, bool data, std::initializer_list<std::uint8_t> bytes) {
  chip.data_command().set(data).ignore();
  chip.spi().write(std::span(bytes.begin(), bytes.size())).ignore();
}

TEST(StrictController, BytesBeforeTheLineIsDriven) {
  StrictSsd0323 chip;
  const std::array<std::uint8_t, 1> off{0xAE};
  EXPECT_NONFATAL_FAILURE(chip.spi().write(off).ignore(), "before the data/command line was driven");
}

TEST(StrictController, DataInsideACommand) {
  StrictSsd0323 chip;
  send(chip, false, {0x15, 0});
  EXPECT_NONFATAL_FAILURE(chip.data_command().set(true).ignore(), "0x15 still waits for parameters");
}

TEST(StrictController, CommandLeftOpen) {
  StrictSsd0323 chip;
  send(chip, false, {0xB8, 1, 2});
  EXPECT_NONFATAL_FAILURE(chip.expect_idle(), "0xB8 still waits for parameters");
}

TEST(StrictController, UnknownCommands) {
  StrictSsd0323 grey;
  EXPECT_NONFATAL_FAILURE(send(grey, false, {0xC8}), "unknown command 0xC8");
  StrictSsd1306 mono(128, 64);
  EXPECT_NONFATAL_FAILURE(send(mono, false, {0xD0}), "unknown command 0xD0");
}

TEST(StrictController, ParametersOutOfRange) {
  StrictSsd0323 chip;
  EXPECT_NONFATAL_FAILURE(send(chip, false, {0x15, 0, 64}), "parameter 64 is not in 0 .. 63");
  EXPECT_NONFATAL_FAILURE(send(chip, false, {0x75, 5, 4}), "parameter 4 is not in 5 .. 79");
  EXPECT_NONFATAL_FAILURE(send(chip, false, {0x81, 200}), "parameter 200 is not in 0 .. 127");
}

TEST(StrictController, MoreDataThanTheWindowHas) {
  StrictSsd0323 chip;
  send(chip, false, {0x15, 3, 4, 0x75, 7, 7});
  send(chip, true, {1, 2});
  EXPECT_NONFATAL_FAILURE(send(chip, true, {3}), "more data than the window has");
}

TEST(StrictController, NewWindowBeforeTheLastIsFull) {
  StrictSsd0323 chip;
  send(chip, false, {0x15, 3, 4, 0x75, 7, 7});
  send(chip, true, {1});
  EXPECT_NONFATAL_FAILURE(send(chip, false, {0x15, 0, 63}), "1 of 2 bytes are missing");
}

TEST(StrictController, DataBeyondThePage) {
  StrictSsd1306 chip(128, 64, 2, 0x3C, 132);
  send(chip, false, {0xB0, 0x03, 0x18});  // Column 131.
  send(chip, true, {1});
  EXPECT_NONFATAL_FAILURE(send(chip, true, {1}), "beyond the end of page 0");
}

TEST(StrictController, WrongAddressOrControlByteOnI2c) {
  StrictSsd1306 chip(128, 64);
  const std::array<std::uint8_t, 1> prefix{0x00};
  const std::array<std::uint8_t, 1> wrong{0x41};
  const std::array<std::uint8_t, 1> byte{0xAE};
  EXPECT_NONFATAL_FAILURE(chip.i2c().write(0x3D, prefix, byte).ignore(),
                          "nothing answers at I2C address 0x3D");
  EXPECT_NONFATAL_FAILURE(chip.i2c().write(0x3C, wrong, byte).ignore(), "0x41 is no control byte");
  EXPECT_NONFATAL_FAILURE(chip.i2c().write(0x3C, prefix, {}).ignore(), "nothing behind it");
}

TEST(StrictSsd0323, NibblesColumnsAndRowsAreRemappedAsTheDataSheetSays) {
  StrictSsd0323 chip;
  send(chip, false, {0xA0, 0x12, 0x15, 0, 0, 0x75, 0, 0});  // Nibble and row remap.
  send(chip, true, {0x5A});
  send(chip, false, {0xAF});
  EXPECT_EQ(chip.displayed().at(0, 0), 5);
  EXPECT_EQ(chip.displayed().at(1, 0), 10);
  send(chip, false, {0xA0, 0x10});  // No nibble remap: the low nibble is left.
  EXPECT_EQ(chip.displayed().at(0, 0), 10);
  send(chip, false, {0xA0, 0x13});  // Columns reversed.
  EXPECT_EQ(chip.displayed().at(126, 0), 5);
  EXPECT_EQ(chip.displayed().at(127, 0), 10);
  send(chip, false, {0xA0, 0x11});  // And nibbles: mirrored.
  EXPECT_EQ(chip.displayed().at(127, 0), 5) << "mirrored against nibble remap alone";
  send(chip, false, {0xA0, 0x02});  // On its head.
  EXPECT_EQ(chip.displayed().at(0, 63), 5);
  send(chip, false, {0xA0, 0x12, 0xA7});
  EXPECT_EQ(chip.displayed().at(0, 0), 10) << "inverse";
  send(chip, false, {0xAE});
  EXPECT_EQ(chip.displayed(), Pattern::blank(128, 64));
}

TEST(StrictSsd0323, VerticalIncrementFillsTheWindowByColumns) {
  StrictSsd0323 chip;
  send(chip, false, {0xAF, 0xA0, 0x16, 0x15, 5, 6, 0x75, 9, 10});
  send(chip, true, {0x11, 0x22, 0x33, 0x44});
  EXPECT_EQ(chip.displayed().at(10, 9), 1);
  EXPECT_EQ(chip.displayed().at(10, 10), 2);
  EXPECT_EQ(chip.displayed().at(12, 9), 3);
  EXPECT_EQ(chip.displayed().at(12, 10), 4);
}

TEST(StrictSsd1306, AddressingModesMoveAsTheDataSheetSays) {
  for (const std::uint8_t mode : {std::uint8_t{0}, std::uint8_t{1}}) {
    StrictSsd1306 chip(128, 64);
    send(chip, false, {0xA1, 0xC8, 0xAF, 0x20, mode, 0x21, 10, 11, 0x22, 2, 3});
    send(chip, true, {0x01, 0x00, 0x01, 0x00});
    const Pattern shown = chip.displayed();
    EXPECT_EQ(shown.at(10, 16), 1);
    // Horizontal: the third byte begins the next page; vertical: the next column.
    EXPECT_EQ(shown.at(10, 24), mode == 0 ? 1 : 0);
    EXPECT_EQ(shown.at(11, 16), mode == 0 ? 0 : 1);
  }
}

/// A ST7789 that may be told anything, awake.
struct Tft {
  Tft() {
    clock.advance(200'000'000);
    send(chip, false, {0x11});
    clock.advance(200'000'000);
  }
  void tell(std::uint8_t command, std::initializer_list<std::uint8_t> parameters) {
    send(chip, false, {command});
    send(chip, true, parameters);
  }
  hal::sim::VirtualClock clock;
  hal::mock::StrictSt7789 chip{clock, {}};
};

TEST(StrictDcs, PausesThatAreTooShort) {
  Tft tft;
  send(tft.chip, false, {0x10});
  EXPECT_NONFATAL_FAILURE(send(tft.chip, false, {0x29}), "within 5 ms");
  tft.clock.advance(119'999'999);
  EXPECT_NONFATAL_FAILURE(send(tft.chip, false, {0x11}), "within 120 ms");
  tft.clock.advance(120'000'000);
  send(tft.chip, false, {0x01});
  EXPECT_NONFATAL_FAILURE(send(tft.chip, false, {0x00}), "within 5 ms");
  tft.clock.advance(119'000'000);
  EXPECT_NONFATAL_FAILURE(send(tft.chip, false, {0x11}), "within 120 ms");
}

TEST(StrictDcs, AResetOfAControllerThatIsWakingUp) {
  Tft tft;
  send(tft.chip, false, {0x10});
  tft.clock.advance(120'000'000);
  send(tft.chip, false, {0x11});
  tft.clock.advance(119'999'999);
  EXPECT_NONFATAL_FAILURE(send(tft.chip, false, {0x01}), "a reset within 120 ms after the end of sleep");
}

TEST(StrictDcs, TearingEffectAndBackLightFollowTheirSwitches) {
  using Tearing = hal::mock::StrictDcs::Tearing;
  Tft tft;
  tft.tell(0x35, {1});
  EXPECT_EQ(tft.chip.tearing(), Tearing::vblank_and_hblank);
  tft.tell(0x44, {0, 7});
  EXPECT_EQ(tft.chip.tearing(), Tearing::vblank) << "at a line there is nothing between lines";
  EXPECT_EQ(tft.chip.tearing_line(), 7);
  tft.tell(0x35, {0});
  EXPECT_EQ(tft.chip.tearing_line(), 0);
  send(tft.chip, false, {0x34});
  EXPECT_EQ(tft.chip.tearing(), Tearing::off);
  tft.tell(0x51, {99});
  EXPECT_EQ(tft.chip.brightness(), 0) << "nobody asked for the control of the back light";
  tft.tell(0x53, {0x24});
  EXPECT_EQ(tft.chip.brightness(), 99);
  EXPECT_NONFATAL_FAILURE(tft.tell(0x53, {0x25}), "bits 2, 3 and 5 alone");
}

TEST(StrictDcs, CommandsWithoutTheirParametersAndDataWithoutACommand) {
  Tft tft;
  EXPECT_NONFATAL_FAILURE(send(tft.chip, true, {1}), "data that no command asked for");
  send(tft.chip, false, {0x35});
  EXPECT_NONFATAL_FAILURE(send(tft.chip, false, {0x29}), "0x35 still waits for parameters");
  EXPECT_NONFATAL_FAILURE(tft.tell(0x35, {2}), "parameter 2 is not in 0 .. 1");
  EXPECT_NONFATAL_FAILURE(send(tft.chip, false, {0x05}), "unknown command 0x05");
}

TEST(StrictDcs, WindowsOutsideTheAddressesThatTheModeLeaves) {
  Tft tft;
  EXPECT_NONFATAL_FAILURE(tft.tell(0x2A, {0, 0, 0, 240}), "parameter 240 is not in 0 .. 239");
  EXPECT_NONFATAL_FAILURE(tft.tell(0x2B, {1, 63, 0, 0}), "parameter 0 is not in 319 .. 319");
  tft.tell(0x36, {0x20});
  tft.tell(0x2A, {0, 0, 1, 63});
  EXPECT_NONFATAL_FAILURE(tft.tell(0x2B, {0, 0, 0, 240}), "parameter 240 is not in 0 .. 239");
}

TEST(StrictDcs, WindowsThatAreNotFilledOrOverfilled) {
  Tft tft;
  tft.tell(0x3A, {0x55});
  tft.tell(0x2A, {0, 4, 0, 5});
  tft.tell(0x2B, {0, 9, 0, 9});
  tft.tell(0x2C, {1, 2, 3});
  std::string told;
  tft.chip.on_breach([&](std::string_view what) { told += std::string(what) + "; "; });
  send(tft.chip, false, {0x00});
  EXPECT_EQ(told, "part of a pixel; a window is left with 1 pixels missing; ");
  tft.chip.on_breach({});
  tft.tell(0x2C, {1, 2, 3, 4});
  EXPECT_NONFATAL_FAILURE(send(tft.chip, true, {5, 6}), "more pixels than the window has");
}

TEST(StrictDcs, FormatsModesAndColoursAreTheDataSheets) {
  Tft tft;
  send(tft.chip, false, {0x29});
  const auto pixel = [&](std::uint8_t format, std::initializer_list<std::uint8_t> bytes, int x) {
    tft.tell(0x3A, {format});
    tft.tell(0x2A, {0, static_cast<std::uint8_t>(x), 0, static_cast<std::uint8_t>(x + 1)});
    tft.tell(0x2B, {0, 7, 0, 7});
    tft.tell(0x2C, bytes);
  };
  pixel(0x55, {0xF8, 0x00, 0x07, 0xE0}, 0);
  pixel(0x66, {0xFC, 0, 0, 0, 0xFC, 0}, 2);
  pixel(0x53, {0xF0, 0x00, 0xF0}, 4);
  for (int x = 0; x < 6; x += 2) {
    EXPECT_EQ(tft.chip.displayed().at(x, 7), 0xF800) << x;
    EXPECT_EQ(tft.chip.displayed().at(x + 1, 7), 0x07E0) << x;
  }
  send(tft.chip, false, {0x21});
  EXPECT_EQ(tft.chip.displayed().at(0, 7), 0x07FF) << "inverted";
  send(tft.chip, false, {0x20});
  tft.tell(0x36, {0x08});
  EXPECT_EQ(tft.chip.displayed().at(0, 7), 0x001F) << "blue first";
  EXPECT_NONFATAL_FAILURE(tft.tell(0x3A, {0x57}), "there is no pixel format");
  send(tft.chip, false, {0x28});
  EXPECT_EQ(tft.chip.displayed(), Pattern::blank(240, 320));
}

TEST(StrictDcs, AddressModeExchangesAndMirrors) {
  struct Case {
    std::uint8_t mode;
    int x, y;
  };
  // Where address (3, 5) lies, by the table "Address control" of the data sheet.
  for (const Case& c : {Case{0x00, 3, 5}, Case{0x40, 236, 5}, Case{0x80, 3, 314}, Case{0xC0, 236, 314},
                        Case{0x20, 5, 3}, Case{0x60, 234, 3}, Case{0xA0, 5, 316}, Case{0xE0, 234, 316}}) {
    Tft tft;
    tft.tell(0x3A, {0x55});
    tft.tell(0x36, {c.mode});
    tft.tell(0x2A, {0, 3, 0, 3});
    tft.tell(0x2B, {0, 5, 0, 5});
    tft.tell(0x2C, {0x12, 0x34});
    EXPECT_EQ(tft.chip.memory().at(c.x, c.y), 0x1234) << int{c.mode};
  }
}

TEST(StrictSsd1322, WhatItReports) {
  hal::mock::StrictSsd1322 chip;
  const auto tell = [&](std::uint8_t command, std::initializer_list<std::uint8_t> parameters) {
    send(chip, false, {command});
    send(chip, true, parameters);
  };
  EXPECT_NONFATAL_FAILURE(tell(0x15, {0, 120}), "parameter 120 is not in 0 .. 119");
  EXPECT_NONFATAL_FAILURE(tell(0x75, {9, 8}), "parameter 8 is not in 9 .. 127");
  tell(0x15, {30, 30});
  tell(0x75, {2, 2});
  EXPECT_NONFATAL_FAILURE(send(chip, true, {1}), "data that no command asked for");
  tell(0x5C, {1});
  EXPECT_NONFATAL_FAILURE(tell(0xA2, {0}), "1 bytes missing");
  tell(0x5C, {1, 2});
  EXPECT_NONFATAL_FAILURE(send(chip, true, {3}), "more data than the window has");
  EXPECT_NONFATAL_FAILURE(tell(0x00, {}), "a grey table is used that wasn't set");
  EXPECT_EQ(chip.pulse_width(15), 112) << "that of power-on";
  EXPECT_NONFATAL_FAILURE(tell(0xB8, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 14}),
                          "not in 15 .. 180");
  EXPECT_NONFATAL_FAILURE(tell(0xA0, {0x34, 0x11}), "two rows at once");
  EXPECT_NONFATAL_FAILURE(tell(0xAF, {}), "not all rows of the glass");
  tell(0xFD, {0x16});
  EXPECT_NONFATAL_FAILURE(tell(0xA2, {0}), "locked");
}

TEST(StrictSsd1322, ColumnsNibblesAndRowsAreRemappedAsTheDataSheetSays) {
  hal::mock::StrictSsd1322 chip;
  const auto tell = [&](std::uint8_t command, std::initializer_list<std::uint8_t> parameters) {
    send(chip, false, {command});
    send(chip, true, parameters);
  };
  tell(0xCA, {63});
  tell(0xA0, {0x14, 0x11});
  tell(0x15, {28, 28});
  tell(0x75, {0, 0});
  tell(0x5C, {0x12, 0x34});
  tell(0xAF, {});
  const auto row = [&](int x, int y) {
    const Pattern shown = chip.displayed();
    return std::array<int, 4>{shown.at(x, y), shown.at(x + 1, y), shown.at(x + 2, y), shown.at(x + 3, y)};
  };
  EXPECT_EQ(row(0, 0), (std::array<int, 4>{1, 2, 3, 4}));
  tell(0xA0, {0x16, 0x11});
  EXPECT_EQ(row(252, 0), (std::array<int, 4>{4, 3, 2, 1})) << "columns";
  tell(0xA0, {0x10, 0x11});
  EXPECT_EQ(row(0, 0), (std::array<int, 4>{4, 3, 2, 1})) << "nibbles";
  tell(0xA0, {0x04, 0x11});
  EXPECT_EQ(row(0, 63), (std::array<int, 4>{1, 2, 3, 4})) << "rows";
  tell(0xA7, {});
  EXPECT_EQ(row(0, 63), (std::array<int, 4>{14, 13, 12, 11})) << "inverse";
}

TEST(StrictController, BreachesAreToldToWhoeverAsks) {
  StrictSsd0323 chip;
  std::string told;
  chip.on_breach([&](std::string_view what) { told = what; });
  send(chip, false, {0xC8});
  EXPECT_EQ(told, "unknown command 0xC8");
}

}  // namespace
