// SPDX-License-Identifier: MIT
//
// intaglio-assets as a user runs it. What it writes is checked by compiling it, freestanding, with static
// assertions on its content.
#include <host/assets/ordered.hpp>
#include <host/png.hpp>
#include <tests/host/run_tool.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using test_host::Outcome;
using test_host::run;
using testing::HasSubstr;

const std::string tool = INTAGLIO_ASSETS_PROGRAM;
const std::string fixed_font = std::string(INTAGLIO_X11_FONTS) + "/6x13.pcf.gz";
const std::string outline_font = std::string(INTAGLIO_DEJAVU_FONTS) + "/DejaVuSans.ttf";
const std::string flags =
    " -std=c++20 -ffreestanding -fno-exceptions -fno-rtti -Wall -Wextra -Wconversion -Wsign-conversion "
    "-Werror "
    "-fsyntax-only -I" INTAGLIO_SOURCE "/firmware -I" INTAGLIO_SOURCE "/hal/include ";

class Assets : public testing::Test {
 protected:
  Outcome assets(const std::string& arguments) { return run(tool + " " + arguments); }

  /// Compiles a translation unit that includes the header, natively and for Arm where there is a compiler.
  void expect_compiles(const std::string& header, const std::string& assertions) {
    const std::string probe = folder_ / "probe.cpp";
    test_host::write(probe, "#include \"" + header + "\"\n" + assertions + "\n");
    const Outcome native = run(INTAGLIO_COMPILER + flags + probe);
    EXPECT_EQ(native.code, 0) << native.output;
    if (run("command -v arm-none-eabi-g++").code != 0) return;
    const Outcome arm = run("arm-none-eabi-g++ -mcpu=cortex-m0plus -mthumb" + flags + probe);
    EXPECT_EQ(arm.code, 0) << arm.output;
  }

  /// The command fails with this text, names the input and leaves no file behind.
  void expect_refused(const std::string& command, const std::string& input, const std::string& options,
                      const std::string& why) {
    const std::size_t before = folder_.files();
    const Outcome outcome =
        assets(command + " " + input + " --name x -o " + (folder_ / "x.hpp") + " " + options);
    EXPECT_EQ(outcome.code, 1) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr(why));
    EXPECT_THAT(outcome.output, HasSubstr(input));
    EXPECT_EQ(folder_.files(), before) << "something was written";
  }

  test_host::Folder folder_;
};

TEST_F(Assets, FontOfABitmapFileCompilesFreestandingAndHasItsGlyphs) {
  const std::string header = folder_ / "f.hpp";
  const Outcome outcome =
      assets("font " + fixed_font + " --fixed --charset '0x41-0x43, U+E9,8364' --chars 'Zñ' " +
             "--name face --namespace a::b --credit 'Public\ndomain' -o " + header);
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_THAT(test_host::read(header), HasSubstr("// Source and licence: Public\n// domain\n"));
  EXPECT_THAT(test_host::read(header), HasSubstr("from 6x13.pcf.gz;"));
  // A..C, Z, é, ñ, €, and the replacement box. The A of 6x13 is 5 wide and 9 high, two rows below the top.
  expect_compiles(header, R"(
    using namespace a::b;
    static_assert(face.line_height() == 13 && face.ascent() == 11);
    static_assert(face.tables().glyphs.size() == 8 && face.tables().ranges.size() == 5);
    static_assert(face.tables().ranges[0].first == 'A' && face.tables().ranges[0].count == 3);
    static_assert(face.tables().ranges[4].first == 0x20AC && face.tables().ranges[4].glyph == 7);
    constexpr auto letter = face.tables().glyphs[1];
    static_assert(letter.width == 5 && letter.height == 9 && letter.top == 2 && letter.advance == 6);
    static_assert(face.tables().rows[letter.offset] == 0x20 && face.tables().rows[letter.offset + 5] == 0xF8);
  )");
}

TEST_F(Assets, FontOfAnOutlineIsProportionalAndTightWhereAsked) {
  const std::string header = folder_ / "f.hpp";
  const Outcome outcome =
      assets("font " + outline_font + " --size 20 --tight --chars 'iW' --name face -o " + header);
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  expect_compiles(header, R"(
    using intaglio::fonts::face;
    static_assert(face.line_height() == 15 && face.ascent() == 15);  // the height of W, and of i with its dot
    static_assert(face.tables().glyphs[2].advance < 7 && face.tables().glyphs[1].advance > 17);
    static_assert(face.tables().glyphs[2].top == 0 && face.tables().glyphs[1].width > 16);
  )");
}

