// SPDX-License-Identifier: MIT
//
// Character sets as users write them.
#pragma once

#include <cstdint>
#include <set>
#include <string_view>

namespace host::assets {

/// The code points of a list such as "0x20-0x7E,U+2190-2193,65": hexadecimal after 0x or U+, else decimal;
/// the end of a range is hexadecimal if its beginning is. Throws Failure that quotes the wrong item.
std::set<std::uint32_t> parse_charset(std::string_view list);

/// The code points of a UTF-8 text. Throws Failure if it is malformed.
std::set<std::uint32_t> code_points(std::string_view utf8);

}  // namespace host::assets
