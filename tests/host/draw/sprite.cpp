// SPDX-License-Identifier: MIT
//
// Sprites and stretched pictures, pixel by pixel against the oracles of the blits.
#include <host/draw/program.hpp>
#include <host/failure.hpp>
#include <intaglio/number/sine.hpp>
#include <tests/host/run_tool.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/rotozoom.hpp>
#include <tests/oracle/scale.hpp>
#include <tests/oracle/three_shear.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using host::draw::draw_program;
using oracle::Wide;

constexpr int width = 24;
constexpr int height = 19;
constexpr int columns = 5;
constexpr int rows = 3;

// 5x3 pixels, red = green = blue = 17, 34, ... 255, row by row; alpha 127, 128, 255 along the diagonals. Made
// by python3's zlib and struct.
constexpr std::array<std::uint8_t, 129> png{
    0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48, 0x44, 0x52, 0x00,
    0x00, 0x00, 0x05, 0x00, 0x00, 0x00, 0x03, 0x08, 0x06, 0x00, 0x00, 0x00, 0x5B, 0x36, 0xC5, 0xF8, 0x00,
    0x00, 0x00, 0x48, 0x49, 0x44, 0x41, 0x54, 0x78, 0xDA, 0x63, 0x10, 0x14, 0x14, 0xAC, 0x57, 0x52, 0x52,
    0x6A, 0x30, 0x36, 0x36, 0xFE, 0xEF, 0xE2, 0xE2, 0x52, 0x1F, 0x1A, 0x1A, 0xDA, 0xC0, 0x90, 0x96, 0x96,
    0xD6, 0x50, 0x5E, 0x5E, 0xFE, 0xBF, 0xA3, 0xA3, 0xA3, 0x7E, 0xE6, 0xCC, 0x99, 0x0D, 0xAB, 0x56, 0xAD,
    0xFA, 0xCF, 0xB0, 0x7B, 0xF7, 0xEE, 0xFF, 0x67, 0xCE, 0x9C, 0xA9, 0xBF, 0x7B, 0xF7, 0x6E, 0xC3, 0xBB,
    0x77, 0xEF, 0xFE, 0x03, 0x41, 0x3D, 0x00, 0x34, 0xBF, 0x21, 0xDF, 0xA5, 0x6C, 0x34, 0x5D, 0x00, 0x00,
    0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82};

/// The index of a pixel of the sprite on the grey ramp of 16; 0 where it isn't opaque.
int sprite_at(Wide column, Wide row) {
  if (column < 0 || column >= columns || row < 0 || row >= rows || (column + row) % 3 == 0) return 0;
  return static_cast<int>(1 + column + columns * row);
}

class DrawSprite : public testing::Test {
 protected:
  void SetUp() override {
    test_host::write(folder_ / "s.png", {reinterpret_cast<const char*>(png.data()), png.size()});
  }
  /// Draws on 24x19 pixels of 4 bits, with FILE for the sprite's.
  [[nodiscard]] std::vector<std::uint8_t> draw(std::string commands) const {
    for (std::size_t at = 0; (at = commands.find("FILE")) != std::string::npos;)
      commands.replace(at, 4, folder_ / "s.png");
    const auto canvas = draw_program("surface 24 19 4\n" + commands + "\n");
    for (std::size_t i = 0; i < canvas->touched().size(); ++i)
      EXPECT_EQ(canvas->touched()[i], canvas->indices()[i] == 0 ? 0 : 1) << commands;
    return canvas->indices();
  }
  template <class Index>
  void expect_indices(const std::string& commands, Index index) const {
    std::vector<std::uint8_t> expected;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) expected.push_back(static_cast<std::uint8_t>(index(x, y)));
    EXPECT_EQ(draw(commands), expected) << commands;
  }
  test_host::Folder folder_;
};

TEST_F(DrawSprite, CopiesWhatIsOpaque) {
  expect_indices("sprite FILE 7 9", [](int x, int y) { return sprite_at(x - 7, y - 9); });
  expect_indices("clip 8 0 3 30\nsprite \"FILE\" 7 -1",
                 [](int x, int y) { return x >= 8 && x < 11 ? sprite_at(x - 7, y + 1) : 0; });
  expect_indices("sprite FILE 1048576 -1048576", [](int, int) { return 0; });
}

TEST_F(DrawSprite, StretchesToARectangle) {
  expect_indices("stretch FILE -3 2 20 11", [](int x, int y) {
    if (x + 3 >= 20 || y < 2 || y >= 13) return 0;
    return sprite_at(oracle::scaled_source(x + 3, columns, 20), oracle::scaled_source(y - 2, rows, 11));
  });
  expect_indices("stretch FILE 0 0 0 5", [](int, int) { return 0; });
}

