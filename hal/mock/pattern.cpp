// SPDX-License-Identifier: MIT
#include <hal/mock/pattern.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <unistd.h>

namespace hal::mock {

namespace {

// Panes of this size stand side by side on a wide terminal.
constexpr int most_columns = 56;
constexpr int most_rows = 40;
// Pixels shown around the differences of a large picture.
constexpr int margin = 2;

int index_of(char glyph) {
  if (glyph == '.') return 0;
  if (glyph == '#') return 1;
  if (glyph >= '0' && glyph <= '9') return glyph - '0';
  if (glyph >= 'a' && glyph <= 'z') return glyph - 'a' + 10;
  return -1;
}

char glyph_of(int index) {
  if (index == 0) return '.';
  if (index == 1) return '#';
  if (index > 1 && index < 10) return static_cast<char>('0' + index);
  if (index >= 10 && index < 36) return static_cast<char>('a' + index - 10);
  return '@';
}

enum class Ink { plain, faint, good, extra, missing, other };

std::string_view escape_of(Ink ink) {
  constexpr std::array<std::string_view, 6> escapes{"",           "\x1b[2m",    "\x1b[32m",
                                                    "\x1b[1;31m", "\x1b[1;34m", "\x1b[1;33m"};
  return escapes[static_cast<std::size_t>(ink)];
}

/// Text with changes of colour, if any are wanted.
class Page {
 public:
  explicit Page(bool colour) : colour_(colour) {}
  void put(char glyph, Ink ink) {
    if (colour_ && ink != ink_) {
      if (ink_ != Ink::plain) text_ += "\x1b[0m";
      text_ += escape_of(ink);
      ink_ = ink;
    }
    text_ += glyph;
  }
  void put(std::string_view text, Ink ink = Ink::plain) {
    for (const char glyph : text) put(glyph, ink);
  }
  [[nodiscard]] std::string take() {
    put('\n', Ink::plain);
    return std::move(text_);
  }

 private:
  bool colour_;
  Ink ink_ = Ink::plain;
  std::string text_;
};

Ink kind_of(int expected, int actual) {
  if (expected == actual) return Ink::plain;
  if (expected == 0) return Ink::extra;
  return actual == 0 ? Ink::missing : Ink::other;
}

/// The part of the pictures to show: columns and rows begin .. end-1.
struct Window {
  int left = 0, top = 0, right = 0, bottom = 0;
};

void cut(int& begin, int& end, int size, int most) {
  begin = std::max(begin - margin, 0);
  end = std::min({end + margin, size, begin + most});
}

std::string padded(std::string_view text, int width) {
  std::string line(text);
  line.resize(static_cast<std::size_t>(std::max(width, 10)), ' ');
  return line;
}

}  // namespace

Pattern Pattern::blank(int width, int height) {
  return {width, height,
          std::vector<int>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
}

Pattern Pattern::parse(std::span<const std::string_view> rows, std::string& error) {
  error.clear();
  Pattern pattern;
  pattern.height = static_cast<int>(rows.size());
  pattern.width = rows.empty() ? 0 : static_cast<int>(rows[0].size());
  for (std::size_t y = 0; y < rows.size(); ++y) {
    if (rows[y].size() != rows[0].size())
      error = "row " + std::to_string(y) + " differs in length from row 0";
    for (const char glyph : rows[y]) {
      const int index = index_of(glyph);
      if (index < 0) error = std::string("'") + glyph + "' in row " + std::to_string(y) + " is no pixel";
      pattern.pixels.push_back(index);
    }
    if (!error.empty()) return {};
  }
  return pattern;
}

std::string side_by_side(const Pattern& expected, const Pattern& actual, bool colour) {
  if (expected.width != actual.width || expected.height != actual.height)
    return "expected " + std::to_string(expected.width) + 'x' + std::to_string(expected.height) +
           " pixels, got " + std::to_string(actual.width) + 'x' + std::to_string(actual.height) + '\n';
  Window window{expected.width, expected.height, 0, 0};
  int different = 0;
  for (int y = 0; y < expected.height; ++y)
    for (int x = 0; x < expected.width; ++x) {
      if (expected.at(x, y) == actual.at(x, y)) continue;
      ++different;
      window = {std::min(window.left, x), std::min(window.top, y), std::max(window.right, x + 1),
                std::max(window.bottom, y + 1)};
    }
  if (different == 0) return {};

  Page page(colour);
  page.put(std::to_string(different) + " of " + std::to_string(expected.pixels.size()) + " pixels differ");
  if (expected.width <= most_columns && expected.height <= most_rows) {
    window = {0, 0, expected.width, expected.height};
  } else {
    cut(window.left, window.right, expected.width, most_columns);
    cut(window.top, window.bottom, expected.height, most_rows);
    page.put("; columns " + std::to_string(window.left) + ".." + std::to_string(window.right - 1) +
             ", rows " + std::to_string(window.top) + ".." + std::to_string(window.bottom - 1));
  }
  const int columns = window.right - window.left;
  page.put("\n  " + padded("expected", columns) + " | " + padded("actual", columns) + " | difference");
  const std::string filler = padded("", columns).substr(static_cast<std::size_t>(columns));
  for (int y = window.top; y < window.bottom; ++y) {
    page.put("\n  ");
    for (int x = window.left; x < window.right; ++x) {
      const Ink ink = expected.at(x, y) == 0 ? Ink::faint : Ink::good;
      page.put(glyph_of(expected.at(x, y)), ink);
    }
    page.put(filler + " | ");
    for (int x = window.left; x < window.right; ++x) {
      const Ink kind = kind_of(expected.at(x, y), actual.at(x, y));
      const Ink same = actual.at(x, y) == 0 ? Ink::faint : Ink::good;
      page.put(glyph_of(actual.at(x, y)), kind == Ink::plain ? same : kind);
    }
    page.put(filler + " | ");
    for (int x = window.left; x < window.right; ++x) {
      const Ink kind = kind_of(expected.at(x, y), actual.at(x, y));
      const char glyph = kind == Ink::plain     ? '.'
                         : kind == Ink::extra   ? '+'
                         : kind == Ink::missing ? '-'
                                                : '*';
      page.put(glyph, kind == Ink::plain ? Ink::faint : kind);
    }
  }
  return page.take();
}

bool colour_wanted() {
  if (std::getenv("CLICOLOR_FORCE") != nullptr) return true;
  return std::getenv("NO_COLOR") == nullptr && isatty(STDOUT_FILENO) != 0;
}

}  // namespace hal::mock
