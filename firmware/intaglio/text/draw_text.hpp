// SPDX-License-Identifier: MIT
//
// Drawing text.
//
// Rule: the pixels of the text are the set bits of its glyphs' boxes (see `glyph_run.hpp` for where they
// stand); the clipped picture is the unclipped one restricted to the clip. Each box is drawn in strips of
// eight columns, a byte of its bits a row: with a cursor where the sink has one, else one span a run of bits.
// Each pixel of a glyph is drawn once; boxes of neighbours overlap only where a font's glyphs overhang their
// advance (italics), none of the fonts generated here does with upright text of its character set.
#pragma once

#include <intaglio/raster/sink.hpp>
#include <intaglio/text/glyph_run.hpp>

#include <cstdint>
#include <string_view>

namespace intaglio::text {
namespace detail {

/// The bits of at most eight columns, in a word whose most significant bit is the strip's leftmost pixel.
struct GlyphStrip {
  linear::Rect area{};
  const std::uint8_t* byte = nullptr;
  int row_bytes = 0;
  unsigned shift = 0;      ///< Columns of the byte that lie left of the strip, and the 24 bits above a byte.
  std::uint32_t mask = 0;  ///< The strip's columns.

  [[nodiscard]] std::uint32_t bits() const noexcept { return std::uint32_t{*byte} << shift & mask; }
};

inline constexpr std::uint32_t leftmost = std::uint32_t{1} << 31U;

/// Columns at the front of the word that hold `value`.
[[nodiscard]] constexpr int run_length(std::uint32_t bits, bool value) noexcept {
  int length = 0;
  for (; ((bits & leftmost) != 0) == value; bits <<= 1U) ++length;
  return length;
}

template <raster::SpanSink S>
void draw_strip(S& sink, GlyphStrip strip) {
  for (int row = 0; row < strip.area.height; ++row, strip.byte += strip.row_bytes) {
    int x = strip.area.x;
    for (std::uint32_t bits = strip.bits(); bits != 0;) {
      const int gap = run_length(bits, false);
      bits <<= static_cast<unsigned>(gap);
      const int run = run_length(bits, true);  // at most 8: the bits below the strip are clear
      bits <<= static_cast<unsigned>(run);
      sink.span(strip.area.y + row, x + gap, x + gap + run);
      x += gap + run;
    }
  }
}

template <raster::CursorSink S>
void draw_strip(S& sink, GlyphStrip strip) {
  auto row_start = sink.cursor(strip.area.x, strip.area.y);
  for (int row = strip.area.height; row > 0; --row, strip.byte += strip.row_bytes, row_start.down()) {
    auto at = row_start;
    for (std::uint32_t bits = strip.bits(); bits != 0; bits <<= 1U, at.right())
      if ((bits & leftmost) != 0) at.put();
  }
}

template <raster::SpanSink S>
void draw_part(S& sink, const GlyphPart& part) {
  const int right = part.visible.right();
  int column = part.column;
  for (int x = part.visible.x; x < right;) {
    const int within = column & 7;
    const int width = right - x < 8 - within ? right - x : 8 - within;
    draw_strip(sink, GlyphStrip{.area = {x, part.visible.y, width, part.visible.height},
                                .byte = part.rows + (column >> 3),
                                .row_bytes = part.row_bytes,
                                .shift = 24U + static_cast<unsigned>(within),
                                .mask = ~std::uint32_t{0} << (32U - static_cast<unsigned>(width))});
    x += width;
    column += width;
  }
}

}  // namespace detail

/// Draws a UTF-8 text; `top_left` is the top left of the first line (the base line is `font.ascent()` rows
/// down). '\n' starts a new line; what has no glyph, and each malformed sequence, draws the replacement box.
/// Errors: point (outside the domain), font (empty). Cost: the visible pixels of the glyphs' boxes, and a
/// step for each character of the visible lines up to the right edge.
template <raster::SpanSink S>
Status draw_text(S&& sink, const Font& font, linear::Point top_left, std::string_view utf8) {
  if (!linear::in_domain(top_left)) return {Error::out_of_domain, Argument::point};
  if (font.empty()) return {Error::empty, Argument::font};
  GlyphRun run(font, top_left, utf8, sink.clip());
  for (GlyphPart part; run.next(part);) detail::draw_part(sink, part);
  return {};
}

}  // namespace intaglio::text
