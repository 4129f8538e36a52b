// SPDX-License-Identifier: MIT
#include <host/assets/charset.hpp>
#include <host/failure.hpp>
#include <intaglio/text/utf8.hpp>

#include <fmt/format.h>

#include <charconv>

namespace host::assets {
namespace {

constexpr std::uint32_t largest_code_point = 0x10FFFF;

/// One number; `base` is 16 after a prefix and otherwise stays as it is.
std::uint32_t parse_number(std::string_view text, int& base, std::string_view item) {
  if (text.starts_with("0x") || text.starts_with("0X") || text.starts_with("U+") || text.starts_with("u+")) {
    base = 16;
    text.remove_prefix(2);
  }
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc{} || end != text.data() + text.size() || text.empty() || value > largest_code_point)
    throw Failure(fmt::format("charset: '{}' is not a code point or a range such as 0x20-0x7E", item));
  return value;
}

}  // namespace

std::set<std::uint32_t> parse_charset(std::string_view list) {
  std::set<std::uint32_t> codes;
  while (!list.empty()) {
    const auto comma = list.find(',');
    std::string_view item = list.substr(0, comma);
    list = comma == std::string_view::npos ? std::string_view{} : list.substr(comma + 1);
    while (!item.empty() && item.front() == ' ') item.remove_prefix(1);
    while (!item.empty() && item.back() == ' ') item.remove_suffix(1);
    if (item.empty()) continue;
    int base = 10;
    const auto dash = item.find('-');
    const std::uint32_t first = parse_number(item.substr(0, dash), base, item);
    const std::uint32_t last =
        dash == std::string_view::npos ? first : parse_number(item.substr(dash + 1), base, item);
    if (last < first) throw Failure(fmt::format("charset: '{}' ends before it begins", item));
    for (std::uint32_t code = first; code <= last; ++code) codes.insert(code);
  }
  return codes;
}

std::set<std::uint32_t> code_points(std::string_view utf8) {
  std::set<std::uint32_t> codes;
  while (!utf8.empty()) {
    const std::string_view before = utf8;
    const std::uint32_t code = intaglio::text::take_code_point(utf8);
    if (code == intaglio::text::replacement_character && !before.starts_with("\xEF\xBF\xBD"))
      throw Failure("chars: malformed UTF-8");
    codes.insert(code);
  }
  return codes;
}

}  // namespace host::assets
