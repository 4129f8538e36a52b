// SPDX-License-Identifier: MIT
#include <intaglio/text/draw_aligned_text.hpp>
#include <intaglio/text/measure.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/oracle/text.hpp>
#include <tests/text/test_font.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace intaglio::text;
using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Rect;
using oracle::RecordingSink;

constexpr int edge = 1 << 20;

std::optional<int> halves_above(Baseline baseline) {
  if (baseline == Baseline::alphabetic) return {};
  return baseline == Baseline::top ? 0 : baseline == Baseline::middle ? 1 : 2;
}

// How many pixels are seen; -1 if they aren't the oracle's.
int seen(const Rect& box, Alignment alignment, Baseline baseline, std::string_view text, const Rect& clip) {
  RecordingSink sink(clip);
  EXPECT_TRUE(draw_aligned_text(sink, test_font::font, box, alignment, baseline, text).ok());
  const auto expected =
      oracle::aligned_text_pixels(oracle::utf8_by_definition(), test_font::tables, box.x, box.y, box.width,
                                  box.height, static_cast<int>(alignment), halves_above(baseline), text,
                                  {clip.x, clip.y, clip.x + clip.width, clip.y + clip.height});
  if (!sink.violation().empty()) return -1;
  for (int y = clip.y; y < clip.y + clip.height; ++y)
    for (int x = clip.x; x < clip.x + clip.width; ++x) {
      const auto found = expected.find({y, x});
      if (sink.writes(x, y) != (found == expected.end() ? 0 : found->second)) return -1;
    }
  return sink.touched();
}

TEST(DrawAlignedText, EqualsTheOracleForAllAlignments) {
  oracle::Random random(2601);
  int shown = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string text;
    for (int n = random.between(0, 14); n > 0; --n)
      text += random.between(0, 9) == 0 ? static_cast<char>(random.between(-128, 127))
                                        : "ABC \nC"[random.between(0, 5)];
    const Rect box{random.between(-30, 30), random.between(-30, 30), random.between(-9, 60),
                   random.between(-9, 40)};
    const int drawn = seen(
        box, static_cast<Alignment>(i % 3), static_cast<Baseline>(i % 4), text,
        {random.between(-30, 10), random.between(-30, 10), random.between(0, 60), random.between(0, 50)});
    ASSERT_GE(drawn, 0) << random.seed_text() << ", text " << i;
    shown += drawn > 0 ? 1 : 0;
  }
  EXPECT_GT(shown, 500);  // else the places were chosen badly
}

