// SPDX-License-Identifier: MIT
#include <intaglio/text/measure.hpp>
#include <intaglio/text/utf8.hpp>

namespace intaglio::text {

linear::Size measure(const Font& font, std::string_view utf8) noexcept {
  constexpr int limit = 2 * linear::coordinate_limit;
  if (font.empty()) return {};
  linear::Size size{0, font.line_height()};
  int pen = 0;
  while (!utf8.empty()) {
    const char32_t code = take_code_point(utf8);
    if (code == U'\n') {
      pen = 0;
      if (size.height < limit) size.height += font.line_height();
    } else {
      if (pen < limit) pen += font.glyph(code).advance;
      if (pen > size.width) size.width = pen;
    }
  }
  if (size.width > limit) size.width = limit;
  if (size.height > limit) size.height = limit;
  return size;
}

}  // namespace intaglio::text
