// SPDX-License-Identifier: MIT
//
// A hand-made font with what real ones rarely have: boxes wider than two bytes, boxes that begin left of the
// pen and above the line, bits set beyond the width, an advance of 0.
#pragma once

#include <intaglio/text/font.hpp>

#include <array>
#include <cstdint>

namespace test_font {

using intaglio::text::CodeRange;
using intaglio::text::Font;
using intaglio::text::FontTables;
using intaglio::text::Glyph;

inline constexpr std::array<std::uint8_t, 25> rows{
    0xFF, 0x99, 0xFF,                                // 0: box 8x3
    0xA5, 0x0F, 0xF1, 0xFF, 0xFF, 0xFF,              // 3: 20x2, bits beyond the width set
    0x81, 0xFF, 0x7F, 0x55,                          // 9: 9x2
    0x80, 0x40, 0x20, 0xFF,                          // 13: 3x4
    0xC0, 0x01, 0x33, 0x30, 0x00, 0x01, 0xFF, 0xFF,  // 17: 16x4
};
inline constexpr std::array<Glyph, 7> glyphs{{
    {0, 8, 3, 0, 1, 9},           // replacement
    {3, 20, 2, -7, -3, 12},       // A: hangs over at the left and above
    {9, 9, 2, 3, 4, 0},           // B: no advance
    {13, 3, 4, 1, 0, 5},          // C
    {0, 0, 0, 0, 0, 4},           // space
    {17, 16, 4, -128, 127, 255},  // e acute: as far off as a box can be
    {17, 16, 4, 127, -128, 1},    // euro
}};
inline constexpr std::array<CodeRange, 4> ranges{{{0x20, 1, 4}, {'A', 3, 1}, {0xE9, 1, 5}, {0x20AC, 1, 6}}};
inline constexpr FontTables tables{ranges, glyphs, rows, 7, 5};
inline constexpr Font font = Font::over(tables).value();
static_assert(Font::over(tables).ok());

}  // namespace test_font
