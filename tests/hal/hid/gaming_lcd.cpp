// SPDX-License-Identifier: MIT
//
// A keyboard's display, modelled from what the device does with a report, not from the driver.
#include <hal/hid/host/gaming_lcd.hpp>
#include <tests/hal/hid/keyboard.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace {

using hal::Key;
using hal::hid::GamingLcd;
using hal::hid::LcdInput;
using tests::hid::Bytes;
using tests::hid::Keyboard;

TEST(GamingLcd, ShowsEveryPixelWhereItBelongs) {
  Keyboard keyboard;
  GamingLcd panel(keyboard);
  ASSERT_TRUE(panel.start().ok());
  EXPECT_EQ(std::count(keyboard.glass.begin() + 1, keyboard.glass.end(), 0), 991);
  std::mt19937 random(3);
  constexpr int stride = 23;
  Bytes picture(static_cast<std::size_t>(stride) * 43U);
  for (auto& byte : picture) byte = static_cast<std::uint8_t>(random());
  ASSERT_TRUE(panel.write({0, 0, 160, 43}, picture, stride).ok());
  EXPECT_EQ(keyboard.reports, 2);
  int wrong = 0;
  for (int y = 0; y < 43; ++y)
    for (int x = 0; x < 160; ++x)
      wrong +=
          keyboard.pixel(x, y) != (picture[static_cast<std::size_t>(y * stride + x / 8)] >> (7 - x % 8) & 1);
  EXPECT_EQ(wrong, 0);
  // Below the glass nothing is set.
  for (int y = 43; y < 48; ++y)
    for (int x = 0; x < 160; ++x) wrong += keyboard.pixel(x, y);
  EXPECT_EQ(wrong, 0);
}

TEST(GamingLcd, TakesOnlyWholeFrames) {
  Keyboard keyboard;
  GamingLcd panel(keyboard);
  const Bytes picture(20U * 43U);
  EXPECT_EQ(panel.write({0, 0, 80, 43}, picture, 20).error(), hal::Error::misaligned);
  EXPECT_EQ(panel.write({0, 0, 160, 8}, picture, 20).error(), hal::Error::misaligned);
}

TEST(GamingLcd, SaysThatItIsGone) {
  Keyboard keyboard;
  GamingLcd panel(keyboard);
  keyboard.cable.pull();
  EXPECT_EQ(panel.write({0, 0, 160, 43}, Bytes(20U * 43U), 20).error(), hal::Error::disconnected);
}

hal::Keys keys_of(std::initializer_list<Key> held) {
  hal::Keys keys;
  for (const Key key : held) keys.press(key);
  return keys;
}

TEST(GamingLcd, TellsTheKeysOfEachDevice) {
  struct Case {
    std::uint16_t product;
    Bytes report;
    hal::Keys keys;
  };
  const std::vector<Case> cases = {
      {0xC21C, {1, 128, 128, 0, 0, 0, 0, 0}, {}},
      {0xC21C, {1, 128, 128, 0xFF, 0xFF, 0x3F, 0, 0x80}, {}},
      {0xC21C, {1, 128, 128, 0, 0, 0, 0x01, 0}, keys_of({Key::back})},
      {0xC21C, {1, 128, 128, 0, 0, 0, 0x12, 0}, keys_of({Key::left, Key::right})},
      {0xC21C, {1, 0, 128, 0, 0, 0, 0, 0}, keys_of({Key::left})},
      {0xC21C, {1, 255, 0, 0, 0, 0, 0, 0x08}, keys_of({Key::right, Key::up, Key::select})},
      {0xC21C, {1, 128, 255, 0, 0, 0, 0, 0}, keys_of({Key::down})},
      {0xC227, {2, 0x40, 0x88, 0, 0}, keys_of({Key::back, Key::down, Key::select})},
      {0xC22D, {3, 0, 0, 0x10, 0x05}, keys_of({Key::back, Key::up, Key::select})},
      {0xC22E, {3, 0xFF, 0xFF, 0x0F, 0x10}, keys_of({Key::right})},
  };
  for (const Case& c : cases) {
    Keyboard keyboard;
    const hal::hid::LcdDevice* device = hal::hid::lcd_device(c.product);
    ASSERT_NE(device, nullptr);
    LcdInput input(keyboard, *device);
    keyboard.said.push_back(c.report);
    EXPECT_EQ(input.poll(), c.keys) << device->name;
    // Other reports, and halves of this one, tell nothing.
    keyboard.said.push_back(
        {static_cast<std::uint8_t>(c.report[0] + 1), 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF});
    keyboard.said.push_back({c.report[0], 0xFF});
    keyboard.said.push_back({});
    EXPECT_EQ(input.poll(), c.keys) << device->name;
    keyboard.cable.pull();
    EXPECT_EQ(input.poll(), hal::Keys{});
  }
  EXPECT_EQ(hal::hid::lcd_device(0x1234), nullptr);
}

}  // namespace
