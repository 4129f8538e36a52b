// SPDX-License-Identifier: MIT
//
// Every command of the drawing language against an oracle or a picture that can be read, and every message.
#include <host/draw/program.hpp>
#include <host/failure.hpp>
#include <tests/oracle/circle.hpp>
#include <tests/oracle/coverage.hpp>
#include <tests/oracle/flood.hpp>
#include <tests/oracle/line.hpp>
#include <tests/oracle/oval.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/sector.hpp>
#include <tests/oracle/stroke.hpp>
#include <tests/oracle/text.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <intaglio_fonts/fixed_6x13.hpp>
#include <intaglio_fonts/sans_11.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

using host::draw::Canvas;
using host::draw::draw_program;

constexpr int width = 50;
constexpr int height = 40;

/// Draws on 50x40 pixels of 4 bits with index 15, after `before`.
std::shared_ptr<const Canvas> draw(const std::string& commands) {
  return draw_program("surface 50 40 4\n" + commands + "\n");
}

/// Exactly the pixels of the predicate have index 15 and were written once; the others weren't written.
void expect_pixels(const std::string& commands, const std::function<bool(int, int)>& inside) {
  const auto canvas = draw(commands);
  std::vector<std::uint8_t> indices;
  std::vector<std::uint8_t> touched;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      indices.push_back(inside(x, y) ? 15 : 0);
      touched.push_back(inside(x, y) ? 1 : 0);
    }
  EXPECT_EQ(canvas->indices(), indices) << commands;
  EXPECT_EQ(canvas->touched(), touched) << commands;
}

TEST(Draw, Pixel) {
  expect_pixels("pixel 3 4", [](int x, int y) { return x == 3 && y == 4; });
  expect_pixels("pixel 50 4\npixel -1 0\npixel 1048576 -1048576", [](int, int) { return false; });
}

TEST(Draw, Line) {
  expect_pixels("line 2 3 45 17", [](int x, int y) { return oracle::on_line(2, 3, 45, 17, x, y); });
  expect_pixels("line 30000 20000 -1000 -900",
                [](int x, int y) { return oracle::on_line(30000, 20000, -1000, -900, x, y); });
  expect_pixels("line 2.25 3 45 17.5",
                [](int x, int y) { return oracle::on_sub_line(576, 768, 11520, 4480, x, y); });
}

TEST(Draw, LineMethods) {
  for (const std::string method : {"exact", "line1", "line2", "distance"})
    expect_pixels("method " + method + "\nline 2 3 45 17",
                  [](int x, int y) { return oracle::on_line(2, 3, 45, 17, x, y); });
  // After a hundred thousand pixels a slope of 16 fraction bits shows.
  const std::string line = "line -99960 36773 40 10";
  EXPECT_EQ(draw("method line2\n" + line)->indices(), draw(line)->indices());
  EXPECT_NE(draw("method line1\n" + line)->indices(), draw(line)->indices());
}

TEST(Draw, Dash) {
  expect_pixels("dash 3 2 45 17 2 3", [](int x, int y) { return oracle::on_dash(45, 17, 2, 3, 3, 2, x, y); });
  expect_pixels("dash 7 4 1000000 -900000 -1000000 900001",
                [](int x, int y) { return oracle::on_dash(1000000, -900000, -1000000, 900001, 7, 4, x, y); });
}

TEST(Draw, ThickLine) {
  expect_pixels("thickline 5 10 30 10 4", [](int x, int y) { return x >= 5 && x < 30 && y >= 8 && y < 12; });
  expect_pixels("thickline 10.5 30 10.5 9 5 square",
                [](int x, int y) { return x >= 8 && x < 13 && y >= 7 && y < 33; });
  expect_pixels("thickline 20 20 20 20 11.5 round",
                [](int x, int y) { return 4 * ((x - 20) * (x - 20) + (y - 20) * (y - 20)) < 132; });
  // Half the width of 25 across (18,24) is (10,-7.5).
  expect_pixels("thickline 7 8 25 32 25 butt", [](int x, int y) {
    const oracle::Contours contours{
        {{-3 * 256, 31 * 128}, {15 * 256, 79 * 128}, {35 * 256, 49 * 128}, {17 * 256, 128}}};
    return oracle::in_polygon(contours, false, x, y);
  });
}

TEST(Draw, ThickLineAlongTheMinorAxis) {
  expect_pixels("method minor\nthickline 5 30 40.5 3 4", [](int x, int y) {
    const auto on = [&](int row) { return oracle::on_sub_line(1280, 7680, 10368, 768, x, row); };
    return on(y - 1) || on(y) || on(y + 1) || on(y + 2);
  });
}

