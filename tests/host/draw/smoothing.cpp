// SPDX-License-Identifier: MIT
//
// `aa` of the drawing language: every way against the exact area, on every depth.
#include <host/draw/program.hpp>
#include <host/failure.hpp>
#include <tests/oracle/coverage.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace {

using host::draw::Canvas;
using host::draw::draw_program;

constexpr int width = 40;
constexpr int height = 30;

std::shared_ptr<const Canvas> draw(const std::string& commands, int bits = 8) {
  return draw_program("surface 40 30 " + std::to_string(bits) + "\n" + commands + "\n");
}

struct Way {
  std::string name;
  double bound;  // in levels, of what edges are off by
};

/// Every name, with the bounds of the library's documentation.
std::vector<Way> ways() {
  std::vector<Way> all{{"area", 0.51},      {"pitteway", 32.4},  {"abuffer4x4", 32.4}, {"abuffer4x8", 32.4},
                       {"abuffer", 32.4},   {"adaptive", 32.4},  {"stochastic", 92.3}, {"box", 32.4},
                       {"bartlett3", 64.3}, {"bartlett5", 43.1}, {"bartlett7", 53.8}};
  for (int scale = 2; scale <= 8; ++scale) {
    const double box = 127.5 / scale + 0.5;
    all.push_back({"box" + std::to_string(scale), box});
    all.push_back({"adaptive" + std::to_string(scale), box});
    all.push_back({"stochastic" + std::to_string(scale), 255 * 1.44 / scale + 0.5});
  }
  for (const char* grid :
       {"2x4", "2x6", "2x8", "3x3", "3x5", "3x7", "4x4", "4x6", "4x8", "5x5", "5x7", "7x7"})
    all.push_back({std::string("bartlett") + grid, 78.3});
  return all;
}

TEST(DrawSmooth, EveryWayKeepsItsBoundAtAnEdge) {
  // A band across the picture; the edges don't meet in it.
  const oracle::Contours band{{{-2560, 1280}, {12800, 5888}, {12800, 6784}, {-2560, 4352}}};
  const std::string commands = "\npolygon evenodd -10 5 50 23 50 26.5 -10 17";
  std::vector<double> exact;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      exact.push_back(mpq_class(255 * oracle::coverage(band, true, x, y)).get_d());
  for (const Way& way : ways()) {
    const auto canvas = draw("aa " + way.name + commands);
    double worst = 0;
    bool full = false;
    for (std::size_t i = 0; const std::uint8_t index : canvas->indices()) {
      worst = std::max(worst, std::abs(exact[i] - index));
      full |= index == 255;
      EXPECT_LE(canvas->touched()[i++], 1) << way.name;
    }
    EXPECT_LE(worst, way.bound) << way.name;
    EXPECT_TRUE(full) << way.name;
  }
}

TEST(DrawSmooth, AreaOfWhiteOnBlackIsWhatCoverageWrites) {
  const std::string vertices = " 1.5 1.25 35 5 18.75 28 / 12 8 24 20.5 25 9";
  EXPECT_EQ(draw("aa area\npolygon evenodd" + vertices)->indices(), draw("coverage" + vertices)->indices());
  EXPECT_EQ(draw("aa area\npolygon evenodd" + vertices + "\naa off")->touched(),
            draw("coverage" + vertices)->touched());
}

TEST(DrawSmooth, LinesAreOnePixelWide) {
  // From the middle of column 4 to that of column 20, half in row 6 and half in row 7.
  const auto indices = draw("aa area\nline 4 6.5 20 6.5")->indices();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int expected = (y == 6 || y == 7) && x >= 4 && x <= 20 ? (x == 4 || x == 20 ? 64 : 128) : 0;
      EXPECT_EQ(indices[static_cast<std::size_t>(y * width + x)], expected) << x << "," << y;
    }
}