TEST(DrawAlignedText, EqualsTheOracleAtTheEdgesOfTheDomain) {
  const std::string wide(180'000, 'A');  // 12 px each: more than 2^21
  std::string high(400'000, '\n');       // 7 px each
  high += "CC";
  int shown = 0;
  for (const int x : {-edge, edge})
    for (const int y : {-edge, edge})
      for (const int extent : {0, 2 * edge, -2 * edge})
        for (int which = 0; which < 12; ++which) {
          const Rect box{x, y, extent, extent};
          const auto alignment = static_cast<Alignment>(which % 3);
          const auto baseline = static_cast<Baseline>(which % 4);
          for (const Rect& clip : {Rect{x < 0 ? x : x - 20, y < 0 ? y : y - 20, 20, 20}, Rect{-8, -8, 20, 20},
                                   Rect{-edge, edge - 9, 9, 9}}) {
            const int drawn = seen(box, alignment, baseline, "AC\nCC", clip);
            ASSERT_GE(drawn, 0);
            shown += drawn;
          }
        }
  EXPECT_GT(shown, 0);
  for (const Alignment alignment : {Alignment::left, Alignment::centre, Alignment::right})
    EXPECT_GT(seen({0, 0, 0, 0}, alignment, Baseline::top, wide, {-8, -8, 20, 20}), 0);
  for (const Baseline baseline : {Baseline::top, Baseline::middle, Baseline::alphabetic, Baseline::bottom})
    EXPECT_GE(seen({0, edge, 0, 0}, Alignment::right, baseline, high, {-20, edge - 20, 20, 20}), 0);
}

// By hand: C is 3 columns of a 5 px advance, one to the right of the pen; lines are 7 px, 5 above the base.
TEST(DrawAlignedText, StandsWhereThePointIs) {
  const auto corner = [](Alignment alignment, Baseline baseline) {
    RecordingSink sink({-30, -30, 60, 60});
    EXPECT_TRUE(draw_aligned_text(sink, test_font::font, {0, 0}, alignment, baseline, "C\nCC").ok());
    for (int y = -30; y < 30; ++y)
      for (int x = -30; x < 30; ++x)
        if (sink.writes(x, y) != 0) return intaglio::linear::Point{x, y};
    return intaglio::linear::Point{};
  };
  using intaglio::linear::Point;
  EXPECT_EQ(corner(Alignment::left, Baseline::top), (Point{1, 0}));
  EXPECT_EQ(corner(Alignment::centre, Baseline::middle), (Point{-2, -7}));  // floor(-5/2) + 1, -14/2
  EXPECT_EQ(corner(Alignment::right, Baseline::alphabetic), (Point{-4, -5}));
  EXPECT_EQ(corner(Alignment::right, Baseline::bottom), (Point{-4, -14}));
}

TEST(DrawAlignedText, AtTheTopLeftIsDrawText) {
  RecordingSink aligned({-10, -10, 80, 60});
  RecordingSink plain({-10, -10, 80, 60});
  constexpr std::string_view text = "AB C\xC3\xA9\n\xE2\x82\xAC\xFF\nCBA\n";
  ASSERT_TRUE(
      draw_aligned_text(aligned, test_font::font, {3, 4, 9, 9}, Alignment::left, Baseline::top, text).ok());
  ASSERT_TRUE(draw_text(plain, test_font::font, {3, 4}, text).ok());
  EXPECT_GT(plain.touched(), 0);
  EXPECT_EQ(aligned.all_writes(), plain.all_writes());
}

TEST(DrawAlignedText, NeverReadsPastTheEndOfTheText) {
  const std::string text = "A\xE2\x82\xAC\n\nC";
  for (std::size_t length = 0; length <= text.size(); ++length) {
    const std::vector<char> exact(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_GE(seen({0, 0, 20, 20}, Alignment::right, Baseline::bottom, {exact.data(), exact.size()},
                   {-200, -200, 400, 400}),
              0);
  }
  EXPECT_EQ(seen({}, Alignment::centre, Baseline::middle, {}, {-9, -9, 20, 20}), 0);
}

TEST(DrawAlignedText, BadArgumentsAreNamedAndNothingIsDrawn) {
  RecordingSink sink({0, 0, 40, 40});
  const auto draw = [&](const Rect& box, Alignment alignment, Baseline baseline, const Font& font) {
    return draw_aligned_text(sink, font, box, alignment, baseline, "CAC");
  };
  const Status bad_box{Error::out_of_domain, Argument::rectangle};
  for (const Rect& box :
       {Rect{edge + 1, 0}, Rect{0, INT_MIN}, Rect{0, 0, INT_MAX, 0}, Rect{0, 0, 0, -2 * edge - 1}})
    EXPECT_EQ(draw(box, Alignment::left, Baseline::top, test_font::font), bad_box);
  const Status bad_rule{Error::out_of_range, Argument::rule};
  EXPECT_EQ(draw({}, static_cast<Alignment>(3), Baseline::top, test_font::font), bad_rule);
  EXPECT_EQ(draw({}, Alignment::left, static_cast<Baseline>(4), test_font::font), bad_rule);
  EXPECT_EQ(draw({}, Alignment::left, Baseline::top, Font{}), (Status{Error::empty, Argument::font}));
  EXPECT_EQ(sink.spans(), 0);
}

}  // namespace
