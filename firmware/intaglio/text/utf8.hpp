// SPDX-License-Identifier: MIT
//
// UTF-8, one code point at a time.
//
// Rule: Unicode 15, table 3-7 (well-formed byte sequences). A malformed sequence becomes one U+FFFD for each
// maximal subpart: the longest run of bytes that begins a well-formed sequence, or one byte if there is none.
// So overlong forms, surrogates, values above U+10FFFF, stray continuation bytes and cut-off sequences are
// all told apart from text, and decoding takes up again at the next byte that can begin something. No byte
// past the end is read. Worst known input: "\xF0\x80\x80", which is three U+FFFD and not one.
#pragma once

#include <string_view>

namespace intaglio::text {

/// What a malformed sequence decodes to.
inline constexpr char32_t replacement_character = 0xFFFD;

/// Takes one code point off the front of `utf8`, which must not be empty. Removes 1..4 bytes.
[[nodiscard]] char32_t take_code_point(std::string_view& utf8) noexcept;

}  // namespace intaglio::text
