// SPDX-License-Identifier: MIT
//
// Sprites whose pixels are mixed, and dithered ones, against exact oracles.
#include <host/draw/program.hpp>
#include <host/failure.hpp>
#include <host/png.hpp>
#include <tests/host/run_tool.hpp>
#include <tests/oracle/bilinear.hpp>
#include <tests/oracle/box.hpp>
#include <tests/oracle/dither.hpp>
#include <tests/oracle/integer.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/turned_value.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace {

using host::draw::draw_program;

constexpr int width = 24;
constexpr int height = 19;
constexpr int columns = 13;
constexpr int rows = 11;

// 2x2 pixels: grey 200 and what is transparent, white and black, along the diagonals. Made by python3's zlib
// and struct.
constexpr std::array<std::uint8_t, 76> half_hidden{
    0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48, 0x44, 0x52,
    0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x02, 0x08, 0x06, 0x00, 0x00, 0x00, 0x72, 0xB6, 0x0D,
    0x24, 0x00, 0x00, 0x00, 0x13, 0x49, 0x44, 0x41, 0x54, 0x78, 0xDA, 0x63, 0x38, 0x71, 0xE2, 0xC4,
    0x7F, 0x20, 0x60, 0x00, 0x03, 0x10, 0x07, 0x00, 0x5F, 0x67, 0x09, 0xAC, 0xD8, 0xE0, 0xBC, 0xC3,
    0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82};

class DrawMixedSprite : public testing::Test {
 protected:
  void SetUp() override {
    oracle::Random random(907);
    host::IndexedPicture picture{columns, rows, {}, {}};
    for (int i = 0; i < columns * rows; ++i)
      picture.indices.push_back(static_cast<std::uint8_t>(random.between(0, 1) == 0 ? random.bits() : 255));
    for (int i = 0; i < 256; ++i) picture.palette_rgb.insert(picture.palette_rgb.end(), 3, std::uint8_t(i));
    values_ = picture.indices;
    test_host::write(folder_ / "g.png", host::encode_png(picture));
    test_host::write(folder_ / "h.png",
                     {reinterpret_cast<const char*>(half_hidden.data()), half_hidden.size()});
    test_host::write(folder_ / "c.png",
                     host::encode_png({3, 1, {0, 1, 2}, {255, 0, 0, 0, 255, 0, 0, 0, 255}}));
  }
  [[nodiscard]] int value(int column, int row) const {
    return values_[static_cast<std::size_t>(row * columns + column)];
  }
  /// Draws on 24x19 pixels, with GREY, HALF and COLOURS for the pictures.
  [[nodiscard]] auto canvas(std::string commands, int bits = 8) const {
    for (const auto& [name, file] : {std::pair{"GREY", "g.png"}, {"HALF", "h.png"}, {"COLOURS", "c.png"}})
      for (std::size_t at = 0; (at = commands.find(name)) != std::string::npos;)
        commands.replace(at, std::string_view(name).size(), folder_ / file);
    return draw_program("surface 24 19 " + std::to_string(bits) + "\n" + commands + "\n");
  }
  [[nodiscard]] std::vector<int> draw(const std::string& commands, int bits = 8) const {
    const std::vector<std::uint8_t> indices = canvas(commands, bits)->indices();
    return {indices.begin(), indices.end()};
  }
  /// The greys of a copy at X Y, and black around.
  [[nodiscard]] oracle::DitherPicture copied(int left, int top) const {
    oracle::DitherPicture picture{width, std::vector<int>(std::size_t{width} * height)};
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (x >= left && x < left + columns && y >= top && y < top + rows)
          picture.pixels[picture.at(x, y)] = value(x - left, y - top);
    return picture;
  }
  [[nodiscard]] std::string mistake(const std::string& commands, int bits = 8) const {
    try {
      (void)canvas(commands, bits);
    } catch (const host::Failure& failure) {
      return failure.what();
    }
    return "no error";
  }
  test_host::Folder folder_;
  std::vector<std::uint8_t> values_;
};

/// What is visible of a rectangle, by exact(x, y), and index 0 around it.
template <class Exact>
std::vector<double> shown(int left, int top, int w, int h, Exact exact) {
  std::vector<double> all;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool inside = x >= left && x < left + w && y >= top && y < top + h;
      all.push_back(inside ? exact(x - left, y - top) : 0.0);
    }
  return all;
}

double furthest(const std::vector<int>& drawn, const std::vector<double>& exact) {
  double furthest = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) furthest = std::max(furthest, std::abs(drawn[i] - exact[i]));
  return furthest;
}

struct Area {
  int left, top, w, h;
  [[nodiscard]] std::string command(const std::string& method) const {
    return "method " + method + "\nstretch GREY " + std::to_string(left) + ' ' + std::to_string(top) + ' ' +
           std::to_string(w) + ' ' + std::to_string(h);
  }
};
constexpr std::array<Area, 5> areas{
    {{2, 1, 5, 4}, {0, 0, 1, 1}, {-3, -2, 40, 37}, {5, 3, 13, 11}, {20, 9, 9, 30}}};

TEST_F(DrawMixedSprite, StretchedByBoxShowsExactMeans) {
  for (const Area& a : areas) {
    const auto means = shown(a.left, a.top, a.w, a.h, [&](int x, int y) {
      const auto sum = oracle::box_sum(x, y, columns, rows, a.w, a.h,
                                       [&](int column, int row) { return value(column, row); });
      return static_cast<double>(oracle::nearest_quotient(sum, columns * rows));
    });
    EXPECT_EQ(furthest(draw(a.command("box")), means), 0) << a.w << 'x' << a.h;
  }
}