TEST(DrawSmooth, RoundShapesAreSymmetricAndHaveTheirArea) {
  const double pi = 3.14159265;
  struct Shape {
    std::string command;
    double area;
    double around;  // how long its edge is
  };
  const std::vector<Shape> shapes{{"disc 19 14 12", pi * 12.5 * 12.5, 2 * pi * 12.5},
                                  {"evendisc 7 2 25", pi * 12.5 * 12.5, 2 * pi * 12.5},
                                  {"circle 19 14 12", pi * (12.5 * 12.5 - 11.5 * 11.5), 4 * pi * 12},
                                  {"ring 19 14 5 12", pi * (12.5 * 12.5 - 5.5 * 5.5), 2 * pi * 18},
                                  {"fillellipse 19 14 15 9", pi * 15.5 * 9.5, 2 * pi * 13},
                                  {"ellipse 19 14 15 9", pi * (15.5 * 9.5 - 14.5 * 8.5), 4 * pi * 13},
                                  {"roundrect 4 3 31 23 0", 31 * 23 - 29 * 21, 0},
                                  {"fillroundrect 4 3 31 23 6", 31 * 23 - (4 - pi) * 6.5 * 6.5, 2 * pi * 6.5},
                                  {"pie 19 14 12 0 70000", pi * 12.5 * 12.5, 2 * pi * 12.5},
                                  {"thickline 9 14 29 14 11 round", 20 * 11 + pi * 5.5 * 5.5, 2 * pi * 5.5},
                                  {"thickline 19 14 19 14 25 round", pi * 12.5 * 12.5, 2 * pi * 12.5},
                                  {"fillroundrect 4 3 31 23 0", 31 * 23, 0}};
  for (const char* name : {"area", "box3", "box4", "box7", "box8", "bartlett3x5", "adaptive8", "stochastic8"})
    for (const Shape& shape : shapes) {
      // Rows of samples are mirrored exactly; corners of polygons are rounded, and jitter isn't mirrored at
      // all.
      const std::string_view way = name;
      const bool rows = way.starts_with("b") && !shape.command.starts_with("pie");
      const int most = rows ? 0 : way == "stochastic8" ? 60 : 8;
      const auto indices = draw(std::string("aa ") + name + "\n" + shape.command)->indices();
      double sum = 0;
      int wrong = 0;
      const auto at = [&](int x, int y) { return indices[static_cast<std::size_t>(y * width + x)]; };
      for (int y = 0; y < 29; ++y)
        for (int x = 0; x < 39; ++x) {
          sum += at(x, y);
          wrong +=
              std::max(std::abs(at(x, y) - at(38 - x, y)), std::abs(at(x, y) - at(x, 28 - y))) > most ? 1 : 0;
        }
      EXPECT_EQ(wrong, 0) << name << " " << shape.command;
      // 1/256 pixel around and roundings, or half a sample, which is a sixth of a pixel at most.
      const double slack = way == "area" ? shape.around / 256 + 0.2 : shape.around / 6 + 1;
      EXPECT_NEAR(sum / 255, shape.area, slack) << name << " " << shape.command;
    }
}

TEST(DrawSmooth, PartsOfCurvesHaveTheirAreaAndMakeTheWhole) {
  const double pi = 3.14159265;
  const auto area_of = [](const std::string& command) {
    double sum = 0;
    for (const std::uint8_t index : draw("aa area\n" + command)->indices()) sum += index;
    return sum / 255;
  };
  EXPECT_NEAR(area_of("pie 19 14 12 0 16384"), pi * 12.5 * 12.5 / 4, 0.3);
  EXPECT_NEAR(area_of("pie 19 14 12 30000 -50000"), pi * 12.5 * 12.5 * 50000 / 65536, 0.3);
  EXPECT_NEAR(area_of("chord 19 14 12 0 16384"), (pi / 4 - 0.5) * 12.5 * 12.5, 0.3);
  EXPECT_NEAR(area_of("arc 19 14 12 5000 16384"), pi * (12.5 * 12.5 - 11.5 * 11.5) / 4, 0.3);
  // As seen from the centre: the diagonal halves nothing of a flat ellipse but its quarter's directions.
  const double eighth = std::atan2(15.5, 9.5) / 2 * 15.5 * 9.5;
  EXPECT_NEAR(area_of("ellipsepie 19 14 15 9 0 8192"), eighth, 0.3);
  EXPECT_NEAR(area_of("ellipsepie 19 14 15 9 8192 8192"), pi / 4 * 15.5 * 9.5 - eighth, 0.3);
  EXPECT_EQ(area_of("pie 19 14 12 7 0"), 0);
  EXPECT_EQ(area_of("arc 19 14 0 7 70000"), area_of("disc 19 14 0"));
  for (const char* name : {"area", "box4", "box5"}) {
    const std::string aa = std::string("aa ") + name + "\n";
    const auto whole = draw(aa + "disc 19 14 12")->indices();
    const auto half = draw(aa + "pie 19 14 12 10000 32768")->indices();
    const auto other = draw(aa + "pie 19 14 12 42768 32768")->indices();
    int most = 0;
    for (std::size_t i = 0; i < whole.size(); ++i)
      most = std::max(most, std::abs(whole[i] - half[i] - other[i]));
    EXPECT_LE(most, std::string_view(name) == "area" ? 3 : 26) << name;
  }
}