TEST(Draw, Polyline) {
  using intaglio::raster::Cap;
  using intaglio::raster::Join;
  const std::string points = " 5 5 40.5 9 12 20 12 20 30 30";
  const oracle::Contour contour{{1280, 1280}, {10368, 2304}, {3072, 5120}, {7680, 7680}};
  const auto expect = [&](const std::string& words, const intaglio::raster::Stroke& stroke) {
    const oracle::StrokeArea area(contour, stroke);
    expect_pixels("polyline 4.5 " + words + points, [&](int x, int y) { return area.holds(x, y); });
  };
  constexpr int wide = 1152;
  expect("miter", {.width = wide});
  expect("bevel square", {.width = wide, .join = Join::bevel, .cap = Cap::square});
  expect("round round", {.width = wide, .join = Join::round, .cap = Cap::round});
  expect("miter closed limit 7.5", {.width = wide, .closed = true, .miter_limit = 1920});
  expect("miter round limit 1", {.width = wide, .cap = Cap::round, .miter_limit = 256});
}

TEST(Draw, Rectangles) {
  const auto in = [](int x, int y) { return x >= 5 && x < 12 && y >= 6 && y < 10; };
  expect_pixels("fillrect 5 6 7 4", in);
  expect_pixels("rect 5 6 7 4",
                [&](int x, int y) { return in(x, y) && (x == 5 || x == 11 || y == 6 || y == 9); });
  expect_pixels("fillrect -1000 -1000 2000 1010", [](int, int y) { return y < 10; });
  expect_pixels("fillrect 5 6 0 4\nrect 5 6 7 -4", [](int, int) { return false; });
}

TEST(Draw, CircleAndDisc) {
  expect_pixels("circle 20 18 13", [](int x, int y) { return oracle::on_circle(13, x - 20, y - 18); });
  expect_pixels("disc 20 18 25",
                [](int x, int y) { return std::abs(x - 20) <= oracle::outline_reach(25, y - 18); });
  expect_pixels("disc 7 9 0", [](int x, int y) { return x == 7 && y == 9; });
}

TEST(Draw, CirclesByDiameter) {
  expect_pixels("evencircle 3 4 14",
                [](int x, int y) { return oracle::on_oval(13, 13, 2 * (x - 3) - 13, 2 * (y - 4) - 13); });
  expect_pixels("evendisc -3 -4 22",
                [](int x, int y) { return oracle::in_oval(21, 21, 2 * (x + 3) - 21, 2 * (y + 4) - 21); });
  expect_pixels("evendisc 7 9 27",
                [](int x, int y) { return std::abs(x - 20) <= oracle::outline_reach(13, y - 22); });
}

TEST(Draw, Ellipses) {
  expect_pixels("ellipse 20 18 17 9",
                [](int x, int y) { return oracle::on_oval(34, 18, 2 * (x - 20), 2 * (y - 18)); });
  expect_pixels("fillellipse 20 18 9 1000",
                [](int x, int y) { return oracle::in_oval(18, 2000, 2 * (x - 20), 2 * (y - 18)); });
}

TEST(Draw, Ring) {
  expect_pixels("ring 20 18 7 13", [](int x, int y) {
    const int distance = std::abs(x - 20);
    return distance <= oracle::outline_reach(13, y - 18) && distance > oracle::outline_reach(7, y - 18);
  });
}

TEST(Draw, ArcAndPie) {
  expect_pixels("arc 20 18 13 60000 20000", [](int x, int y) {
    return oracle::on_circle(13, x - 20, y - 18) && oracle::in_sweep(x - 20, y - 18, 60000, 20000);
  });
  expect_pixels("pie 20 18 13 -70000 -30000", [](int x, int y) {
    return std::abs(x - 20) <= oracle::outline_reach(13, y - 18) &&
           oracle::in_sweep(x - 20, y - 18, 61072, -30000);
  });
  expect_pixels(
      "arc 20 18 13 0 16384\narc 20 18 13 16384 16384\narc 20 18 13 32768 16384\narc 20 18 13 0 -16384",
      [](int x, int y) { return oracle::on_circle(13, x - 20, y - 18); });
}

TEST(Draw, Chord) {
  expect_pixels("chord 20 18 13 0 16384", [](int x, int y) {
    return std::abs(x - 20) <= oracle::outline_reach(13, y - 18) && x - 20 + y - 18 >= 13;
  });
}

