// SPDX-License-Identifier: MIT
//
// Pictures in letters, for tests: written in the source, compared, and shown side by side when they differ.
//
// Rule: a character a pixel. '.' is index 0, '#' (or '1') index 1, '2' to '9' and 'a' to 'z' are 2 to 35;
// larger indices are shown as '@' and can't be written. In the picture of differences '+' is a pixel too many
// (0 was expected), '-' one that is missing (0 is there), '*' one of another index.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hal::mock {

/// One number a pixel, rows from the top.
struct Pattern {
  int width = 0;
  int height = 0;
  std::vector<int> pixels;

  /// Sets `error` and gives an empty pattern if rows differ in length or hold other characters.
  static Pattern parse(std::span<const std::string_view> rows, std::string& error);
  /// All pixels 0.
  static Pattern blank(int width, int height);

  [[nodiscard]] int at(int x, int y) const { return pixels[place(x, y)]; }
  int& at(int x, int y) { return pixels[place(x, y)]; }
  [[nodiscard]] bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
  friend bool operator==(const Pattern&, const Pattern&) = default;

 private:
  [[nodiscard]] std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

/// "expected | actual | difference" line by line, cut to where they differ if they are large, in ANSI colours
/// if asked. Empty if the patterns are equal.
[[nodiscard]] std::string side_by_side(const Pattern& expected, const Pattern& actual, bool colour);

/// True if the output of the tests should be coloured: it goes to a terminal and NO_COLOR isn't set, or
/// CLICOLOR_FORCE is.
[[nodiscard]] bool colour_wanted();

}  // namespace hal::mock
