// SPDX-License-Identifier: MIT
//
// The strict panel reports every fault it promises to report, and nothing else.
#include <hal/mock/strict_panel.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/present/frame_writer.hpp>
#include <intaglio/present/swap_chain.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/rectangle.hpp>
#include <intaglio/raster/sink.hpp>

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace {

using hal::Error;
using hal::Part;
using hal::mock::Pattern;
using hal::mock::Recorder;
using hal::mock::scan_out_panel;
using hal::mock::StrictPanel;
using hal::mock::write_panel;
using intaglio::image::Indexed1;
using intaglio::image::Indexed8;
using intaglio::present::FrameWriter;
using intaglio::present::SwapChain;

static_assert(intaglio::raster::SpanSink<Recorder>);
static_assert(!intaglio::raster::CursorSink<Recorder>);
static_assert(!intaglio::raster::BlockSink<Recorder>);

Pattern parsed(std::initializer_list<std::string_view> rows) {
  std::string error;
  Pattern pattern = Pattern::parse(std::vector<std::string_view>(rows), error);
  EXPECT_EQ(error, "");
  return pattern;
}

TEST(Pattern, IsReadAsItIsWritten) {
  const Pattern pattern = parsed({".#29", "az.1"});
  EXPECT_EQ(pattern.pixels, (std::vector<int>{0, 1, 2, 9, 10, 35, 0, 1}));
}

TEST(Pattern, BadRowsAreNamed) {
  std::string error;
  EXPECT_EQ(Pattern::parse(std::vector<std::string_view>{"..", "."}, error).height, 0);
  EXPECT_EQ(error, "row 1 differs in length from row 0");
  EXPECT_EQ(Pattern::parse(std::vector<std::string_view>{".!"}, error).height, 0);
  EXPECT_EQ(error, "'!' in row 0 is no pixel");
}

TEST(Pattern, DifferencesStandSideBySide) {
  EXPECT_EQ(side_by_side(parsed({"..##", "2..."}), parsed({".##.", "3..."}), false),
            "3 of 8 pixels differ\n"
            "  expected   | actual     | difference\n"
            "  ..##       | .##.       | .+.-\n"
            "  2...       | 3...       | *...\n");
  EXPECT_EQ(side_by_side(parsed({".#"}), parsed({".#"}), false), "");
  EXPECT_EQ(side_by_side(parsed({".#"}), parsed({".", "#"}), false), "expected 2x1 pixels, got 1x2\n");
}

TEST(Pattern, DifferencesAreColoured) {
  const std::string text = side_by_side(parsed({".#"}), parsed({"#."}), true);
  EXPECT_NE(text.find("\x1b[1;31m+"), std::string::npos) << "too many: red";
  EXPECT_NE(text.find("\x1b[1;34m-"), std::string::npos) << "missing: blue";
  EXPECT_EQ(text.substr(text.size() - 5), "\x1b[0m\n") << "the colour ends with the picture";
}

TEST(Pattern, LargePicturesAreCutToTheDifference) {
  const Pattern expected = Pattern::blank(320, 240);
  Pattern actual = expected;
  actual.at(100, 50) = 1;
  EXPECT_EQ(side_by_side(expected, actual, false),
            "1 of 76800 pixels differ; columns 98..102, rows 48..52\n"
            "  expected   | actual     | difference\n"
            "  .....      | .....      | .....\n"
            "  .....      | .....      | .....\n"
            "  .....      | ..#..      | ..+..\n"
            "  .....      | .....      | .....\n"
            "  .....      | .....      | .....\n");
  for (int& pixel : actual.pixels) pixel = 1;
  const std::string text = side_by_side(expected, actual, false);
  EXPECT_LT(std::ranges::count(text, '\n'), 50);
}

TEST(StrictPanel, RightPicturePasses) {
  StrictPanel panel(write_panel(5, 3, 8));
  auto pen = panel.recorder(1);
  ASSERT_TRUE(intaglio::raster::draw_line(pen, {0, 0}, {4, 2}).ok());
  panel.expect_picture({"#....",  //
                        ".##..",  //
                        "...##"});
  panel.expect_writes({"1....",  //
                       ".11..",  //
                       "...11"});
}

TEST(StrictPanel, WrongPictureIsShown) {
  StrictPanel panel(write_panel(3, 1, 8));
  panel.recorder(2).span(0, 1, 2);
  EXPECT_NONFATAL_FAILURE(panel.expect_picture({".2#"}), "the display: 1 of 3 pixels differ");
  EXPECT_NONFATAL_FAILURE(panel.expect_buffer(0, {"..."}), "frame buffer 0: 1 of 3 pixels differ");
  EXPECT_NONFATAL_FAILURE(panel.expect_writes({"#.."}), "writes: 2 of 3 pixels differ");
  EXPECT_NONFATAL_FAILURE(panel.expect_picture({".2"}), "expected 2x1 pixels, got 3x1");
  EXPECT_NONFATAL_FAILURE(panel.expect_picture({".?."}), "'?' in row 0 is no pixel");
}

TEST(StrictPanel, SpanOutsideTheClipIsReportedAndNotDrawn) {
  StrictPanel panel(write_panel(4, 2, 8));
  Recorder pen = panel.recorder(1);
  EXPECT_NONFATAL_FAILURE(pen.span(0, -1, 2), "span outside the clip: row 0, columns -1 .. 1");
  EXPECT_NONFATAL_FAILURE(pen.span(0, 2, 5), "span outside the clip");
  EXPECT_NONFATAL_FAILURE(pen.span(2, 0, 1), "span outside the clip: row 2");
  EXPECT_NONFATAL_FAILURE(pen.span(-1, 0, 1), "span outside the clip: row -1");
  EXPECT_NONFATAL_FAILURE(pen.span(0, 2, 2), "empty span in row 0: 2 .. 2");
  Recorder part = pen.clipped(1, 0, 2, 1);
  EXPECT_NONFATAL_FAILURE(part.span(0, 0, 2), "the clip has columns 1 .. 2, rows 0 .. 0");
  panel.expect_writes({"....", "...."});
}

TEST(StrictPanel, PrimitivesKeepToTheClipOfARecorder) {
  StrictPanel panel(write_panel(6, 4, 8));
  auto pen = panel.recorder(1).clipped(2, 1, 3, 2);
  ASSERT_TRUE(intaglio::raster::fill_rect(pen, {-100, -100, 1000, 1000}).ok());
  panel.expect_writes({"......",  //
                       "..###.",  //
                       "..###.",  //
                       "......"});
}

TEST(StrictPanel, PixelDrawnTwiceIsReportedUnlessAllowed) {
  StrictPanel panel(write_panel(6, 2, 8));
  Recorder pen = panel.recorder(1);
  pen.span(1, 1, 4);
  EXPECT_NONFATAL_FAILURE(pen.span(1, 2, 6), "drawn twice in a frame: (2, 1), 2 pixels in this span");
  panel.expect_writes({"......", ".#22##"});
  panel.forget_writes();
  pen.span(1, 0, 6);

  StrictPanel lenient(write_panel(6, 2, 8), {.drawing_twice = true});
  Recorder other = lenient.recorder(1);
  other.span(0, 0, 3);
  other.span(0, 0, 3);
  lenient.expect_writes({"222...", "......"});
}

TEST(StrictPanel, RectangleWrittenTwiceIsReported) {
  StrictPanel panel(write_panel(4, 2, 8));
  const std::vector<std::uint8_t> pixels{1, 2, 3, 4};
  ASSERT_TRUE(panel.write({0, 0, 2, 2}, pixels, 2).ok());
  EXPECT_NONFATAL_FAILURE(panel.write({1, 0, 2, 2}, pixels, 2).ignore(),
                          "2 pixels of the rectangle at (1, 0) were written twice");
  panel.expect_picture({"#12.", "334."});
}

TEST(StrictPanel, RefusedCallsAreReported) {
  StrictPanel panel(write_panel(8, 8, 8, 4, 2));
  const std::vector<std::uint8_t> pixels(64);
  EXPECT_NONFATAL_FAILURE(panel.write({0, 0, 9, 2}, pixels, 9).ignore(), "refused a call: invalid rectangle");
  EXPECT_NONFATAL_FAILURE(panel.write({2, 0, 4, 2}, pixels, 4).ignore(),
                          "refused a call: misaligned rectangle");
  EXPECT_NONFATAL_FAILURE(panel.write({0, 0, 4, 2}, pixels, 3).ignore(), "refused a call: invalid stride");
  EXPECT_NONFATAL_FAILURE(panel.load_palette(std::span(pixels).first(4)).ignore(), "invalid palette");
  EXPECT_NONFATAL_FAILURE(panel.show(0, {}).ignore(), "refused a call: unsupported buffer");
}

TEST(StrictPanel, BytesOutsideABufferAreReported) {
  // The test writes where no test should, but inside memory that the panel owns.
  StrictPanel panel(scan_out_panel(4, 2, 8));
  std::uint8_t* const first = panel.buffer(1).data();
  first[-1] ^= 1U;
  EXPECT_NONFATAL_FAILURE(panel.check(),
                          "frame buffer 1 was written outside its pixels: byte 1 before its start");
  first[4] ^= 1U;
  EXPECT_NONFATAL_FAILURE(panel.check(), "byte 0 after the end of row 0");
  first[panel.buffer_stride() + 4] ^= 1U;
  EXPECT_NONFATAL_FAILURE(panel.check(), "byte 0 after its end");
  panel.check();
}

TEST(StrictPanel, ChangingAPresentedFrameIsReported) {
  StrictPanel panel(scan_out_panel(4, 2, 8));
  SwapChain<Indexed8> chain(panel);
  auto begun = chain.begin();
  const auto kept = begun.value().surface();
  kept.set(0, 0, 1);
  ASSERT_TRUE(chain.present(std::move(begun).value()).ok());
  kept.set(2, 1, 3);
  EXPECT_NONFATAL_FAILURE(panel.vblank(), "frame buffer 1 was changed after it had been presented");
  kept.set(3, 1, 3);
  EXPECT_NONFATAL_FAILURE(panel.check(), "1 of 8 pixels differ");  // While it is on display, too.
  // When another frame is on display, it may be drawn on again.
  ASSERT_TRUE(chain.present(chain.begin().value()).ok());
  panel.vblank();
  kept.set(0, 0, 9);
  panel.check();
}

TEST(StrictPanel, AFrameShownAgainIsStillPresented) {
  StrictPanel panel(scan_out_panel(4, 2, 8));
  for (int n = 0; n < 2; ++n) {
    ASSERT_TRUE(panel.show(1, {}).ok());
    panel.vblank();
  }
  panel.buffer(1)[0] = 1;
  EXPECT_NONFATAL_FAILURE(panel.check(), "frame buffer 1 was changed after it had been presented");
}

TEST(StrictPanel, DrawingOnAPresentedFrameThroughARecorderIsReported) {
  StrictPanel panel(scan_out_panel(4, 2, 8));
  Recorder pen = panel.recorder(1, 1);
  pen.span(0, 0, 4);
  ASSERT_TRUE(panel.show(1, {}).ok());
  EXPECT_NONFATAL_FAILURE(pen.span(1, 0, 4),
                          "pixel (0, 1) was drawn on frame buffer 1 after it had been presented");
  panel.expect_picture({"....", "...."});
  panel.vblank();
  panel.expect_picture({"####", "...."});
}

TEST(StrictPanel, AFrameNeverDisplayedIsReportedUnlessAllowed) {
  StrictPanel panel(scan_out_panel(4, 2, 8));
  ASSERT_TRUE(panel.show(1, {}).ok());
  EXPECT_NONFATAL_FAILURE(panel.show(0, {}).ignore(), "the frame in buffer 1 was never displayed");
  StrictPanel lenient(scan_out_panel(4, 2, 8), {.skipping_frames = true});
  ASSERT_TRUE(lenient.show(1, {}).ok());
  ASSERT_TRUE(lenient.show(0, {}).ok());
}

TEST(StrictPanel, RecorderOfABufferThatDoesntExistIsReported) {
  const auto panel = std::make_unique<StrictPanel>(scan_out_panel(4, 2, 8));
  EXPECT_NONFATAL_FAILURE(static_cast<void>(panel->recorder(1, 2)), "there is no frame buffer 2");
}

TEST(StrictPanel, FaultsCanBeInjected) {
  StrictPanel panel(write_panel(4, 2, 8));
  std::vector<std::uint8_t> memory(8, 1);
  FrameWriter<Indexed8> writer(panel, memory);
  panel.fail_next({Error::bus, Part::bus});
  EXPECT_EQ(writer.present(writer.begin().value()),
            intaglio::Status(intaglio::Error::device, intaglio::Argument::panel));
  panel.expect_picture({"....", "...."});
  // What couldn't be sent is owed.
  ASSERT_TRUE(writer.present(writer.begin().value(), {}, std::span<const intaglio::linear::Rect>{}).ok());
  panel.expect_picture({"####", "####"});
}

TEST(StrictPanel, AWholeProgramOfGoodMannersPasses) {
  StrictPanel panel(scan_out_panel(13, 3, 1));
  SwapChain<Indexed1> chain(panel);
  for (int n = 0; n < 4; ++n) {
    auto begun = chain.begin();
    ASSERT_TRUE(begun.ok());
    const auto surface = begun.value().surface();
    for (int x = 0; x < 13; ++x) surface.set(x, n % 3, static_cast<unsigned>(x % 2));
    const std::vector<std::uint8_t> palette{0, 0, 0, static_cast<std::uint8_t>(n), 255, 255};
    ASSERT_TRUE(chain.present(std::move(begun).value(), palette).ok());
    ASSERT_TRUE(chain.wait_until_shown().ok());
    EXPECT_EQ(panel.palette()[3], n);
  }
  panel.expect_picture({".#.#.#.#.#.#.",  //
                        ".#.#.#.#.#.#.",  //
                        "............."});
}

}  // namespace