TEST(Draw, PartsOfEllipses) {
  const auto in = [](int x, int y) { return oracle::in_oval(34, 18, 2 * (x - 20), 2 * (y - 18)); };
  expect_pixels("ellipsearc 20 18 17 9 60000 20000", [](int x, int y) {
    return oracle::on_oval(34, 18, 2 * (x - 20), 2 * (y - 18)) &&
           oracle::in_sweep(x - 20, y - 18, 60000, 20000);
  });
  expect_pixels("ellipsepie 20 18 17 9 5000 -30000",
                [&](int x, int y) { return in(x, y) && oracle::in_sweep(x - 20, y - 18, 5000, -30000); });
  // From the right end to the lower one: what is not on the centre's side of the line between them.
  expect_pixels("ellipsechord 20 18 17 9 0 16384",
                [&](int x, int y) { return in(x, y) && (x - 20) * 9 + (y - 18) * 17 >= 17 * 9; });
}

TEST(Draw, RoundRectangles) {
  // A side of 13 leaves room for a radius of 6: two half discs with a rectangle between them.
  const auto in = [](int x, int y) {
    const int dx = x < 11 ? 11 - x : x > 20 ? x - 20 : 0;
    return dx <= oracle::outline_reach(6, y - 12);
  };
  expect_pixels("fillroundrect 5 6 22 13 99", in);
  expect_pixels("roundrect 5 6 22 13 6", [&](int x, int y) {
    return in(x, y) && !(in(x - 1, y) && in(x + 1, y) && in(x, y - 1) && in(x, y + 1));
  });
  expect_pixels("fillroundrect 5 6 22 13 0 2 0 0",
                [](int x, int y) { return x >= 5 && x < 27 && y >= 6 && y < 19 && !(y == 6 && x == 26); });
}

TEST(Draw, TriangleTakesDecimals) {
  expect_pixels("triangle 1.5 2.25 40 5 -3.00390625 38.75", [](int x, int y) {
    return oracle::in_triangle({384, 576}, {10240, 1280}, {-769, 9920}, x, y);
  });
}

TEST(Draw, TriangleTakesFractions) {
  expect_pixels("triangle 7/3 9/4 40 5 -769/256 155/4", [](int x, int y) {
    return oracle::in_triangle({597, 576}, {10240, 1280}, {-769, 9920}, x, y);
  });
}

TEST(Draw, BooleanDrawsTheExactPixelsAndPrintsTheExactResult) {
  const oracle::Contours a{{{256, 256}, {10240, 1280}, {5120, 9216}}};
  const oracle::Contours b{{{5120, 256}, {7936, 9216}, {512, 3584}, {9984, 3584}, {2304, 9216}}};
  const std::string operands = " 1 1 40 5 20 36 / 20 1 31 36 2 14 39 14 9 36";
  const auto expect = [&](const std::string& operation, const std::function<bool(bool, bool)>& taken) {
    expect_pixels("boolean " + operation + operands, [&](int x, int y) {
      return taken(oracle::in_polygon(a, true, x, y), oracle::in_polygon(b, true, x, y));
    });
  };
  expect("intersection", [](bool in_a, bool in_b) { return in_a && in_b; });
  expect("union", [](bool in_a, bool in_b) { return in_a || in_b; });
  expect("a-b", [](bool in_a, bool in_b) { return in_a && !in_b; });
  expect("b-a", [](bool in_a, bool in_b) { return in_b && !in_a; });
}

TEST(Draw, BooleanPrintsFractionsInLowestTerms) {
  EXPECT_EQ(draw("boolean intersection 0 0 4 0 4 4 0 4 / 1 1 7 3 1 3")->printed(),
            "contour 1 3 4 3 4 2 1 1\narea 9/2\n");
  EXPECT_EQ(draw("boolean intersection 0 0 3 0 0 1.5 / 0 0 2 4 0 4")->printed(),
            "contour 0 3/2 3/5 6/5 0 0\narea 9/20\n");
  EXPECT_EQ(
      draw("boolean a-b 0 0 4 0 4 4 / 0 0 4 0 4 4\nboolean union 0 0 2 0 2 2 0 2 / 0 0 2 0 2 2")->printed(),
      "area 0/1\ncontour 0 2 2 2 2 0 0 0\narea 4/1\n");
}

TEST(Draw, PolygonByBothRulesAndWithContours) {
  const oracle::Contours star{{{5120, 256}, {7936, 9216}, {512, 3584}, {9984, 3584}, {2304, 9216}}};
  const std::string vertices = "20 1 31 36 2 14 39 14 9 36";
  expect_pixels("polygon evenodd " + vertices,
                [&](int x, int y) { return oracle::in_polygon(star, true, x, y); });
  expect_pixels("polygon nonzero " + vertices,
                [&](int x, int y) { return oracle::in_polygon(star, false, x, y); });
  const oracle::Contours holed{{{0, 0}, {12800, 0}, {12800, 10240}, {0, 10240}},
                               {{2560, 2560}, {2560, 7680}, {7808, 5120}}};
  expect_pixels("polygon evenodd 0 0 50 0 50 40 0 40 / 10 10 10 30 30.5 20",
                [&](int x, int y) { return oracle::in_polygon(holed, true, x, y); });
}

