// SPDX-License-Identifier: MIT
//
// Drawing text that is centred in a box, ends at a place or stands on a base line.
//
// Rule: each line is what `draw_text` draws, from where `aligned_lines.hpp` says. The box is where the text
// stands; what it doesn't hold is drawn, too, and cut off by the sink's clip alone.
#pragma once

#include <intaglio/text/aligned_lines.hpp>
#include <intaglio/text/draw_text.hpp>

#include <string_view>

namespace intaglio::text {

/// Draws a UTF-8 text aligned in `box`, or at a point, which is a box without extent: {x, y} with `centre`
/// and `middle` is the text's middle, with `left` and `alphabetic` where its base line begins. A text beyond
/// 2^21 pixels wide or high stands as if it were that large. Errors: rectangle (the box is outside the
/// domain), rule (no such alignment or base line), font (empty); nothing is drawn then. Cost: that of
/// `draw_text` for each line, which is measured first unless it is above the clip or begins at the left;
/// `middle` and `bottom` take a step for each byte on top.
template <raster::SpanSink S>
Status draw_aligned_text(S&& sink, const Font& font, const linear::Rect& box, Alignment alignment,
                         Baseline baseline, std::string_view utf8) {
  if (!linear::in_domain(box)) return {Error::out_of_domain, Argument::rectangle};
  if (alignment > Alignment::right || baseline > Baseline::bottom)
    return {Error::out_of_range, Argument::rule};
  if (font.empty()) return {Error::empty, Argument::font};
  const linear::Rect clip = sink.clip();
  AlignedLines lines(font, box, alignment, baseline, utf8, clip);
  linear::Point top_left;
  for (std::string_view line; lines.next(top_left, line);) {
    GlyphRun run(font, top_left, line, clip);
    for (GlyphPart part; run.next(part);) detail::draw_part(sink, part);
  }
  return {};
}

}  // namespace intaglio::text
