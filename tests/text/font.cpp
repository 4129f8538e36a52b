// SPDX-License-Identifier: MIT
#include <intaglio/text/font.hpp>
#include <intaglio/text/measure.hpp>
#include <tests/text/test_font.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <intaglio_fonts/digits_16.hpp>
#include <intaglio_fonts/digits_28.hpp>
#include <intaglio_fonts/digits_48.hpp>
#include <intaglio_fonts/fixed_5x8.hpp>
#include <intaglio_fonts/fixed_6x13.hpp>
#include <intaglio_fonts/sans_11.hpp>
#include <string>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Size;
using intaglio::text::CodeRange;
using intaglio::text::Font;
using intaglio::text::FontTables;
using intaglio::text::Glyph;
using intaglio::text::measure;

TEST(Font, EveryCodePointIsFoundWhereTheRangesSay) {
  for (const Font* font : {&test_font::font, &intaglio::fonts::fixed_6x13, &intaglio::fonts::digits_16}) {
    const FontTables& tables = font->tables();
    std::vector<std::size_t> expected(0x110100, 0);
    for (const CodeRange& range : tables.ranges)
      for (std::uint32_t i = 0; i < range.count; ++i) expected[range.first + i] = range.glyph + i;
    std::size_t wrong = 0;
    for (std::uint32_t code = 0; code < expected.size(); ++code) {
      if (&font->glyph(code) != &tables.glyphs[expected[code]]) ++wrong;
      if (font->has(code) != (expected[code] != 0)) ++wrong;
    }
    EXPECT_EQ(wrong, 0U);
    EXPECT_FALSE(font->has(0xFFFFFFFF));
  }
}

TEST(Font, InconsistentTablesAreRefusedAndNamed) {
  constexpr Status metric{Error::malformed, Argument::font};
  constexpr Status glyph{Error::malformed, Argument::glyph};
  constexpr Status range{Error::malformed, Argument::table};
  const auto changed = [](auto change) {
    FontTables tables = test_font::tables;
    change(tables);
    return Font::over(tables).status();
  };
  EXPECT_EQ(changed([](FontTables& t) { t.line_height = 0; }), metric);
  EXPECT_EQ(changed([](FontTables& t) { t.line_height = 256; }), metric);
  EXPECT_EQ(changed([](FontTables& t) { t.ascent = -1; }), metric);
  EXPECT_EQ(changed([](FontTables& t) { t.ascent = t.line_height + 1; }), metric);
  EXPECT_EQ(changed([](FontTables& t) { t.glyphs = {}; }), glyph);
  EXPECT_EQ(changed([](FontTables& t) { t.rows = t.rows.first(24); }), glyph);
  EXPECT_EQ(changed([](FontTables& t) { t.rows = {}; }), glyph);
  EXPECT_EQ(changed([](FontTables& t) { t.glyphs = t.glyphs.first(6); }), range);

  const auto with_ranges = [&](const std::vector<CodeRange>& ranges) {
    return changed([&](FontTables& t) { t.ranges = ranges; });
  };
  EXPECT_EQ(with_ranges({{'A', 0, 1}}), range);
  EXPECT_EQ(with_ranges({{'B', 1, 1}, {'A', 1, 2}}), range);
  EXPECT_EQ(with_ranges({{'A', 2, 1}, {'B', 1, 2}}), range);
  EXPECT_EQ(with_ranges({{0x10FFFF, 2, 1}}), range);
  EXPECT_EQ(with_ranges({{0x110000, 1, 1}}), range);
  EXPECT_EQ(with_ranges({{0xFFFFFFFF, 1, 1}}), range);
  EXPECT_EQ(with_ranges({{'A', 1, 7}}), range);
  EXPECT_TRUE(with_ranges({{'A', 1, 1}, {'B', 1, 1}, {0x10FFFF, 1, 6}}).ok());
  EXPECT_TRUE(with_ranges({}).ok());
  const std::vector<Glyph> many(65536);
  EXPECT_EQ(changed([&](FontTables& t) { t.glyphs = many; }), glyph);
}

TEST(Measure, WidthIsTheWidestLineAndHeightCountsTheLines) {
  const Font& font = test_font::font;
  EXPECT_EQ(measure(font, ""), (Size{0, 7}));
  EXPECT_EQ(measure(font, "A"), (Size{12, 7}));
  EXPECT_EQ(measure(font, "A\n"), (Size{12, 14}));
  EXPECT_EQ(measure(font, "C\nA C\nB"), (Size{21, 21}));
  EXPECT_EQ(measure(font, "\xFF\xC3"), (Size{18, 7}));  // two replacement boxes
  EXPECT_EQ(measure(font, "z"), (Size{9, 7}));          // one missing glyph
  EXPECT_EQ(measure(Font{}, "A"), (Size{0, 0}));
}

TEST(Measure, SaturatesInsteadOfOverflowing) {
  constexpr int limit = 1 << 21;
  const std::string e_acute = "\xC3\xA9";
  std::string wide;
  for (int i = 0; i < limit / 255 + 2; ++i) wide += e_acute;
  EXPECT_EQ(measure(test_font::font, wide).width, limit);
  EXPECT_EQ(measure(test_font::font, std::string(limit / 7 + 2, '\n')).height, limit);
}

TEST(GeneratedFonts, HaveTheirStatedMetrics) {
  using namespace intaglio::fonts;
  EXPECT_EQ(fixed_6x13.line_height(), 13);
  EXPECT_EQ(fixed_6x13.ascent(), 11);
  EXPECT_EQ(fixed_5x8.line_height(), 8);
  EXPECT_EQ(measure(fixed_6x13, "0123456789"), (Size{60, 13}));
  EXPECT_EQ(measure(fixed_5x8, "W\xC3\xB6rld \xE2\x86\x92"), (Size{35, 8}));
  EXPECT_LT(measure(sans_11, "iiii").width, measure(sans_11, "WWWW").width);
  EXPECT_EQ(measure(digits_28, "0").width, measure(digits_28, "8").width);
  EXPECT_LT(digits_28.line_height(), 28);
  EXPECT_LT(digits_28.line_height(), digits_48.line_height());
  for (const char32_t code : {U'\u00B0', U'\u00E9', U'\u2192', U'\u20AC'}) EXPECT_TRUE(sans_11.has(code));
}

// Bits of 6x13 as its designer drew them: the letter R.
TEST(GeneratedFonts, TheLetterRHasItsShape) {
  const Font& font = intaglio::fonts::fixed_6x13;
  const Glyph& r = font.glyph(U'R');
  ASSERT_EQ(r.width, 5);
  ASSERT_EQ(r.height, 9);
  EXPECT_EQ(r.top, 2);
  constexpr std::array<unsigned, 9> expected{0b11110, 0b10001, 0b10001, 0b10001, 0b11110,
                                             0b10100, 0b10010, 0b10001, 0b10001};
  for (std::size_t row = 0; row < expected.size(); ++row)
    EXPECT_EQ(font.tables().rows[r.offset + row] >> 3U, expected[row]) << row;
}

}  // namespace