TEST_F(DrawSprite, ScalesAndTurnsAboutItsMiddle) {
  for (const int angle : {0, 5000, -16384, 40000}) {
    const auto turn = intaglio::number::Angle::from_steps(angle);
    const oracle::Rotozoom rule{256 * 9 + 512,
                                256 * 8 + 256,
                                512,
                                256,
                                intaglio::number::cosine(turn).raw(),
                                intaglio::number::sine(turn).raw(),
                                65536 * 7 / 2};
    expect_indices("sprite FILE 9 8 7/2 " + std::to_string(angle),
                   [&](int x, int y) { return sprite_at(rule.column(x, y), rule.row(x, y)); });
  }
}

TEST_F(DrawSprite, TurnsByShearsWithoutLosingAPixel) {
  for (const int angle : {0, 3000, -8000, 8000}) {
    const auto turn = intaglio::number::Angle::from_steps(angle);
    const oracle::ThreeShear rule{columns,
                                  rows,
                                  256 * 9 + 512,
                                  256 * 8 + 256,
                                  512,
                                  256,
                                  0,
                                  intaglio::number::sine(turn).raw(),
                                  intaglio::number::cosine(turn).raw()};
    expect_indices("method shear\nsprite FILE 9 8 1 " + std::to_string(angle), [&](int x, int y) {
      for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
          const auto place = rule.land(column, row);
          if (place.x == x && place.y == y) return sprite_at(column, row);
        }
      return 0;
    });
  }
}

TEST_F(DrawSprite, TakesTheNearestColourOfThePalette) {
  // 17 to 255 in steps of 17 between black and 100: from 51 on, 100 is nearer.
  std::string palette = "palette 1 100 100 100\n";
  for (int i = 2; i < 16; ++i) palette += "palette " + std::to_string(i) + " 0 0 0\n";
  const auto expected = [](int x, int y) { return sprite_at(x, y) > 2 ? 1 : 0; };
  const auto canvas = draw_program("surface 24 19 4\n" + palette + "sprite " + (folder_ / "s.png") + " 0 0");
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      ASSERT_EQ(canvas->indices()[static_cast<std::size_t>(y * width + x)], expected(x, y)) << x << ' ' << y;
}

TEST_F(DrawSprite, IsExclusiveOredAndCutToPolygonsAsAllPrimitives) {
  const std::string twice = "mode xor\nsprite FILE 9 8 3 700\nsprite FILE 9 8 3 700";
  std::string commands = "surface 24 19 4\n" + twice;
  for (std::size_t at = 0; (at = commands.find("FILE")) != std::string::npos;)
    commands.replace(at, 4, folder_ / "s.png");
  EXPECT_EQ(draw_program(commands)->indices(), std::vector<std::uint8_t>(std::size_t{width} * height));
  const oracle::Contours triangle{{{0, 0}, {256 * 20, 256 * 3}, {256 * 4, 256 * 18}}};
  expect_indices("clippoly 0 0 20 3 4 18\nstretch FILE 0 0 24 19", [&](int x, int y) {
    if (!oracle::in_polygon(triangle, true, x, y)) return 0;
    return sprite_at(oracle::scaled_source(x, columns, width), oracle::scaled_source(y, rows, height));
  });
}

TEST_F(DrawSprite, MistakesAreNamed) {
  const auto message = [&](std::string commands) -> std::string {
    for (std::size_t at = 0; (at = commands.find("FILE")) != std::string::npos;)
      commands.replace(at, 4, folder_ / "s.png");
    try {
      (void)draw_program("surface 24 19 4\n" + commands);
    } catch (const host::Failure& failure) {
      return failure.what();
    }
    return "no error";
  };
  EXPECT_EQ(message("sprite /nowhere/s.png 1 1"),
            "line 2: sprite: /nowhere/s.png: No such file or directory");
  EXPECT_EQ(message("sprite FILE 1.5 1"), "line 2: sprite: x must be a whole number, not '1.5'");
  EXPECT_EQ(message("sprite FILE 1 1 2"), "line 2: sprite: angle is missing");
  EXPECT_EQ(message("sprite FILE 1 1 0 7"), "line 2: sprite: the scale must be 1/256 to 256");
  EXPECT_EQ(message("sprite FILE 1 1 257 7"), "line 2: sprite: the scale must be 1/256 to 256");
  EXPECT_EQ(message("sprite FILE 1048577 1"), "line 2: sprite: position out of domain");
  EXPECT_EQ(message("sprite FILE 1 -2147483647 1 1"), "line 2: sprite: position out of domain");
  EXPECT_EQ(message("method shear\nsprite FILE 1 1 2 7"),
            "line 3: sprite: by this method a sprite keeps its size: the scale must be 1");
  EXPECT_EQ(message("method box\nsprite FILE 1 1 2 7"),
            "line 3: sprite: no method 'box'; there are zoom shear bilinear");
  EXPECT_EQ(message("method shear\nsprite FILE 1 1"), "line 3: sprite: no method 'shear'; there is only one");
  EXPECT_EQ(message("stretch FILE 1 1 2"), "line 2: stretch: height is missing");
  EXPECT_EQ(message("stretch FILE 1 1 2097153 1"), "line 2: stretch: size out of domain");
}

}  // namespace