TEST(DrawSmooth, CurvesFarLargerThanThePictureAreDrawnSoonAndRightly) {
  // The curve goes up left of column 19, nearly straight.
  for (const char* name : {"area", "abuffer", "adaptive8", "stochastic8"}) {
    const auto indices = draw(std::string("aa ") + name + "\npie 60019 15 60000 10000 45000")->indices();
    for (int y = 0; y < height; ++y) {
      double sum = 0;
      for (int x = 0; x < width; ++x) sum += indices[static_cast<std::size_t>(y * width + x)];
      EXPECT_NEAR(sum / 255, 21, 0.2) << name << " " << y;
    }
  }
}

TEST(DrawSmooth, WhatLiesAlongRowsAndColumnsStaysAsItIs) {
  for (const char* command :
       {"pixel 3 4", "rect 3 4 9 8", "fillrect 3 4 9 8", "text 2 3 \"Ab\"", "flood 4 3 3"})
    EXPECT_EQ(draw(std::string("aa box4\ncolor 77\n") + command)->indices(),
              draw(std::string("color 77\n") + command)->indices())
        << command;
}

TEST(DrawSmooth, ColoursAreMixedWithWhatIsThereByCodeOrAsLight) {
  // Half of a pixel of white over black and over index 100.
  const std::string commands = "color 100\nfillrect 0 3 40 1\ncolor 255\naa ";
  const std::string polygon = "\npolygon evenodd -0.5 -0.5 9 -0.5 9 3.5 -0.5 3.5";
  const auto codes = draw(commands + "area" + polygon)->indices();
  EXPECT_EQ(codes[9], 128);
  EXPECT_EQ(codes[3 * width + 9], 178);
  EXPECT_EQ(codes[8], 255);
  const auto light = draw(commands + "area light" + polygon)->indices();
  EXPECT_EQ(light[9], 188);
  // Codes 100 and 255 are 0.1274 and 1 of the light; halfway lies 0.5637, code 198.
  EXPECT_EQ(light[3 * width + 9], 198);
  // The nearest of four colours to the grey between black and white.
  const auto few = draw("palette 1 255 0 0\npalette 2 128 90 140\naa area" + polygon, 2)->indices();
  EXPECT_EQ(few[8], 3);
  EXPECT_EQ(few[9], 2);
}

TEST(DrawSmooth, OneBitIsDitheredAndExclusiveOrTwiceRestores) {
  const std::string shapes = "aa area\ntriangle 1 2 38 9 7 28\naa box5\ndisc 25 18 9\n";
  const auto once = draw(shapes, 1)->indices();
  const auto twice = draw("mode xor\n" + shapes + shapes, 1);
  EXPECT_EQ(twice->indices(), std::vector<std::uint8_t>(std::size_t{width} * height));
  EXPECT_GT(std::count(once.begin(), once.end(), 1), 500);
  // A level of a half is every second pixel.
  const auto half =
      draw("aa area\npolygon evenodd -1 -1 41 -1 41 31 -1 31 / -1 3 41 3 41 31 -1 31", 1)->indices();
  int on = 0;
  for (int x = 0; x < width; ++x) on += half[static_cast<std::size_t>(3 * width + x)];
  EXPECT_EQ(on, width / 2);
}

