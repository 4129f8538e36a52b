// SPDX-License-Identifier: MIT
//
// The models of display controllers report every breach of the protocol.
#include <hal/mock/strict_ssd0323.hpp>
#include <hal/mock/strict_ssd1306.hpp>

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
  StrictSsd1306 chip(128, 64);
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
  EXPECT_EQ(chip.displayed().at(127, 0), 5);
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

}  // namespace
