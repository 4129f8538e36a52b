// SPDX-License-Identifier: MIT
//
// Oracle for text: every pixel of every glyph, one bit at a time, with 64-bit coordinates and no clipping
// until the very end; code points are looked up by walking all ranges.
#pragma once

#include <intaglio/text/font.hpp>
#include <tests/oracle/utf8.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace oracle {

/// How often a text touches each pixel inside left <= x < right, top <= y < bottom.
struct Window {
  std::int64_t left, top, right, bottom;
};

using Touches = std::map<std::pair<std::int64_t, std::int64_t>, int>;  // (y, x) -> times

inline const intaglio::text::Glyph& glyph_of(const intaglio::text::FontTables& font, std::uint32_t code) {
  std::size_t index = 0;
  for (const auto& range : font.ranges)
    for (std::uint32_t i = 0; i < range.count; ++i)
      if (range.first + i == code) index = range.glyph + i;
  return font.glyphs[index];
}

inline Touches text_pixels(const Utf8& utf8, const intaglio::text::FontTables& font, std::int64_t x0,
                           std::int64_t y0, std::string_view text, const Window& window) {
  Touches touches;
  std::int64_t x = x0;
  std::int64_t y = y0;
  for (const std::uint32_t code : utf8.decode(text)) {
    if (code == 10) {
      x = x0;
      y += font.line_height;
      continue;
    }
    const auto& glyph = glyph_of(font, code);
    const std::size_t stride = (std::size_t{glyph.width} + 7U) / 8U;
    for (std::size_t row = 0; row < glyph.height; ++row)
      for (std::size_t column = 0; column < glyph.width; ++column) {
        const unsigned byte = font.rows[glyph.offset + row * stride + column / 8];
        if (((byte >> (7 - column % 8)) & 1) == 0) continue;
        const std::int64_t px = x + glyph.left + static_cast<std::int64_t>(column);
        const std::int64_t py = y + glyph.top + static_cast<std::int64_t>(row);
        if (px >= window.left && px < window.right && py >= window.top && py < window.bottom)
          ++touches[{py, px}];
      }
    x += glyph.advance;
  }
  return touches;
}

/// The same of a text in a box of w x h at (x0, y0). Of the room that is left beside a line, `across` halves
/// are to its left; of that above and below the text, `down` halves above it. Without `down`, the first base
/// line is on the box's lower side.
inline Touches aligned_text_pixels(const Utf8& utf8, const intaglio::text::FontTables& font, std::int64_t x0,
                                   std::int64_t y0, std::int64_t w, std::int64_t h, int across,
                                   std::optional<int> down, std::string_view text, const Window& window) {
  constexpr std::int64_t most = 1 << 21;
  const auto lines = std::count(text.begin(), text.end(), '\n') + 1;
  const auto part = [](std::int64_t room, int halves) {
    return static_cast<std::int64_t>(std::floor(static_cast<double>(room) * halves / 2));
  };
  std::int64_t y =
      down ? y0 + part(h - std::min(most, lines * font.line_height), *down) : y0 + h - font.ascent;
  Touches touches;
  for (std::ptrdiff_t i = 0; i < lines; ++i, y += font.line_height) {
    const std::string_view line = text.substr(0, text.find('\n'));
    std::int64_t width = 0;
    for (const std::uint32_t code : utf8.decode(line)) width += glyph_of(font, code).advance;
    const std::int64_t x = x0 + part(w - std::min(most, width), across);
    for (const auto& [pixel, times] : text_pixels(utf8, font, x, y, line, window)) touches[pixel] += times;
    text.remove_prefix(std::min(text.size(), line.size() + 1));
  }
  return touches;
}

}  // namespace oracle
