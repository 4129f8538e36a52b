// SPDX-License-Identifier: MIT
//
// intaglio-draw as a user runs it: what it writes, and that it writes nothing after a mistake.
#include <host/png.hpp>
#include <tests/host/run_tool.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace {

using test_host::Outcome;
using test_host::run;
using testing::HasSubstr;

const std::string tool = INTAGLIO_DRAW_PROGRAM;
constexpr const char* program =
    "surface 3 2 4\npalette 1 255 128 0\ncolor 1\nfillrect 0 0 2 1\ncolor 12\npixel 2 1\npixel 2 1\n";

class DrawTool : public testing::Test {
 protected:
  test_host::Folder folder_;
};

TEST_F(DrawTool, WritesAllOutputsOfAFile) {
  const std::string source = folder_ / "p.draw";
  test_host::write(source, program);
  const Outcome outcome = run(tool + " " + source + " --png " + (folder_ / "p.png") + " --pgm " +
                              (folder_ / "p.pgm") + " --touched " + (folder_ / "t.pgm") + " --ascii");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.output, "11.\n..c\n");
  EXPECT_EQ(test_host::read(folder_ / "p.pgm"), std::string("P5\n3 2\n255\n\1\1\0\0\0\14", 17));
  EXPECT_EQ(test_host::read(folder_ / "t.pgm"), std::string("P5\n3 2\n255\n\1\1\0\0\0\2", 17));
  const host::RgbaPicture png = host::read_png(folder_ / "p.png");
  ASSERT_EQ(png.width, 3);
  ASSERT_EQ(png.height, 2);
  const std::vector<std::uint8_t> expected{255, 128, 0, 255, 255, 128, 0, 255, 0,   0,   0,   255,
                                           0,   0,   0, 255, 0,   0,   0, 255, 204, 204, 204, 255};
  EXPECT_EQ(png.rgba, expected);
}

TEST_F(DrawTool, ReadsStandardInputAndPrintsTheDigest) {
  // Computed with python3: zlib.crc32(struct.pack("<II", 1, 1) + bytes([0, 0, 0, 255, 255, 255]) +
  // bytes([1]))
  const Outcome outcome = run("printf 'surface 1 1 1\\npixel 0 0\\n' | " + tool + " - --digest");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.output, "frame 0 crc32 2b18f837\n");
  EXPECT_EQ(run("printf 'surface 1 1 1' | " + tool + " --ascii").output, ".\n");
}

TEST_F(DrawTool, APictureThatIsShownNowhereIsntSilentlyLost) {
  const Outcome nowhere = run("printf 'surface 1 1 1' | " + tool);
  EXPECT_EQ(nowhere.code, 0);
  EXPECT_THAT(nowhere.output, HasSubstr("--png"));
  const Outcome wires = run("printf 'surface 1 1 1' | " + tool + " --ascii --i2c /dev/i2c-1");
  EXPECT_NE(wires.code, 0);
  EXPECT_THAT(wires.output, HasSubstr("--panel"));
}

TEST_F(DrawTool, AsciiHasOneSignAnIndex) {
  const Outcome outcome =
      run("printf 'surface 6 1 8\\ncolor 9\\npixel 1 0\\ncolor 10\\npixel 2 0\\ncolor 35\\npixel 3 0\\ncolor "
          "36\\n"
          "pixel 4 0\\ncolor 255\\npixel 5 0\\n' | " +
          tool + " --ascii");
  EXPECT_EQ(outcome.output, ".9az##\n");
}

TEST_F(DrawTool, AMistakeOnTheLastLineWritesNothing) {
  const std::string source = folder_ / "p.draw";
  test_host::write(source, std::string(program) + "circle 1 1 -1\n");
  const Outcome outcome =
      run(tool + " " + source + " --png " + (folder_ / "p.png") + " --pgm " + (folder_ / "p.pgm") +
          " --touched " + (folder_ / "t.pgm") + " --ascii --digest");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.output, "line 8: circle: radius out of domain\n");
  EXPECT_EQ(folder_.files(), 1U);
}

TEST_F(DrawTool, FilesThatCannotBeReadOrWrittenAreNamed) {
  const Outcome missing = run(tool + " /nowhere/p.draw --ascii");
  EXPECT_EQ(missing.code, 1);
  EXPECT_THAT(missing.output, HasSubstr("/nowhere/p.draw: No such file"));
  EXPECT_EQ(run(tool + " " + (folder_ / ".")).code, 1);
  const Outcome unwritable = run("printf 'surface 1 1 1' | " + tool + " --pgm /nowhere/p.pgm");
  EXPECT_EQ(unwritable.code, 1);
  EXPECT_THAT(unwritable.output, HasSubstr("/nowhere/p.pgm: No such file"));
  const Outcome full = run("printf 'surface 100 100 8' | " + tool + " --pgm /dev/full");
  EXPECT_EQ(full.code, 1);
  EXPECT_THAT(full.output, HasSubstr("/dev/full"));
  const Outcome binary = run("head -c 1000 " + tool + " | " + tool);
  EXPECT_EQ(binary.code, 1);
  EXPECT_THAT(binary.output, HasSubstr("line 1: "));
}

TEST_F(DrawTool, HelpNamesEveryCommand) {
  const Outcome help = run(tool + " --help");
  EXPECT_EQ(help.code, 0);
  for (const char* word : {"surface W H BITS",
                           "palette ",
                           "color ",
                           "mode set|xor",
                           "aa off",
                           "clip ",
                           "font ",
                           "pixel ",
                           "line ",
                           "rect ",
                           "fillrect",
                           "circle ",
                           "disc",
                           "evencircle ",
                           "evendisc",
                           "ellipse ",
                           "fillellipse",
                           "ring ",
                           "dash ",
                           "thickline ",
                           "arc ",
                           "pie",
                           "chord",
                           "ellipsearc ",
                           "roundrect ",
                           "fillroundrect",
                           "triangle ",
                           "polygon evenodd|nonzero",
                           "coverage ",
                           "text ",
                           "--png",
                           "--pgm",
                           "--touched",
                           "--ascii",
                           "--digest"})
    EXPECT_THAT(help.output, HasSubstr(word));
  EXPECT_EQ(run(tool + " --unknown").code, 1);
}

}  // namespace
