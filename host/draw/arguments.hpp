// SPDX-License-Identifier: MIT
//
// The arguments of one command of the drawing language, read one after another.
#pragma once

#include <host/draw/words.hpp>
#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>

#include <cstddef>
#include <span>
#include <string_view>

namespace host::draw {

/// A reader of one command's arguments; the names of the arguments are for messages. What is missing or of
/// the wrong kind throws Failure.
class Arguments {
 public:
  explicit Arguments(std::span<const Word> words) : words_(words) {}

  [[nodiscard]] std::size_t left() const { return words_.size(); }
  /// True if the next word stands without quotes and is this one.
  [[nodiscard]] bool next_is(std::string_view text) const;

  /// The next word as it is.
  const Word& word(std::string_view name);
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
  std::span<const Word> words_;
};

}  // namespace host::draw
