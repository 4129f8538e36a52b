// SPDX-License-Identifier: MIT
#include <intaglio/text/draw_text.hpp>
#include <tests/oracle/text.hpp>
#include <tests/text/test_font.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <intaglio_fonts/digits_28.hpp>
#include <intaglio_fonts/fixed_5x8.hpp>
#include <intaglio_fonts/fixed_6x13.hpp>
#include <intaglio_fonts/sans_11.hpp>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::text::draw_text;
using intaglio::text::Font;

/// Counts touches; notes a span outside the clip or empty.
class SpanRecorder {
 public:
  explicit SpanRecorder(const Rect& clip) : clip_(clip) {}
  [[nodiscard]] Rect clip() const { return clip_; }
  void span(int y, int begin, int end) {
    ++calls;
    if (begin >= end || begin < clip_.x || end > clip_.x + clip_.width || y < clip_.y ||
        y >= clip_.y + clip_.height)
      outside = true;
    for (int x = begin; x < end; ++x) ++touches[{y, x}];
  }

  oracle::Touches touches;
  int calls = 0;
  bool outside = false;

 private:
  Rect clip_;
};

/// The same, walked by a cursor.
class CursorRecorder : public SpanRecorder {
 public:
  using SpanRecorder::SpanRecorder;

  class Cursor {
   public:
    Cursor(CursorRecorder& sink, int x, int y) : sink_(&sink), x_(x), y_(y) {}
    void put() const { sink_->span(y_, x_, x_ + 1); }
    void left() { --x_; }
    void right() { ++x_; }
    void up() { y_ -= down_; }
    void down() { y_ += down_; }
    void turn_over() { down_ = -down_; }

   private:
    CursorRecorder* sink_;
    int x_, y_;
    int down_ = 1;
  };

  Cursor cursor(int x, int y) {
    const Rect c = clip();
    if (x < c.x || y < c.y || x >= c.x + c.width || y >= c.y + c.height) outside = true;
    return {*this, x, y};
  }
};
static_assert(intaglio::raster::SpanSink<SpanRecorder> && !intaglio::raster::CursorSink<SpanRecorder>);
static_assert(intaglio::raster::CursorSink<CursorRecorder>);

/// Returns how many pixels were seen.
template <class Sink>
std::size_t expect_oracle(const Font& font, Point at, std::string_view text, const Rect& clip) {
  Sink sink(clip);
  EXPECT_TRUE(draw_text(sink, font, at, text).ok());
  const oracle::Window window{clip.x, clip.y, std::int64_t{clip.x} + clip.width,
                              std::int64_t{clip.y} + clip.height};
  EXPECT_EQ(sink.touches,
            oracle::text_pixels(oracle::utf8_by_definition(), font.tables(), at.x, at.y, text, window))
      << "'" << text << "' at " << at.x << ", " << at.y << " clip " << clip.x << ", " << clip.y << ", "
      << clip.width << ", " << clip.height;
  EXPECT_FALSE(sink.outside);
  return sink.touches.size();
}

constexpr std::string_view sample =
    "AB C\xC3\xA9\n\xE2\x82\xAC\xFF"
    "CBA\n\n A\tB";

TEST(DrawText, EqualsTheOracleForEveryClipOfASmallWindow) {
  for (int left = -12; left < 40; left += 3)
    for (int top = -6; top < 30; top += 2)
      for (int width = 0; width < 20; width += 3)
        for (int height = 0; height < 14; height += 4) {
          const Rect clip{left, top, width, height};
          expect_oracle<SpanRecorder>(test_font::font, {2, 3}, sample, clip);
          expect_oracle<CursorRecorder>(test_font::font, {2, 3}, sample, clip);
          if (HasFailure()) return;
        }
}

TEST(DrawText, EqualsTheOracleAtRandomPlacesWithRandomText) {
  constexpr unsigned seed = 21;
  std::mt19937 random(seed);
  const std::array<const Font*, 5> fonts{&test_font::font, &intaglio::fonts::fixed_5x8,
                                         &intaglio::fonts::fixed_6x13, &intaglio::fonts::sans_11,
                                         &intaglio::fonts::digits_28};
  const auto pick = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  int seen = 0;
  for (int round = 0; round < 2000; ++round) {
    std::string text;
    for (int n = pick(0, 12); n > 0; --n) {
      constexpr std::string_view letters = "ABC 0123456789gjy%\n";
      text += pick(0, 9) == 0 ? static_cast<char>(pick(-128, 127))
                              : letters[static_cast<std::size_t>(pick(0, 18))];
    }
    const Font& font = *fonts[static_cast<std::size_t>(pick(0, 4))];
    const Rect clip{pick(-30, 30), pick(-30, 30), pick(0, 80), pick(0, 50)};
    if (expect_oracle<SpanRecorder>(font, {pick(-60, 60), pick(-60, 40)}, text, clip) > 0) ++seen;
    expect_oracle<CursorRecorder>(font, {pick(-60, 60), pick(-60, 40)}, text, clip);
    if (HasFailure()) FAIL() << "seed " << seed << " round " << round;
  }
  EXPECT_GT(seen, 200);  // else the places were chosen badly
}

