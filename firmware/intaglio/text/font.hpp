// SPDX-License-Identifier: MIT
//
// Bitmap fonts: three constant tables and two metrics.
//
// Rule: a font is a view on tables that the asset compiler wrote (`intaglio-assets font`). Code points are
// found in sorted ranges by binary search; a glyph is a box of bits with an advance. Glyph 0 is the
// replacement box: what a code point without a glyph draws, so a missing glyph is seen, not skipped.
// The tables are checked once, when the font is made (in a constant expression for generated ones), and a
// `Font` that exists is sound; drawing checks nothing again.
//
// Bit budget: a glyph is at most 255x255, its box at most 128 pixels off its origin, its advance 0..255. The
// rows of one font are at most 64 KiB, so a glyph fits eight bytes.
#pragma once

#include <intaglio/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::text {

/// One glyph. The box's rows follow each other from the top, each begins at a byte, the most significant bit
/// is the leftmost pixel; bits right of the width are not looked at.
struct Glyph {
  std::uint16_t offset = 0;  ///< First byte of the box in the font's rows.
  std::uint8_t width = 0;    ///< Columns of the box; 0 where there is nothing to draw (space).
  std::uint8_t height = 0;   ///< Rows of the box.
  std::int8_t left = 0;      ///< Column of the box, from the pen, to the right.
  std::int8_t top = 0;       ///< Row of the box, from the top of the line, downwards.
  std::uint8_t advance = 0;  ///< How far the pen goes.

  /// Bytes of a row of the box.
  [[nodiscard]] constexpr int row_bytes() const noexcept { return (width + 7) >> 3; }
};

/// Neighbouring code points with neighbouring glyphs.
struct CodeRange {
  std::uint32_t first = 0;  ///< First code point.
  std::uint16_t count = 0;  ///< How many, 1 or more.
  std::uint16_t glyph = 0;  ///< Glyph of the first.
};

/// What a font is made of. The memory must outlive the font.
struct FontTables {
  std::span<const CodeRange> ranges;   ///< Ascending, not overlapping.
  std::span<const Glyph> glyphs;       ///< Glyph 0 is the replacement box.
  std::span<const std::uint8_t> rows;  ///< Bits of all boxes.
  int line_height = 0;                 ///< From a line to the next, 1..255 px.
  int ascent = 0;                      ///< Rows above the base line, 0..line_height.
};

/// A checked font: a view, cheap to copy. A default-constructed one is empty and draws nothing.
class Font {
 public:
  constexpr Font() noexcept = default;

  /// The font of these tables. Cost: once through `ranges` and `glyphs`.
  /// Errors, all malformed: font (a metric out of range), glyph (none, more than 65535, or a box that leaves
  /// `rows`), table (a code range that is empty, out of order, above U+10FFFF or beyond the glyphs).
  [[nodiscard]] static constexpr Result<Font> over(const FontTables& tables) noexcept {
    if (tables.line_height < 1 || tables.line_height > 255 || tables.ascent < 0 ||
        tables.ascent > tables.line_height)
      return Status{Error::malformed, Argument::font};
    if (tables.glyphs.empty() || tables.glyphs.size() > 65535)
      return Status{Error::malformed, Argument::glyph};
    for (const Glyph& glyph : tables.glyphs) {
      const std::size_t bytes = static_cast<unsigned>(glyph.row_bytes()) * glyph.height;
      if (glyph.offset + bytes > tables.rows.size()) return Status{Error::malformed, Argument::glyph};
    }
    std::uint32_t free = 0;  // the first code point that no range so far has
    for (const CodeRange& range : tables.ranges) {
      if (range.count == 0 || range.first < free || range.first > 0x10FFFF ||
          range.first + range.count > 0x110000 ||
          std::size_t{range.glyph} + range.count > tables.glyphs.size())
        return Status{Error::malformed, Argument::table};
      free = range.first + range.count;
    }
    Font font;
    font.tables_ = tables;
    return font;
  }

  [[nodiscard]] constexpr bool empty() const noexcept { return tables_.glyphs.empty(); }
  /// From a line to the next, in pixels.
  [[nodiscard]] constexpr int line_height() const noexcept { return tables_.line_height; }
  /// Rows of a line above the base line.
  [[nodiscard]] constexpr int ascent() const noexcept { return tables_.ascent; }
  [[nodiscard]] constexpr const FontTables& tables() const noexcept { return tables_; }

  /// True if the font has a glyph of its own for the code point.
  [[nodiscard]] bool has(char32_t code) const noexcept { return glyph_index(code) != 0; }
  /// The glyph of the code point, the replacement box if there is none. The font must not be empty.
  [[nodiscard]] const Glyph& glyph(char32_t code) const noexcept { return tables_.glyphs[glyph_index(code)]; }

 private:
  /// Binary search through the ranges; 0 if none has the code point.
  [[nodiscard]] std::size_t glyph_index(char32_t code) const noexcept;

  FontTables tables_;
};

}  // namespace intaglio::text
