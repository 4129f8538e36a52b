// SPDX-License-Identifier: MIT
//
// The arguments of one command of the drawing language, read one after another.
#pragma once

#include <host/draw/words.hpp>
#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace host::draw {

/// A reader of one command's arguments; the names of the arguments are for messages. What is missing or of
/// the wrong kind throws Failure.
class Arguments {
 public:
  explicit Arguments(std::span<const Word> words) : words_(words) {}

  [[nodiscard]] std::size_t left() const { return words_.size(); }
  /// True if the next word stands without quotes and is this one.
  [[nodiscard]] bool next_is(std::string_view text) const;

  /// Takes the next word if it is this one.
  [[nodiscard]] bool take(std::string_view text);
  /// The next word as it is.
  const Word& word(std::string_view name);
  /// One of the words that mean something, as that.
  template <class T, std::size_t N>
  T one_of(std::string_view name, const std::array<std::pair<std::string_view, T>, N>& choices) {
    std::string names;
    for (std::size_t i = 0; i < N; ++i) {
      const auto& [choice, meaning] = choices[i];
      if (take(choice)) return meaning;
      names.append(i == 0 ? "" : i + 1 == N ? " or " : ", ").append(choice);
    }
    fail(name, names);
  }
  /// A whole number.
  int whole(std::string_view name);
  /// A whole number of low .. high.
  int whole(std::string_view name, int low, int high);
  /// A number in 1/256.
  int subpixel(std::string_view name);

  /// Two whole numbers.
  intaglio::linear::Point point(std::string_view x, std::string_view y);
  /// Two numbers in 1/256.
  intaglio::linear::SubPoint subpoint(std::string_view x = "x", std::string_view y = "y");
  /// Left, top, width and height in whole numbers.
  intaglio::linear::Rect rectangle();

  /// Throws if anything is left.
  void end() const;

 private:
  /// Says what the next word must be.
  [[noreturn]] void fail(std::string_view name, std::string_view choices);

  std::span<const Word> words_;
};

}  // namespace host::draw
