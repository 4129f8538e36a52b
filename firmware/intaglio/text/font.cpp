// SPDX-License-Identifier: MIT
#include <intaglio/text/font.hpp>

namespace intaglio::text {

std::size_t Font::glyph_index(char32_t code) const noexcept {
  // Invariant: no range before `low` and none from `high` on has the code point.
  std::size_t low = 0;
  std::size_t high = tables_.ranges.size();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    const CodeRange& range = tables_.ranges[middle];
    if (code < range.first) {
      high = middle;
    } else if (code - range.first >= range.count) {
      low = middle + 1;
    } else {
      return range.glyph + (code - range.first);
    }
  }
  return 0;
}

}  // namespace intaglio::text