TEST_F(Assets, OutputIsTheSameEachTime) {
  const std::string command = "font " + outline_font + " --size 12 --charset 0x20-0x7E --name f -o ";
  for (const char* name : {"1.hpp", "2.hpp"}) ASSERT_EQ(assets(command + (folder_ / name)).code, 0);
  EXPECT_EQ(test_host::read(folder_ / "1.hpp"), test_host::read(folder_ / "2.hpp"));
}

TEST_F(Assets, ImageWithFewColoursKeepsThemInBothBitOrders) {
  // 5x2, three colours.
  const host::IndexedPicture picture{
      5, 2, {2, 1, 0, 1, 2, 0, 0, 1, 1, 2}, {10, 20, 30, 200, 100, 50, 255, 0, 255}};
  test_host::write(folder_ / "p.png", host::encode_png(picture));
  for (const std::string order : {"msb", "lsb"}) {
    const std::string header = folder_ / (order + ".hpp");
    std::string command = "image " + (folder_ / "p.png") + " --bits 2 --order ";
    command.append(order).append(" --name icon -o ").append(header);
    const Outcome outcome = assets(command);
    ASSERT_EQ(outcome.code, 0) << outcome.output;
    expect_compiles(header, R"(
      #include <array>
      using namespace intaglio::images::icon;
      static_assert(picture.size() == intaglio::linear::Size{5, 2} && Format::bits == 2);
      static_assert(sizeof palette == 9 && palette[0] == 255 && palette[1] == 0 && palette[3] == 200 && palette[8] == 30);
      constexpr bool same() {  // indices are numbered as the colours appear: 2 1 0 becomes 0 1 2
        constexpr std::array<unsigned, 10> expected{0, 1, 2, 1, 0, 2, 2, 1, 1, 0};
        for (int i = 0; i < 10; ++i)
          if (picture.get(i % 5, i / 5) != expected[static_cast<std::size_t>(i)]) return false;
        return true;
      }
      static_assert(same());
    )");
  }
}

TEST_F(Assets, ImageWithManyColoursIsReducedToThoseAllowed) {
  host::IndexedPicture picture{16, 16, {}, {}};
  for (int i = 0; i < 256; ++i) {
    picture.indices.push_back(static_cast<std::uint8_t>(i));
    for (const int channel : {i, 255 - i, i / 2})
      picture.palette_rgb.push_back(static_cast<std::uint8_t>(channel));
  }
  test_host::write(folder_ / "p.png", host::encode_png(picture));
  const std::string header = folder_ / "p.hpp";
  const Outcome outcome =
      assets("image " + (folder_ / "p.png") + " --bits 4 --colours 12 --name p -o " + header);
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  expect_compiles(header, R"(
    using namespace intaglio::images::p;
    static_assert(sizeof palette <= 36 && sizeof palette > 18 && sizeof pixels == 128);
    static_assert(picture.get(0, 0) != picture.get(15, 15) && picture.get(15, 15) * 3 < sizeof palette);
  )");
}

TEST_F(Assets, DitheredImageHasTheMeanOfTheColoursThatItLost) {
  // Greys from left to right, of which two are left.
  host::IndexedPicture picture{64, 16, {}, {}};
  for (int i = 0; i < 64 * 16; ++i) picture.indices.push_back(static_cast<std::uint8_t>(i % 64));
  for (int i = 0; i < 64; ++i) picture.palette_rgb.insert(picture.palette_rgb.end(), 3, std::uint8_t(4 * i));
  test_host::write(folder_ / "p.png", host::encode_png(picture));
  for (const std::string dither : {"ordered", "diffusion", "1", "0"}) {
    const std::string header = folder_ / (dither + ".hpp");
    std::string command = "image " + (folder_ / "p.png") + " --bits 1 --name p --dither ";
    command.append(dither).append(" -o ").append(header);
    const Outcome outcome = assets(command);
    ASSERT_EQ(outcome.code, 0) << outcome.output;
    const std::string mean_is_kept = dither == "0" ? "off > 20 * 128" : "off < 6 * 128";
    expect_compiles(header, R"(
      using namespace intaglio::images::p;
      constexpr int off_by() {  // of 8x16 pixels with a mean of 110
        int sum = 0;
        for (int y = 0; y < 16; ++y)
          for (int x = 24; x < 32; ++x) sum += palette[3 * picture.get(x, y)] - 110;
        return sum < 0 ? -sum : sum;
      }
      constexpr int off = off_by();
      static_assert()" + mean_is_kept +
                                ");");
  }
  EXPECT_EQ(test_host::read(folder_ / "diffusion.hpp"), test_host::read(folder_ / "1.hpp"));
  EXPECT_NE(test_host::read(folder_ / "ordered.hpp"), test_host::read(folder_ / "1.hpp"));
}