TEST(DrawSmooth, ClipsCutAndNothingElseChanges) {
  const std::string shape = "\ntriangle 1 2 38 9 7 28";
  for (const char* name : {"area", "pitteway", "box4", "bartlett7", "adaptive", "stochastic", "abuffer"}) {
    std::string aa = std::string("\naa ") + name;
    const auto whole = draw(aa + shape)->indices();
    const auto cut = draw("clip 5 6 20 9\nclippoly 0 0 39 0 0 29" + aa.append(shape))->indices();
    const auto window = draw("clip 5 6 20 9\nclippoly 0 0 39 0 0 29\nfillrect 0 0 40 30")->indices();
    for (std::size_t i = 0; i < whole.size(); ++i)
      ASSERT_EQ(cut[i], window[i] != 0 ? whole[i] : 0) << name << " " << i;
  }
}

TEST(DrawSmooth, SaysWhatItCannotDo) {
  struct Mistake {
    const char* commands;
    const char* message;
  };
  for (const Mistake& mistake : {
           Mistake{"aa", "line 2: aa: method is missing"},
           Mistake{"aa area dark", "line 2: aa: 'dark' is one argument too many"},
           Mistake{"aa area\ndash 3 3 5 5 9 9", "line 3: dash: aa area doesn't draw this; box4 may"},
           Mistake{"aa area\ndisc 5 5 -3", "line 3: disc: radius out of domain"},
           Mistake{"aa area\nring 5 5 3 2", "line 3: ring: radius mismatched"},
           Mistake{"aa area\nellipsepie 5 5 3 -2 1 1", "line 3: ellipsepie: radius out of domain"},
           Mistake{"aa area\nroundrect 5 5 3 -2 -1", "line 3: roundrect: radius out of domain"},
           Mistake{"aa area\nthickline 0 0 9 9 -3 round", "line 3: thickline: width out of domain"},
           Mistake{"aa pitteway\npolygon evenodd 0 0 9 0 9 9 / 1 1 2 2 3 3",
                   "line 3: polygon: aa pitteway draws convex polygons only"},
           Mistake{"aa pitteway\npolygon evenodd 0 0 9 0 2 2 0 9", "line 3: polygon: vertices malformed"},
           Mistake{"aa box8\ndisc 9 9 900000", "line 3: disc: radius out of domain"},
           Mistake{"aa box8\nroundrect 9 9 900000 9 1", "line 3: roundrect: rectangle out of domain"},
           Mistake{"aa box4\ndash 1 1 0 0 9 9", "line 3: dash: aa box4 doesn't draw this"},
           Mistake{"aa box8\ntriangle 0 0 200000 0 0 9", "line 3: triangle: point out of domain"},
           Mistake{"aa adaptive8\ntriangle 0 0 200000 0 0 9", "line 3: triangle: vertices out of domain"},
           Mistake{"aa abuffer\ntriangle 0 0 300000 0 0 9", "line 3: triangle: vertices out of domain"},
           Mistake{"aa box3\ndisc 5 5 -1", "line 3: disc: radius out of domain"},
           Mistake{"aa box3\nfillellipse 5 5 -1 4", "line 3: fillellipse: radius out of domain"},
           Mistake{"aa box3\nring 5 5 4 3", "line 3: ring: radius mismatched"},
           Mistake{"aa box3\npie 5 5 -4 3 3", "line 3: pie: radius out of domain"},
           Mistake{"aa box3\nmode xor\ndisc 5 5 1", "line 4: disc: aa needs mode set, or 1 bit a pixel"},
       })
    try {
      (void)draw(mistake.commands);
      ADD_FAILURE() << "no error: " << mistake.commands;
    } catch (const host::Failure& failure) {
      EXPECT_STREQ(failure.what(), mistake.message) << mistake.commands;
    }
  try {
    (void)draw("aa fancy");
    ADD_FAILURE();
  } catch (const host::Failure& failure) {
    EXPECT_TRUE(std::string(failure.what()).starts_with("line 2: aa: no method 'fancy'; there are off area"));
  }
}

}  // namespace
