// SPDX-License-Identifier: MIT
#include <host/draw/arguments.hpp>
#include <host/draw/decimal.hpp>
#include <host/failure.hpp>

#include <fmt/format.h>

#include <optional>

namespace host::draw {

namespace linear = intaglio::linear;

bool Arguments::next_is(std::string_view text) const {
  return !words_.empty() && !words_.front().quoted && words_.front().text == text;
}

bool Arguments::take(std::string_view text) {
  if (!next_is(text)) return false;
  words_ = words_.subspan(1);
  return true;
}

void Arguments::fail(std::string_view name, std::string_view choices) {
  throw Failure(fmt::format("the {} must be {}, not '{}'", name, choices, word(name).text));
}

const Word& Arguments::word(std::string_view name) {
  if (words_.empty()) throw Failure(fmt::format("{} is missing", name));
  const Word& first = words_.front();
  words_ = words_.subspan(1);
  return first;
}

int Arguments::whole(std::string_view name) {
  const Word& w = word(name);
  const auto value = w.quoted ? std::nullopt : parse_whole(w.text);
  if (!value) {
    const bool decimal = !w.quoted && parse_subpixel(w.text).has_value();
    throw Failure(fmt::format("{} must be a {}number, not '{}'", name, decimal ? "whole " : "", w.text));
  }
  return *value;
}

int Arguments::whole(std::string_view name, int low, int high) {
  const int value = whole(name);
  if (value < low || value > high)
    throw Failure(fmt::format("{} must be {} to {}, not {}", name, low, high, value));
  return value;
}

int Arguments::subpixel(std::string_view name) {
  const Word& w = word(name);
  const auto value = w.quoted ? std::nullopt : parse_subpixel(w.text);
  if (!value) throw Failure(fmt::format("{} must be a number, not '{}'", name, w.text));
  return *value;
}

linear::Point Arguments::point(std::string_view x, std::string_view y) {
  const int first = whole(x);
  return {first, whole(y)};
}

linear::SubPoint Arguments::subpoint(std::string_view x, std::string_view y) {
  const int first = subpixel(x);
  return {first, subpixel(y)};
}

linear::Rect Arguments::rectangle() {
  const linear::Point corner = point("x", "y");
  const int width = whole("width");
  return {corner.x, corner.y, width, whole("height")};
}

void Arguments::end() const {
  if (!words_.empty()) throw Failure(fmt::format("'{}' is one argument too many", words_.front().text));
}

}  // namespace host::draw
