// SPDX-License-Identifier: MIT
//
// Oracle for text: every pixel of every glyph, one bit at a time, with 64-bit coordinates and no clipping
// until the very end; code points are looked up by walking all ranges.
#pragma once

#include <intaglio/text/font.hpp>
#include <tests/oracle/utf8.hpp>

#include <cstdint>
#include <map>
#include <string_view>
#include <utility>

namespace oracle {

/// How often a text touches each pixel inside left <= x < right, top <= y < bottom.
struct Window {
  std::int64_t left, top, right, bottom;
};

using Touches = std::map<std::pair<std::int64_t, std::int64_t>, int>;  // (y, x) -> times

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
    std::size_t index = 0;
    for (const auto& range : font.ranges)
      for (std::uint32_t i = 0; i < range.count; ++i)
        if (range.first + i == code) index = range.glyph + i;
    const auto& glyph = font.glyphs[index];
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

}  // namespace oracle