TEST_F(Assets, OrderedDitheringLeavesColoursOfThePaletteAndIsEvenWithinOne) {
  using host::assets::Colour;
  const std::vector<Colour> palette{{200, 200, 200}, {0, 0, 0}, {255, 0, 0}, {100, 100, 100}};
  const auto shown = [&](Colour colour) {
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < 64; ++i) rgba.insert(rgba.end(), {colour[0], colour[1], colour[2], 255});
    std::array<int, 4> counts{};
    for (const auto entry : host::assets::dither_ordered(rgba, 8, palette)) ++counts.at(entry);
    return counts;
  };
  for (std::size_t i = 0; i < palette.size(); ++i) EXPECT_EQ(shown(palette[i]).at(i), 64) << i;
  EXPECT_EQ(shown({150, 150, 150}), (std::array<int, 4>{32, 0, 0, 32}));
  EXPECT_EQ(shown({25, 25, 25}), (std::array<int, 4>{0, 48, 0, 16}));
  EXPECT_EQ(shown({192, 0, 0}), (std::array<int, 4>{0, 16, 48, 0}));
  EXPECT_EQ(shown({255, 255, 255}), (std::array<int, 4>{64, 0, 0, 0}));
}

TEST_F(Assets, PolygonsAreRoundedRingsWithoutTheirClosingVertex) {
  test_host::write(folder_ / "p.json", R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {}, "geometry": null},
    {"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": [1, 2]}},
    {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [
      [[0, 0], [10.26, 0], [10.26, 10.24], [0, 10], [0, 0]], [[1, 1], [2, 1], [2, 2], [1, 1]]]}},
    {"type": "Feature", "properties": {}, "geometry": {"type": "MultiPolygon", "coordinates": [
      [[[-5, -5], [-4, -5], [-4, -4.25], [-5, -5]]], [[[0.01, 0], [0.02, 0], [0.02, 0.01], [0.01, 0]]]]}}]})");
  const std::string header = folder_ / "p.hpp";
  const Outcome outcome =
      assets("polygons " + (folder_ / "p.json") + " --scale 10 --spdx CC0-1.0 --name p -o " + header);
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  expect_compiles(header, R"(
    using namespace intaglio::polygons::p;
    static_assert(sizeof(Vertex) == 4 && sizeof polygons == 2 * sizeof(Polygon));
    static_assert(polygons[0].contour_count == 2 && polygons[0].vertex_count == 7 && largest_polygon == 7);
    static_assert(polygons[1].first_vertex == 7 && polygons[1].first_contour == 2 && polygons[1].contour_count == 1);
    static_assert(polygons[0].min_x == 0 && polygons[0].min_y == -102 && polygons[1].max_x == -40);
    static_assert(sizeof contour_lengths == 3 * sizeof(int));
    static_assert(contour_lengths[0] == 4 && contour_lengths[1] == 3 && contour_lengths[2] == 3);
    static_assert(sizeof vertices == 10 * sizeof(Vertex));
    static_assert(vertices[2].x == 103 && vertices[2].y == -102 && vertices[3].x == 0 && vertices[3].y == -100);
    static_assert(vertices[9].x == -40 && vertices[9].y == 43);  // 42.5: halves go away from zero
    static_assert(lowest.x == -50 && lowest.y == -102 && highest.x == 103 && highest.y == 50);
  )");
  EXPECT_EQ(test_host::read(header).find("// SPDX-License-Identifier: CC0-1.0\n"), 0U);
  EXPECT_THAT(test_host::read(header), HasSubstr("1 contours too small"));
}

TEST_F(Assets, LargeCoordinatesTakeLargerIntegers) {
  test_host::write(folder_ / "p.json",
                   R"({"type": "Polygon", "coordinates": [[[0, 0], [40000, 0], [0, 1], [0, 0]]]})");
  const std::string header = folder_ / "p.hpp";
  ASSERT_EQ(assets("polygons " + (folder_ / "p.json") + " --scale 1 --y-up --name p -o " + header).code, 0);
  expect_compiles(header, R"(
    using namespace intaglio::polygons::p;
    static_assert(sizeof(Vertex) == 8 && vertices[1].x == 40000 && vertices[2].y == 1);
  )");
}