TEST(Draw, CoverageWritesTheAreaAsIndex) {
  const std::string commands = "clip 2 2 40 30\ncoverage 1.5 1.25 40 5 20.75 38 / 12 8 24 20.5 25 9\n";
  const oracle::Contours contours{{{384, 320}, {10240, 1280}, {5312, 9728}},
                                  {{3072, 2048}, {6144, 5248}, {6400, 2304}}};
  const auto canvas = draw_program("surface 50 40 8\n" + commands);
  for (std::size_t i = 0; const std::uint8_t index : canvas->indices()) {
    const int x = static_cast<int>(i) % width;
    const int y = static_cast<int>(i) / width;
    const bool visible = x >= 2 && x < 42 && y >= 2 && y < 32;
    const mpq_class exact = visible ? mpq_class(255 * oracle::coverage(contours, true, x, y)) : mpq_class(0);
    EXPECT_LE(abs(exact - index), mpq_class(1, 2) + mpq_class(6, 1 << 15)) << x << "," << y;
    EXPECT_EQ(canvas->touched()[i++], index == 0 ? 0 : 1) << x << "," << y;
  }
  const auto twice = draw_program("surface 50 40 8\nmode xor\n" + commands + commands);
  EXPECT_EQ(twice->indices(), std::vector<std::uint8_t>(std::size_t{width} * height));
}

TEST(Draw, MethodsOfTheNextPrimitiveGiveTheSamePixels) {
  for (const char* method : {"walk", "box", "blocks"})
    expect_pixels(std::string("method ") + method + "\ntriangle 1.5 2.25 40 5 -3 38.75", [](int x, int y) {
      return oracle::in_triangle({384, 576}, {10240, 1280}, {-768, 9920}, x, y);
    });
  const oracle::Contours star{{{5120, 256}, {7936, 9216}, {512, 3584}, {9984, 3584}, {2304, 9216}}};
  for (const char* method : {"active", "basic", "critical"})
    for (const bool even_odd : {true, false})
      expect_pixels(std::string("method ") + method + "\npolygon " + (even_odd ? "evenodd" : "nonzero") +
                        " 20 1 31 36 2 14 39 14 9 36",
                    [&](int x, int y) { return oracle::in_polygon(star, even_odd, x, y); });
  // The one after the next takes its default again.
  EXPECT_NO_THROW(draw("method box\ntriangle 0 0 9 0 0 9\npolygon evenodd 0 0 9 0 0 9"));
}

TEST(Draw, FloodFillsTheRegionOfTheSeedsIndexInsideTheClip) {
  const std::string walls = "rect 3 2 30 20\nline 3 21 32 2\ncolor 6\n";
  const auto walled = draw(walls)->indices();
  for (const bool eight : {false, true})
    for (const char* mode : {"set", "xor"}) {
      const auto canvas = draw(walls + "clip 5 0 40 40\nmode " + mode + "\nflood " + (eight ? "8" : "4") +
                               " 10 6\nflood 4 4 30\nflood 8 -1 1000");
      const auto inside = oracle::region(width, height, {5, 0, 40, 40}, eight, 10, 6, [&](int x, int y) {
        return walled[static_cast<std::size_t>(y * width + x)] == 0;
      });
      EXPECT_EQ(inside[12 * width + 30] != 0, eight);  // through the line
      for (std::size_t i = 0; i < inside.size(); ++i) {
        ASSERT_EQ(canvas->indices()[i], inside[i] != 0 ? 6 : walled[i]);
        ASSERT_TRUE(inside[i] == 0 || canvas->touched()[i] == 1);
      }
    }
  expect_pixels("flood 4 20 20\nflood 4 20 20\nflood 8 2 3", [](int, int) { return true; });
}

TEST(Draw, TextInTheNamedFontWithEscapes) {
  const auto expect_text = [&](const std::string& commands, const intaglio::text::Font& font, int x0, int y0,
                               std::string_view text) {
    const oracle::Touches touches =
        oracle::text_pixels(oracle::utf8_by_definition(), font.tables(), x0, y0, text, {0, 0, width, height});
    EXPECT_FALSE(touches.empty());
    expect_pixels(commands, [&](int x, int y) { return touches.contains({y, x}); });
  };
  expect_text("text 5 12 \"Hello, wörld\"", intaglio::fonts::fixed_6x13, 5, 12, "Hello, wörld");
  expect_text("text -3 2 \"a\\\"b\\\\\\nc #d\" # comment", intaglio::fonts::fixed_6x13, -3, 2,
              "a\"b\\\nc #d");
  expect_text("font sans_11\ntext 1 1 \"Il \xFF\"", intaglio::fonts::sans_11, 1, 1, "Il \xFF");
  expect_pixels("text 1 1 \"\"", [](int, int) { return false; });
}

