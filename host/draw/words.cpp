// SPDX-License-Identifier: MIT
#include <host/draw/words.hpp>
#include <host/failure.hpp>

namespace host::draw {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// The word that begins after a quote; takes it and the closing quote off the line.
Word take_quoted(std::string_view& line) {
  Word word{{}, true};
  while (!line.empty()) {
    const char c = line.front();
    line.remove_prefix(1);
    if (c == '"') return word;
    if (c != '\\') {
      word.text += c;
      continue;
    }
    const char escaped = line.empty() ? '\0' : line.front();
    if (escaped != '"' && escaped != '\\' && escaped != 'n')
      throw Failure("a backslash in quotes must stand before \", \\ or n");
    word.text += escaped == 'n' ? '\n' : escaped;
    line.remove_prefix(1);
  }
  throw Failure("the quote doesn't end on this line");
}

Word take_plain(std::string_view& line) {
  Word word;
  while (!line.empty() && !is_space(line.front()) && line.front() != '#' && line.front() != '"') {
    word.text += line.front();
    line.remove_prefix(1);
  }
  return word;
}

}  // namespace

std::vector<Word> split_words(std::string_view line) {
  std::vector<Word> words;
  while (true) {
    while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
    if (line.empty() || line.front() == '#') return words;
    const bool quoted = line.front() == '"';
    if (quoted) line.remove_prefix(1);
    words.push_back(quoted ? take_quoted(line) : take_plain(line));
  }
}

}  // namespace host::draw
