// SPDX-License-Identifier: MIT
//
// Numbers of the drawing language, read exactly.
//
// Rule: a decimal is rounded to the nearest 1/256, halves away from zero. The digits after the point are
// multiplied by 256 as decimal digits, so a number with a thousand of them is rounded rightly too; no
// floating point is involved.
#pragma once

#include <optional>
#include <string_view>

namespace host::draw {

/// A whole number with an optional sign; nothing else. Beyond +-2^31-1 it saturates there, which every
/// command refuses as out of its range.
std::optional<int> parse_whole(std::string_view text);

/// A number such as -3, +0.5, 12.00390625 or .5, in 1/256. Saturates at +-2^31-1.
std::optional<int> parse_subpixel(std::string_view text);

}  // namespace host::draw