TEST(Draw, TextAlignedAtItsPlace) {
  const auto expect_aligned = [&](const std::string& how, int across, std::optional<int> down) {
    const oracle::Touches touches =
        oracle::aligned_text_pixels(oracle::utf8_by_definition(), intaglio::fonts::fixed_6x13.tables(), 30,
                                    30, 0, 0, across, down, "Il\n2 g", {0, 0, width, height});
    EXPECT_FALSE(touches.empty());
    expect_pixels("text 30 30 \"Il\\n2 g\"" + how, [&](int x, int y) { return touches.contains({y, x}); });
  };
  expect_aligned(" left", 0, 0);
  expect_aligned(" centre", 1, 0);
  expect_aligned(" right top", 2, 0);
  expect_aligned(" right middle", 2, 1);
  expect_aligned(" left baseline", 0, {});
  expect_aligned(" centre bottom", 1, 2);
}

TEST(Draw, ClipRestrictsAndNoneResets) {
  expect_pixels("clip 10 5 4 3\nfillrect 0 0 50 40",
                [](int x, int y) { return x >= 10 && x < 14 && y >= 5 && y < 8; });
  expect_pixels("clip 10 5 4 3\nclip none\nfillrect 0 0 50 40", [](int, int) { return true; });
  expect_pixels("clip 100 100 4 3\nfillrect 0 0 50 40", [](int, int) { return false; });
}

TEST(Draw, ClippolyRestrictsEveryPrimitiveToThePolygon) {
  const oracle::Contours star{{{5120, 256}, {7936, 9216}, {512, 3584}, {9984, 3584}, {2304, 9216}}};
  for (const std::string rule : {"", " evenodd", " nonzero"}) {
    // What comes before the command, and the command behind it.
    const auto clipped = [&](const char* before, const char* command) {
      std::string program = before;
      program.append("clippoly").append(rule).append(" 20 1 31 36 2 14 39 14 9 36\n").append(command);
      return program;
    };
    const auto in = [&](int x, int y) { return oracle::in_polygon(star, rule != " nonzero", x, y); };
    expect_pixels(clipped("", "fillrect 0 0 50 40"), in);
    expect_pixels(clipped("clip 10 5 14 30\n", "fillrect 0 0 50 40"),
                  [&](int x, int y) { return in(x, y) && x >= 10 && x < 24 && y >= 5 && y < 35; });
    expect_pixels(clipped("", "line 2 3 45 37"),
                  [&](int x, int y) { return in(x, y) && oracle::on_line(2, 3, 45, 37, x, y); });
    expect_pixels(clipped("", "circle 20 18 13"),
                  [&](int x, int y) { return in(x, y) && oracle::on_circle(13, x - 20, y - 18); });
    expect_pixels(clipped("", "flood 4 0 0"), in);
  }
  const oracle::Contours two{{{256, 256}, {5120, 256}, {1963, 9216}},
                             {{7680, 0}, {12800, 128}, {12800, 5120}}};
  expect_pixels("clippoly 1 1 20 1 23/3 36 / 30 0 50 0.5 50 20\nflood 8 5 5",
                [&](int x, int y) { return oracle::in_polygon(two, true, x, y); });
  expect_pixels("clippoly 0 0 9 0 0 9\nclippoly none\nfillrect 0 0 50 40", [](int, int) { return true; });
  expect_pixels("clippoly 0 0 9 0 0 9\nclippoly 0 0 1 0 1 1 0 1\ndisc 0 0 9",
                [](int x, int y) { return x == 0 && y == 0; });
  expect_pixels("clippoly 60 0 90 0 60 90\ndisc 0 0 9", [](int, int) { return false; });
}

TEST(Draw, ColourAndModeDecideWhatIsStored) {
  const auto canvas = draw_program(
      "surface 4 1 2\n"
      "color 1\nfillrect 0 0 3 1\n"
      "mode xor\ncolour 3\nfillrect 1 0 3 1\n"
      "mode set\ncolor 0\npixel 3 0\n");
  EXPECT_EQ(canvas->indices(), (std::vector<std::uint8_t>{1, 2, 2, 0}));
  EXPECT_EQ(canvas->touched(), (std::vector<std::uint8_t>{1, 2, 2, 2}));
}

