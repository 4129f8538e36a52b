// SPDX-License-Identifier: MIT
//
// Where the lines of a text stand that is aligned in a box or at a point.
//
// Rule: the text has the extents of `measure`. Its top is that of the box (`Baseline::top`), or as far down
// as its base line or its bottom is on the box's lower side, or in between; each line for itself begins at
// the left side, or as far right as it ends at the right side, or in between. In between is half of the way,
// rounded to the left and upwards. This is the part of drawing that doesn't depend on the sink.
//
// Bit budget: box sides within 3 * 2^20 and extents of text up to 2^21, so lines begin within 5 * 2^20 and
// glyphs, as in `glyph_run.hpp`, stay below 2^23. Worst known input: lines above the clip, which are neither
// measured nor laid out, but counted.
#pragma once

#include <intaglio/linear/rect.hpp>
#include <intaglio/text/font.hpp>

#include <cstdint>
#include <string_view>

namespace intaglio::text {

/// Where each line of a text stands between the left and the right side of a box.
enum class Alignment : std::uint8_t { left, centre, right };

/// What of a text lies where: its top on the upper side of a box, its middle in the box's middle, the base
/// line of its first line on the box's lower side (so letters stand on the row above it), or its bottom
/// there.
enum class Baseline : std::uint8_t { top, middle, alphabetic, bottom };

/// The lines of an aligned text that may be visible. Single pass.
class AlignedLines {
 public:
  /// The box must be in the domain, the font not empty; font and text must outlive the lines.
  AlignedLines(const Font& font, const linear::Rect& box, Alignment alignment, Baseline baseline,
               std::string_view utf8, const linear::Rect& clip) noexcept;

  /// Goes to the next line: its top left, and itself without the '\n'; false if there is none.
  [[nodiscard]] bool next(linear::Point& top_left, std::string_view& line) noexcept;

 private:
  const Font& font_;
  linear::Rect box_;
  linear::Rect clip_;
  std::string_view rest_;
  int top_;
  Alignment alignment_;
  bool more_ = true;
};

}  // namespace intaglio::text
