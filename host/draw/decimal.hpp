// SPDX-License-Identifier: MIT
//
// Numbers of the drawing language, read exactly.
//
// Rule: a decimal or a fraction is rounded to the nearest 1/256, halves away from zero. The digits after the
// point are multiplied by 256 as decimal digits, and fractions divided as integers of any length, so numbers
// with a thousand digits are rounded rightly too; no floating point is involved.
#pragma once

#include <optional>
#include <string_view>

namespace host::draw {

/// A whole number with an optional sign; nothing else. Beyond +-2^31-1 it saturates there, which every
/// command refuses as out of its range.
std::optional<int> parse_whole(std::string_view text);

/// A number such as -3, +0.5, 12.00390625, .5 or -7/3, in 1/256. Saturates at +-2^31-1. The parts of a
/// fraction are whole, and the lower one has no sign and isn't zero.
std::optional<int> parse_subpixel(std::string_view text);

}  // namespace host::draw