TEST(Draw, XorTwiceLeavesNothingInEveryDepth) {
  for (const int bits : {1, 2, 4, 8}) {
    std::string source = "surface 61 47 " + std::to_string(bits) + "\nmode xor\n";
    constexpr std::string_view shapes =
        "disc 20 20 15\nline -5 3 70 40\ncircle 40 30 12\npolygon nonzero 3 3 50.5 9 20 44\n"
        "text 4 30 \"xor Ü\"\nrect 2 2 40 30\ntriangle 0 0 60 10 30 46\n";
    source += shapes;
    const auto once = draw_program(source);
    source += shapes;
    const auto twice = draw_program(source);
    EXPECT_NE(once->indices(), std::vector<std::uint8_t>(61 * 47, 0));
    EXPECT_EQ(twice->indices(), std::vector<std::uint8_t>(61 * 47, 0)) << bits;
  }
}

TEST(Draw, PaletteBeginsAsAGreyRampAndTakesColours) {
  EXPECT_EQ(draw_program("surface 1 1 1")->palette(), (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255}));
  EXPECT_EQ(draw_program("surface 1 1 2\npalette 1 255 128 0")->palette(),
            (std::vector<std::uint8_t>{0, 0, 0, 255, 128, 0, 170, 170, 170, 255, 255, 255}));
  EXPECT_EQ(draw_program("surface 1 1 8")->palette().size(), 768U);
}

TEST(Draw, TouchesSaturateAt255) {
  std::string source = "surface 2 1 1\n";
  for (int i = 0; i < 300; ++i) source += "pixel 1 0\n";
  EXPECT_EQ(draw_program(source)->touched(), (std::vector<std::uint8_t>{0, 255}));
}

TEST(Draw, CommentsBlankLinesTabsAndCarriageReturnsAreSkipped) {
  const auto canvas =
      draw_program("# a picture\r\n\r\n \t\nsurface\t2  1 1 # two pixels\r\n  pixel 1 0#here");
  EXPECT_EQ(canvas->indices(), (std::vector<std::uint8_t>{0, 1}));
}

// The digest is CRC-32 of size, palette and indices; computed bit by bit here.
TEST(Draw, DigestIsTheCrcOfSizePaletteAndIndices) {
  const auto canvas = draw_program("surface 3 2 1\npixel 1 1");
  const std::vector<std::uint8_t> bytes{3, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 255, 255, 255, 0, 0, 0, 0, 1, 0};
  std::uint32_t crc = 0xFFFFFFFF;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc / 2 ^ (crc % 2 != 0 ? 0xEDB88320U : 0U);
  }
  EXPECT_EQ(canvas->digest(), ~crc);
}

struct Mistake {
  const char* source;
  const char* message;
};

