// SPDX-License-Identifier: MIT
#include <intaglio/text/glyph_run.hpp>
#include <intaglio/text/utf8.hpp>

namespace intaglio::text {

GlyphRun::GlyphRun(const Font& font, linear::Point top_left, std::string_view utf8,
                   const linear::Rect& clip) noexcept
    : font_(font), rest_(utf8), clip_(clip), pen_(top_left), left_(top_left.x) {
  if (clip_.empty()) rest_ = {};
}

bool GlyphRun::next(GlyphPart& part) noexcept {
  while (!rest_.empty()) {
    if (pen_.y - glyph_overhang >= clip_.bottom()) return false;
    if (pen_.x - glyph_overhang >= clip_.right() || pen_.y + glyph_reach <= clip_.y) skip_line();
    if (rest_.empty()) return false;
    const char32_t code = take_code_point(rest_);
    if (code == U'\n') {
      pen_ = {left_, pen_.y + font_.line_height()};
      continue;
    }
    const Glyph& glyph = font_.glyph(code);
    const linear::Rect box{pen_.x + glyph.left, pen_.y + glyph.top, glyph.width, glyph.height};
    pen_.x += glyph.advance;
    part.visible = linear::intersect(box, clip_);
    if (part.visible.empty()) continue;
    part.row_bytes = glyph.row_bytes();
    part.rows = font_.tables().rows.data() + glyph.offset + (part.visible.y - box.y) * part.row_bytes;
    part.column = part.visible.x - box.x;
    return true;
  }
  return false;
}

/// Drops everything before the next '\n'. A byte of that value is never part of a longer sequence.
void GlyphRun::skip_line() noexcept {
  while (!rest_.empty() && rest_.front() != '\n') rest_.remove_prefix(1);
}

}  // namespace intaglio::text
