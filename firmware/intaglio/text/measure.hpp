// SPDX-License-Identifier: MIT
//
// How much room a text takes.
//
// Rule: the width is the greatest sum of advances of a line, the height the line height times the number of
// lines; '\n' ends a line, so a text has one line more than it has '\n', and the empty text is one empty
// line. It is the layout box, not the ink: a glyph may overhang its advance by a pixel or two.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/text/font.hpp>

#include <string_view>

namespace intaglio::text {

/// The extent of a UTF-8 text in pixels, each side saturated at 2^21 (the widest rectangle there is).
/// Malformed sequences and missing glyphs count as the replacement box, which is what they draw. An empty
/// font: 0 by 0. Cost: once through the text.
[[nodiscard]] linear::Size measure(const Font& font, std::string_view utf8) noexcept;

}  // namespace intaglio::text
