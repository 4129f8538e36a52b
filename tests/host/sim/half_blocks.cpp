// SPDX-License-Identifier: MIT
#include <host/sim/half_blocks.hpp>

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <string>
#include <utility>

namespace {

using host::RgbPicture;

void paint(RgbPicture& picture, int x, int y, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  const auto pixel = picture.at(x, y);
  pixel[0] = r;
  pixel[1] = g;
  pixel[2] = b;
}

/// What a terminal shows: reads the few sequences that are allowed and paints two pixels a half block.
RgbPicture screen_of(const std::string& text, int columns, int rows) {
  RgbPicture screen(columns, 2 * rows);
  std::map<int, std::array<int, 3>> colour;
  int x = 0;
  int row = 0;
  for (std::size_t at = 0; at < text.size();) {
    if (text.compare(at, 4, "\x1b[0m") == 0) {
      colour.clear();
      at += 4;
    } else if (text[at] == '\x1b') {
      int layer = 0;
      std::array<int, 3> c{};
      int used = 0;
      EXPECT_EQ(std::sscanf(text.c_str() + at, "\x1b[%d;2;%d;%d;%dm%n", &layer, &c[0], &c[1], &c[2], &used),
                4);
      if (used == 0) return screen;
      colour[layer] = c;
      at += static_cast<std::size_t>(used);
    } else if (text.compare(at, 2, "\r\n") == 0) {
      x = 0;
      ++row;
      at += 2;
    } else {
      EXPECT_EQ(text.substr(at, 3), "\u2580");
      for (int half = 0; half < 2; ++half)
        for (std::size_t i = 0; i < 3; ++i)
          screen.at(x, 2 * row + half)[i] = static_cast<std::uint8_t>(colour.at(half == 0 ? 38 : 48)[i]);
      ++x;
      at += 3;
    }
  }
  return screen;
}

TEST(HalfBlocks, ATerminalShowsThePicture) {
  RgbPicture picture(7, 6);
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 7; ++x)
      paint(picture, x, y, static_cast<std::uint8_t>(x / 2 * 40), static_cast<std::uint8_t>(y * 30),
            static_cast<std::uint8_t>(x + y));
  EXPECT_EQ(screen_of(host::half_blocks(picture), 7, 3), picture);
}

TEST(HalfBlocks, AnOddLastRowHasBlackBelow) {
  RgbPicture picture(2, 3);
  paint(picture, 1, 2, 9, 8, 7);
  const RgbPicture screen = screen_of(host::half_blocks(picture), 2, 2);
  EXPECT_EQ(screen.at(1, 2)[0], 9);
  EXPECT_EQ(screen.at(1, 3)[0], 0);
}

TEST(ShrinkToFit, APictureThatFitsStays) {
  RgbPicture picture(80, 48);
  paint(picture, 79, 47, 1, 2, 3);
  EXPECT_EQ(host::shrink_to_fit(picture, 80, 24), picture);
}

TEST(ShrinkToFit, TakesTheLeastFactorAndTheMean) {
  RgbPicture picture(5, 4);
  paint(picture, 0, 0, 200, 0, 0);
  paint(picture, 1, 1, 100, 0, 0);
  paint(picture, 4, 0, 50, 0, 0);
  const RgbPicture small = host::shrink_to_fit(picture, 4, 10);
  ASSERT_EQ(small.width, 3);
  ASSERT_EQ(small.height, 2);
  EXPECT_EQ(small.at(0, 0)[0], 75);
  EXPECT_EQ(small.at(2, 0)[0], 25);
}

TEST(ShrinkToFit, FitsAnyTerminal) {
  const RgbPicture picture(320, 240);
  for (int columns = 1; columns < 200; columns += 13) {
    for (int rows = 1; rows < 60; rows += 7) {
      const RgbPicture small = host::shrink_to_fit(picture, columns, rows);
      EXPECT_LE(small.width, columns);
      EXPECT_LE(small.height, 2 * rows);
      EXPECT_GE(small.width, 1);
      EXPECT_GE(small.height, 1);
    }
  }
}

}  // namespace
