// SPDX-License-Identifier: MIT
//
// What a type is called, at compile time.
//
// Rule: the name as the compiler writes it, without the namespaces it lies in: what rungs are called in the
// tables of measurements. A template's arguments stay as they are.
#pragma once

#include <cstddef>
#include <string_view>

namespace intaglio::number {

/// `SineTable256Linear` of intaglio::number::SineTable256Linear. GCC and Clang agree on it, also for
/// templates whose arguments are ints.
template <class T>
[[nodiscard]] constexpr std::string_view type_name() noexcept {
  // "... [with T = ns::Name; ...]" or "... [T = ns::Name]"
  constexpr std::string_view text = __PRETTY_FUNCTION__;
  std::size_t begin = text.find("T = ") + 4;
  std::size_t end = begin;
  for (int depth = 0; end < text.size() && (depth > 0 || (text[end] != ';' && text[end] != ']')); ++end) {
    if (text[end] == '<') ++depth;
    if (text[end] == '>') --depth;
    if (depth == 0 && text[end] == ':') begin = end + 1;
  }
  return text.substr(begin, end - begin);
}

}  // namespace intaglio::number
