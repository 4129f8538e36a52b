// SPDX-License-Identifier: MIT
#include <intaglio/text/aligned_lines.hpp>
#include <intaglio/text/glyph_run.hpp>
#include <intaglio/text/measure.hpp>

#include <cstddef>

namespace intaglio::text {
namespace {

/// The height of a text, as `measure` says.
int height_of(const Font& font, std::string_view utf8) noexcept {
  constexpr int limit = 2 * linear::coordinate_limit;
  int height = font.line_height();
  for (const char c : utf8)
    if (c == '\n' && height < limit) height += font.line_height();
  return height < limit ? height : limit;
}

/// Takes the first line off the front of a text, without its '\n'. Tells whether there was one.
bool take_line(std::string_view& rest, std::string_view& line) noexcept {
  const char* const begin = rest.data();
  const char* const end = begin + rest.size();
  const char* at = begin;
  while (at != end && *at != '\n') ++at;
  const bool more = at != end;
  line = {begin, static_cast<std::size_t>(at - begin)};
  if (more) ++at;
  rest = {at, static_cast<std::size_t>(end - at)};
  return more;
}

int top_of(const Font& font, const linear::Rect& box, Baseline baseline, std::string_view utf8) noexcept {
  switch (baseline) {
    case Baseline::alphabetic:
      return box.bottom() - font.ascent();
    case Baseline::middle:
      return box.y + ((box.height - height_of(font, utf8)) >> 1);
    case Baseline::bottom:
      return box.bottom() - height_of(font, utf8);
    default:
      return box.y;
  }
}

}  // namespace

AlignedLines::AlignedLines(const Font& font, const linear::Rect& box, Alignment alignment, Baseline baseline,
                           std::string_view utf8, const linear::Rect& clip) noexcept
    : font_(font),
      box_(box),
      clip_(clip),
      rest_(utf8),
      top_(top_of(font, box, baseline, utf8)),
      alignment_(alignment) {}

bool AlignedLines::next(linear::Point& top_left, std::string_view& line) noexcept {
  while (more_ && top_ - glyph_overhang < clip_.bottom()) {
    more_ = take_line(rest_, line);
    const int top = top_;
    top_ += font_.line_height();
    if (top + glyph_reach <= clip_.y) continue;
    const int room = alignment_ == Alignment::left ? 0 : box_.width - measure(font_, line).width;
    top_left = {box_.x + (alignment_ == Alignment::centre ? room >> 1 : room), top};
    return true;
  }
  return false;
}

}  // namespace intaglio::text
