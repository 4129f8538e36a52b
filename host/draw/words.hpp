// SPDX-License-Identifier: MIT
//
// Lines of the drawing language as words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace host::draw {

struct Word {
  std::string text;     ///< Without quotes, escapes resolved.
  bool quoted = false;  ///< It stood in quotes.
};

/// The words of a line: parted by spaces and tabs; "…" is one word, with the escapes \" \\ \n; # outside of
/// quotes ends the line. Throws Failure (a quote that doesn't end, an unknown escape).
std::vector<Word> split_words(std::string_view line);

}  // namespace host::draw
