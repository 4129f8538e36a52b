// SPDX-License-Identifier: MIT
//
// Lays a text out and hands over, one after the other, the visible parts of its glyphs.
//
// Rule: the pen starts at the top left of the first line; each glyph's box stands where pen and glyph say,
// and the pen goes on by its advance; '\n' takes it back to the left, one line height down. What is handed
// over is cut to the clip rectangle, so the drawing that follows is bounded by the visible; lines above the
// clip and the rest of a line that left it at the right are passed over without looking glyphs up. This is
// the part of text drawing that doesn't depend on the sink: it exists once in a program.
//
// Bit budget: the pen starts in the domain (2^20), that of an aligned line within 5 * 2^20, stops there or
// within `glyph_overhang` + 255 of a clip edge (2^22 at most), and a box adds at most 128 + 255: below 2^23.
#pragma once

#include <intaglio/linear/rect.hpp>
#include <intaglio/text/font.hpp>

#include <cstdint>
#include <string_view>

namespace intaglio::text {

/// Furthest that a box can begin left of or above the pen.
inline constexpr int glyph_overhang = 128;
/// Furthest that a box can end below the top of the line.
inline constexpr int glyph_reach = 127 + 255;

/// A piece of a glyph's box: the pixels of `visible` that have a bit set.
struct GlyphPart {
  linear::Rect visible;      ///< Not empty, in the sink's coordinates, inside the clip.
  const std::uint8_t* rows;  ///< The row of bits at visible.y.
  int row_bytes;             ///< From a row of bits to the next.
  int column;                ///< The bit of the row at visible.x, counted from the left.
};

/// The visible glyphs of a text. Single pass. A line or a glyph that only just touches the clip may be cut to
/// nothing; such parts are not handed over.
class GlyphRun {
 public:
  /// `top_left` must be within 5 * 2^20, the font not empty; font and text must outlive the run.
  GlyphRun(const Font& font, linear::Point top_left, std::string_view utf8,
           const linear::Rect& clip) noexcept;

  /// Goes to the next visible glyph; false if there is none.
  [[nodiscard]] bool next(GlyphPart& part) noexcept;

 private:
  void skip_line() noexcept;

  const Font& font_;
  std::string_view rest_;
  linear::Rect clip_;
  linear::Point pen_;
  int left_;
};

}  // namespace intaglio::text