TEST_F(DrawMixedSprite, StretchedBilinearlyItIsWithinTheRungsBound) {
  for (const Area& a : areas) {
    const auto exact = shown(a.left, a.top, a.w, a.h, [&](int x, int y) {
      return oracle::bilinear(x, y, columns, rows, a.w, a.h,
                              [&](int column, int row) { return value(column, row); });
    });
    EXPECT_LE(furthest(draw(a.command("bilinear")), exact), 1.512) << a.w << 'x' << a.h;
  }
}

TEST_F(DrawMixedSprite, TurnedBilinearlyItIsWithinTheRungsBound) {
  for (const int angle : {0, 3000, -20000, 32768}) {
    const auto drawn = draw("method bilinear\nsprite GREY 5 4 1 " + std::to_string(angle));
    int compared = 0;
    double worst = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        double exact = 0;
        if (!oracle::turned_value(
                x, y, columns, rows, angle, (columns - 1) / 2.0, (rows - 1) / 2.0, 5 + (columns - 1) / 2.0,
                4 + (rows - 1) / 2.0, [&](int column, int row) { return value(column, row); }, exact))
          continue;
        ++compared;
        worst = std::max(worst, std::abs(drawn[static_cast<std::size_t>(y * width + x)] - exact));
      }
    EXPECT_GT(compared, 90) << angle;
    EXPECT_LE(worst, 5.1) << angle;
  }
}

TEST_F(DrawMixedSprite, WhatIsTransparentDoesntColourMixtures) {
  for (const std::string method : {"box", "bilinear"}) {
    const auto drawn = draw("method " + method + "\nstretch HALF 3 4 1 1");
    EXPECT_NEAR(drawn[4 * width + 3], 200, 1) << method;
  }
  const auto shrunk = canvas("method box\nstretch HALF 0 0 2 2\nmethod box\nstretch HALF 9 0 1 2");
  EXPECT_EQ(shrunk->touched()[0], 1);
  EXPECT_EQ(shrunk->indices()[0], 200);
  EXPECT_EQ(shrunk->touched()[1], 0);
  EXPECT_NEAR(shrunk->indices()[9], 200, 1);
  EXPECT_NEAR(shrunk->indices()[width + 9], 200, 1);
}

TEST_F(DrawMixedSprite, IsDitheredByPlaceOnTheSurface) {
  const auto sprite = [](const std::string& dither) { return "dither " + dither + "\nsprite GREY 6 5"; };
  const oracle::DitherPicture greys = copied(6, 5);
  EXPECT_EQ(draw(sprite("none 4")), oracle::ordered(greys, 4, 1).pixels);
  // Black gets the lowest level wherever it is.
  EXPECT_EQ(draw(sprite("bayer2 3")), oracle::ordered(greys, 3, 2).pixels);
  EXPECT_EQ(draw(sprite("bayer4 2")), oracle::ordered(greys, 2, 4).pixels);
  EXPECT_EQ(draw(sprite("bayer8"), 4), oracle::ordered(greys, 16, 8).pixels);
  EXPECT_EQ(draw(sprite("bayer8"), 1), oracle::ordered(greys, 2, 8).pixels);
}

TEST_F(DrawMixedSprite, IsDitheredByErrorsHandedOn) {
  const oracle::DitherPicture greys = copied(6, 5);
  const auto expect_shown = [&](const std::string& method, const int(&shares)[4], bool serpentine) {
    oracle::DitherPicture expected = oracle::diffused(greys, 3, shares, serpentine);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (x < 6 || x >= 6 + columns || y < 5 || y >= 5 + rows) expected.pixels[expected.at(x, y)] = 0;
    EXPECT_EQ(draw("dither " + method + " 3\nsprite GREY 6 5", 2), expected.pixels) << method;
  };
  expect_shown("threetap", {6, 0, 6, 4}, false);
  expect_shown("fourtap", {7, 3, 5, 1}, false);
  expect_shown("serpentine", {7, 3, 5, 1}, true);
}

TEST_F(DrawMixedSprite, DitheredColoursAreGreysAndOffIsThePaletteAgain) {
  const auto greys = draw("dither none\nsprite COLOURS 0 0\ndither off\nsprite COLOURS 0 1");
  EXPECT_EQ(greys[0], 54);
  EXPECT_EQ(greys[1], 182);
  EXPECT_EQ(greys[2], 19);
  EXPECT_EQ(greys[width], 85);
  const auto hidden = canvas("dither fourtap 2\nsprite HALF 0 0");
  EXPECT_EQ(hidden->touched()[0], 1);
  EXPECT_EQ(hidden->touched()[1], 0);
}

TEST_F(DrawMixedSprite, MistakesAreNamed) {
  EXPECT_EQ(mistake("method shear\nstretch GREY 1 1 2 7"),
            "line 3: stretch: no method 'shear'; there are nearest bilinear box");
  EXPECT_EQ(mistake("method bilinear\nsprite GREY 1 1 2 7"),
            "line 3: sprite: by this method a sprite keeps its size: the scale must be 1");
  EXPECT_EQ(mistake("method box\nstretch GREY 1 1 32769 7"), "line 3: stretch: size too large (limit 32768)");
  EXPECT_EQ(mistake("dither"), "line 2: dither: method is missing");
  EXPECT_EQ(mistake("dither bayer16"),
            "line 2: dither: the method must be none, bayer2, bayer4, bayer8, threetap, fourtap or "
            "serpentine, not 'bayer16'");
  EXPECT_EQ(mistake("dither bayer8 1"), "line 2: dither: levels must be 2 to 256, not 1");
  EXPECT_EQ(mistake("dither bayer8 5", 2), "line 2: dither: levels must be 2 to 4, not 5");
  EXPECT_EQ(mistake("dither off 2"), "line 2: dither: '2' is one argument too many");
}

}  // namespace