// A text that begins at one edge of the domain and is seen at the other, and windows there.
TEST(DrawText, EqualsTheOracleAtTheEdgesOfTheDomain) {
  constexpr int edge = 1 << 20;
  for (const int x : {-edge, edge - 5, edge})
    for (const int y : {-edge, edge - 3, edge}) {
      for (const Rect& clip : {Rect{x - 9, y - 3, 40, 20}, Rect{x, y, 1, 1}, Rect{0, 0, 320, 240}}) {
        expect_oracle<SpanRecorder>(test_font::font, {x, y}, sample, clip);
        expect_oracle<CursorRecorder>(test_font::font, {x, y}, sample, clip);
      }
    }
  const std::string far_right(88000, 'A');  // 12 px each: more than 2^20 in all
  expect_oracle<SpanRecorder>(test_font::font, {-edge, 0}, far_right, {-5, -5, 30, 20});
}

TEST(DrawText, FarOffScreenTextMakesNoSpan) {
  SpanRecorder sink({0, 0, 320, 240});
  const std::string lines(1000, '\n');
  for (const Point at : {Point{-5000, 10}, Point{400, 10}, Point{10, -400}, Point{10, 400}})
    EXPECT_TRUE(draw_text(sink, test_font::font, at, "ABCABC").ok());
  EXPECT_TRUE(draw_text(sink, test_font::font, {0, 300}, lines + "A").ok());
  EXPECT_EQ(sink.calls, 0);
}

TEST(DrawText, EachPixelOfUprightFontsIsDrawnOnce) {
  std::string all;
  for (std::uint32_t code = 0x20; code < 0x100; ++code) all += oracle::encode_utf8(code) + "W";
  for (const Font* font : {&intaglio::fonts::fixed_5x8, &intaglio::fonts::fixed_6x13}) {
    SpanRecorder sink({-100, -100, 10000, 200});
    ASSERT_TRUE(draw_text(sink, *font, {0, 0}, all).ok());
    int most = 0;
    for (const auto& [pixel, times] : sink.touches) most = times > most ? times : most;
    EXPECT_EQ(most, 1);
  }
}

TEST(DrawText, MalformedAndMissingDrawTheReplacementBox) {
  SpanRecorder box({0, 0, 40, 20});
  SpanRecorder missing({0, 0, 40, 20});
  SpanRecorder malformed({0, 0, 40, 20});
  ASSERT_TRUE(draw_text(box, intaglio::fonts::fixed_6x13, {0, 0}, "\xEF\xBF\xBD").ok());
  ASSERT_TRUE(draw_text(missing, intaglio::fonts::fixed_6x13, {0, 0}, "\xF0\x9F\x98\x80").ok());
  ASSERT_TRUE(draw_text(malformed, intaglio::fonts::fixed_6x13, {0, 0}, "\xC3").ok());
  EXPECT_EQ(missing.touches, box.touches);
  EXPECT_EQ(malformed.touches, box.touches);
  EXPECT_EQ(box.touches.size(), 24U);  // the outline of a box 5 wide and 9 high
}

TEST(DrawText, NeverReadsPastTheEndOfTheText) {
  const std::string text = "A\xE2\x82\xAC";
  for (std::size_t length = 0; length <= text.size(); ++length) {
    const std::vector<char> exact(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length));
    expect_oracle<SpanRecorder>(test_font::font, {0, 0}, {exact.data(), exact.size()},
                                {-200, -200, 600, 600});
  }
  SpanRecorder sink({0, 0, 10, 10});
  EXPECT_TRUE(draw_text(sink, test_font::font, {0, 0}, {}).ok());
  EXPECT_EQ(sink.calls, 0);
}

TEST(DrawText, BadArgumentsAreNamedAndNothingIsDrawn) {
  constexpr int beyond = (1 << 20) + 1;
  SpanRecorder sink({0, 0, 100, 100});
  for (const Point at : {Point{beyond, 0}, Point{0, beyond}, Point{-beyond, 0}, Point{0, -beyond},
                         Point{INT_MIN, INT_MAX}, Point{INT_MAX, INT_MIN}})
    EXPECT_EQ(draw_text(sink, test_font::font, at, "A"), (Status{Error::out_of_domain, Argument::point}));
  EXPECT_EQ(draw_text(sink, Font{}, {0, 0}, "A"), (Status{Error::empty, Argument::font}));
  EXPECT_EQ(sink.calls, 0);
}

}  // namespace