// Each after `surface 50 40 4` on line 1, but for those that are about the surface.
TEST(DrawErrors, SayTheLineTheCommandAndWhatIsWrong) {
  constexpr Mistake mistakes[]{
      {"", "line 1: no surface command"},
      {"# nothing\n", "line 2: no surface command"},
      {"\npixel 1 1", "line 2: the first command must be 'surface'"},
      {"surface 4 4 8\nsurface 4 4 8", "line 2: a second surface"},
      {"surface 4 4", "line 1: surface: bits is missing"},
      {"surface 4 4 3", "line 1: surface: bits must be 1, 2, 4 or 8, not 3"},
      {"surface 0 4 8", "line 1: surface: size empty"},
      {"surface 4 -1 8", "line 1: surface: size empty"},
      {"surface 1048577 1 8", "line 1: surface: size too large (limit 1048576)"},
      {"surface 100000 100000 8", "line 1: surface: size too large"},
      {"surface 4.5 4 8", "line 1: surface: width must be a whole number, not '4.5'"},
      {"surface 4 4 8 8", "line 1: surface: '8' is one argument too many"},
      {"\"surface\" 4 4 8", "line 1: a command must not stand in quotes"},
      {"S\n\n# x\nsqare 1 1", "line 4: unknown command 'sqare'"},
      {"S\nSurface 1 1 1", "line 2: unknown command 'Surface'"},
      {"S\npalette 16 0 0 0", "line 2: palette: index must be 0 to 15, not 16"},
      {"S\npalette 1 0 256 0", "line 2: palette: green must be 0 to 255, not 256"},
      {"S\npalette 1 0 0", "line 2: palette: blue is missing"},
      {"S\npalette 1 0 0 0 0", "line 2: palette: '0' is one argument too many"},
      {"S\ncolor 16", "line 2: color: index must be 0 to 15, not 16"},
      {"S\ncolour -1", "line 2: colour: index must be 0 to 15, not -1"},
      {"S\nmode or", "line 2: mode: must be set or xor, not 'or'"},
      {"S\nmode", "line 2: mode: mode is missing"},
      {"S\nclip 1 2 3", "line 2: clip: height is missing"},
      {"S\nclip none 1", "line 2: clip: x must be a number, not 'none'"},
      {"S\nclip 2000000 0 1 1", "line 2: clip: rectangle out of domain"},
      {"S\nclippoly 0 0 1 0", "line 2: clippoly: a contour needs 3 vertices, this has 2"},
      {"S\nclippoly none 1", "line 2: clippoly: x must be a number, not 'none'"},
      {"S\nclippoly oddeven 0 0 1 0 1 1", "line 2: clippoly: x must be a number, not 'oddeven'"},
      {"S\nclippoly 0 0 1 0 1 -1048577", "line 2: clippoly: vertices out of domain"},
      {"S\npixel 4/2 1", "line 2: pixel: x must be a whole number, not '4/2'"},
      {"S\ntriangle 0 0 1 0 1 1/0", "line 2: triangle: y must be a number, not '1/0'"},
      {"S\npixel 1 1.5", "line 2: pixel: y must be a whole number, not '1.5'"},
      {"S\npixel 1 \"1\"", "line 2: pixel: y must be a number, not '1'"},
      {"S\npixel 1048577 0", "line 2: pixel: point out of domain"},
      {"S\nline 1 1 2", "line 2: line: y1 is missing"},
      {"S\nline 0 0 0 -1048577", "line 2: line: point out of domain"},
      {"S\nthickline 0 0 5 5 -1", "line 2: thickline: width out of domain"},
      {"S\nthickline 0 0 5 5 1 flat", "line 2: thickline: the cap must be butt, square or round, not 'flat'"},
      {"S\nthickline 0 0 5 5", "line 2: thickline: width is missing"},
      {"S\nthickline 0 0 5 5 1 round 3", "line 2: thickline: '3' is one argument too many"},
      {"S\nmethod minor\nthickline 0 0 5 5 1.5",
       "line 3: thickline: this method needs a whole width and has only butt ends"},
      {"S\nmethod minor\nthickline 0 0 5 5 3 round",
       "line 3: thickline: this method needs a whole width and has only butt ends"},
      {"S\nmethod line1\nthickline 0 0 5 5 3",
       "line 3: thickline: no method 'line1'; there are across minor"},
      {"S\npolyline 3 0 0 5 5", "line 2: polyline: the join must be miter, bevel or round, not '0'"},
      {"S\npolyline 3", "line 2: polyline: join is missing"},
      {"S\npolyline 3 miter", "line 2: polyline: x is missing"},
      {"S\npolyline 3 miter 1 1 2", "line 2: polyline: y is missing"},
      {"S\npolyline 3 miter limit 17 1 1 2 2", "line 2: polyline: limit out of range"},
      {"S\npolyline -3 miter 1 1 2 2", "line 2: polyline: width out of domain"},
      {"S\npolyline 3 round 1 1 2 1048577", "line 2: polyline: vertices out of domain"},
      {"S\nthickline 0 0 1048576 1048576 9", "line 2: thickline: point out of domain"},
      {"S\ndash 0 1 1 1 2 2", "line 2: dash: steps out of range"},
      {"S\ndash 1 1.5 1 1 2 2", "line 2: dash: off must be a whole number, not '1.5'"},
      {"S\ndash 1 1 1 1 2 1048577", "line 2: dash: point out of domain"},
      {"S\ndash 1 1 1 1 2", "line 2: dash: y1 is missing"},
      {"S\nrect 0 0 2097153 1", "line 2: rect: rectangle out of domain"},
      {"S\nfillrect 0 9999999999 1 1", "line 2: fillrect: rectangle out of domain"},
      {"S\ncircle 1 1 -1", "line 2: circle: radius out of domain"},
      {"S\nevendisc 1 1 -1", "line 2: evendisc: size out of domain"},
      {"S\nellipse 1 1 4", "line 2: ellipse: y radius is missing"},
      {"S\nfillellipse 1 1 4 -4", "line 2: fillellipse: radius out of domain"},
      {"S\narc 1 1 -4 3 3", "line 2: arc: radius out of domain"},
      {"S\npie 1 1 4 3", "line 2: pie: sweep is missing"},
      {"S\nring 1 1 4 3", "line 2: ring: radius mismatched"},
      {"S\nroundrect 1 1 4 3 -1", "line 2: roundrect: radius out of domain"},
      {"S\nroundrect 1 1 4 3 1 2", "line 2: roundrect: bottom right radius is missing"},
      {"S\ndisc 1 1 1048577", "line 2: disc: radius out of domain"},
      {"S\ndisc 1 1 2.5", "line 2: disc: radius must be a whole number, not '2.5'"},
      {"S\ntriangle 0 0 1 0 1", "line 2: triangle: y is missing"},
      {"S\ntriangle 0 0 1 0 1 1e3", "line 2: triangle: y must be a number, not '1e3'"},
      {"S\ntriangle 0 0 1 0 1 1048576.1", "line 2: triangle: point out of domain"},
      {"S\nmethod basic\nline 0 0 9 9",
       "line 3: line: no method 'basic'; there are exact line1 line2 distance"},
      {"S\nmethod line1\nline 0 0 9.5 9", "line 3: line: this method needs whole pixels"},
      {"S\nmethod line2\nline 0 0 9 1048577", "line 3: line: point out of domain"},
      {"S\nmethod basic\ntriangle 0 0 9 0 0 9",
       "line 3: triangle: no method 'basic'; there are walk box blocks"},
      {"S\nmethod box\npolygon evenodd 0 0 9 0 0 9",
       "line 3: polygon: no method 'box'; there are active basic critical"},
      {"S\nmethod box\npixel 1 1", "line 3: pixel: no method 'box'; there is only one"},
      {"S\nmethod", "line 2: method: name is missing"},
      {"S\nflood 6 1 1", "line 2: flood: a pixel has 4 or 8 neighbours, not '6'"},
      {"S\nflood 4 1", "line 2: flood: y is missing"},
      {"S\nflood 4 1 1048577", "line 2: flood: point out of domain"},
      {"S\npolygon 0 0 1 0 1 1", "line 2: polygon: the rule must be evenodd or nonzero, not '0'"},
      {"S\npolygon evenodd 0 0 1 0", "line 2: polygon: a contour needs 3 vertices, this has 2"},
      {"S\npolygon evenodd 0 0 1 0 1 1 /", "line 2: polygon: a contour needs 3 vertices, this has 0"},
      {"S\npolygon evenodd 0 0 1 0 1 1 2", "line 2: polygon: y is missing"},
      {"S\nboolean minus 0 0 1 0 1 1",
       "line 2: boolean: the operation must be intersection, union, a-b or b-a, not 'minus'"},
      {"S\nboolean union 0 0 1 0 1 1", "line 2: boolean: the second polygon after / is missing"},
      {"S\nboolean union 0 0 1 0 / 0 0 1 0 1 1", "line 2: boolean: a polygon needs 3 vertices, this has 2"},
      {"S\nboolean union 0 0 1 0 1 2049 / 0 0 1 0 1 1", "line 2: boolean: vertices out of domain"},
      {"S\npolygon evenodd 0 0 1 0 1 -1048577", "line 2: polygon: vertices out of domain"},
      {"S\ncoverage 0 0 1 0 1 1", "line 2: coverage: the surface must have 8 bits a pixel"},
      {"surface 9 9 8\ncoverage 0 0 1 0", "line 2: coverage: a contour needs 3 vertices, this has 2"},
      {"surface 9 9 8\ncoverage 0 0 1 0 1 -1048577", "line 2: coverage: vertices out of domain"},
      {"S\nfont comic",
       "line 2: font: no font 'comic'; there are fixed_5x8 fixed_6x13 sans_11 digits_16 digits_28 digits_48"},
      {"S\ntext 1 1 hello", "line 2: text: the text must stand in quotes, not 'hello'"},
      {"S\ntext 1 1", "line 2: text: text is missing"},
      {"S\ntext 1 1 \"a\" \"left\"", "line 2: text: the alignment must be left, centre or right, not 'left'"},
      {"S\ntext 1 1 \"a\" left up",
       "line 2: text: the base line must be top, middle, baseline or bottom, not 'up'"},
      {"S\ntext 1 1 \"a\" left top \"b\"", "line 2: text: 'b' is one argument too many"},
      {"S\ntext 1 1 \"a", "line 2: the quote doesn't end on this line"},
      {"S\ntext 1 1 \"a\\", "line 2: a backslash in quotes must stand before \", \\ or n"},
      {"S\ntext 1 1 \"\\t\"", "line 2: a backslash in quotes must stand before \", \\ or n"},
      {"S\ntext 1048577 1 \"a\"", "line 2: text: point out of domain"},
  };
  for (const Mistake& mistake : mistakes) {
    std::string source = mistake.source;
    if (source.starts_with("S\n")) source.replace(0, 1, "surface 50 40 4");
    try {
      (void)draw_program(source);
      ADD_FAILURE() << "no error: " << source;
    } catch (const host::Failure& failure) {
      EXPECT_STREQ(failure.what(), mistake.message) << source;
    }
  }
}

}  // namespace