TEST_F(Assets, BadFontsAreRefused) {
  const std::string text = folder_ / "text";
  test_host::write(text, "This is not a font.\n");
  const std::string empty = folder_ / "empty";
  test_host::write(empty, "");
  const std::string cut = folder_ / "cut.pcf.gz";
  test_host::write(cut, test_host::read(fixed_font).substr(0, 9000));
  const std::string cut_outline = folder_ / "cut.ttf";
  test_host::write(cut_outline, test_host::read(outline_font).substr(0, 200000));
  expect_refused("font", "/nowhere/6x13.pcf.gz", "--charset 65", "No such file");
  expect_refused("font", INTAGLIO_SOURCE, "--charset 65", "is a directory");
  expect_refused("font", text, "--charset 65", "not a font");
  expect_refused("font", empty, "--charset 65", "not a font");
  expect_refused("font", cut, "--charset 0x20-0x7E", "");
  expect_refused("font", cut_outline, "--size 12 --charset 0x20-0x7E", "");
  expect_refused("font", fixed_font, "", "the charset is empty");
  expect_refused("font", fixed_font, "--charset 65,0x1F600,U+1F601", "no glyph for U+1F600 U+1F601");
  expect_refused("font", fixed_font, "--size 40 --charset 65", "no size of 40");
  expect_refused("font", outline_font, "--fixed --charset 65", "give --size");
}

TEST_F(Assets, BadOptionsAreRefused) {
  const auto refused = [&](const std::string& arguments, const std::string& why) {
    const Outcome outcome = assets("font " + fixed_font + " -o " + (folder_ / "x.hpp") + " " + arguments);
    EXPECT_EQ(outcome.code, 1) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr(why));
    EXPECT_EQ(folder_.files(), 0U);
  };
  refused("--name x --charset 0x7E-0x20", "'0x7E-0x20' ends before it begins");
  refused("--name x --charset 65,sixty", "'sixty'");
  refused("--name x --charset 0x110000", "'0x110000'");
  refused("--name x --charset 65-", "'65-'");
  refused("--name x --chars $(printf '\\377')", "malformed UTF-8");
  refused("--name 6x13 --charset 65", "--name '6x13' is not a C++ name");
  refused("--name x --namespace a::::b --charset 65", "--namespace 'a::::b'");
  refused("--charset 65", "--name is required");
  EXPECT_EQ(assets("").code, 1);
  EXPECT_EQ(assets("--help").code, 0);
  const Outcome nowhere = assets("font " + fixed_font + " --name x --charset 65 -o /nowhere/x.hpp");
  EXPECT_EQ(nowhere.code, 1);
  EXPECT_THAT(nowhere.output, HasSubstr("/nowhere/x.hpp: No such file"));
}

TEST_F(Assets, BadImagesAreRefused) {
  const host::IndexedPicture picture{64, 64, std::vector<std::uint8_t>(64 * 64), {1, 2, 3, 4, 5, 6}};
  const std::string good = host::encode_png(picture);
  const std::string cut = folder_ / "cut.png";
  test_host::write(cut, good.substr(0, good.size() / 2));
  const std::string text = folder_ / "text.png";
  test_host::write(text, "P3 1 1 255 0 0 0\n");
  const std::string whole = folder_ / "whole.png";
  test_host::write(whole, good);
  expect_refused("image", "/nowhere/x.png", "", "No such file");
  expect_refused("image", text, "", "not a PNG");
  expect_refused("image", cut, "", "PNG");
  expect_refused("image", whole, "--bits 2 --colours 5", "5 colours don't fit 2 bits");
  EXPECT_THAT(assets("image x.png --name x -o x.hpp --dither 2").output, HasSubstr("--dither"));
  EXPECT_THAT(assets("image x.png --name x -o x.hpp --dither bayer").output, HasSubstr("--dither"));
}

TEST_F(Assets, BadPolygonsAreRefused) {
  int number = 0;
  const auto refused = [&](const std::string& json, const std::string& why, const std::string& scale = "1") {
    const std::string file = folder_ / (std::to_string(++number) + ".json");
    test_host::write(file, json);
    expect_refused("polygons", file, "--scale " + scale, why);
  };
  refused("", "not JSON");
  refused(R"({"type": "Polygon", "coordinates": [[[0, 0], [1,)", "not JSON");
  refused("[1, 2]", "not GeoJSON");
  refused(R"({"type": "Polygon"})", "lacks \"coordinates\"");
  refused(R"({"type": "Polygon", "coordinates": [[["a", 0], [1, 0], [1, 1]]]})", "position");
  refused(R"({"type": "Polygon", "coordinates": [[[0], [1, 0], [1, 1]]]})", "position");
  refused(R"({"type": "Polygon", "coordinates": 7})", "not a list");
  refused(R"({"type": "Point", "coordinates": [0, 0]})", "no polygon");
  refused(R"({"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1]]]})", "no polygon", "0.1");
  refused(R"({"type": "Polygon", "coordinates": [[[0, 0], [1e9, 0], [1, 1]]]})", "leaves the range");
  refused(R"({"type": "Polygon", "coordinates": [[[0, 0], [1e300, 0], [1, 1]]]})", "leaves the range",
          "1e200");
}

}  // namespace
