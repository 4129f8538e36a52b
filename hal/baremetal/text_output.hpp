// SPDX-License-Identifier: MIT
//
// Text and numbers to a serial line, without printf.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hal::baremetal {

class TextOutput {
 public:
  TextOutput(const TextOutput&) = delete;
  TextOutput& operator=(const TextOutput&) = delete;

  /// Returns when all of the text is on its way.
  void text(std::string_view s) noexcept;
  /// A literal, whose length the compiler knows: no strlen in the image.
  template <std::size_t N>
  void text(const char (&literal)[N]) noexcept {
    text(std::string_view(literal, N - 1));
  }
  /// `value` in decimal, no leading zeros.
  void decimal(std::uint32_t value) noexcept;
  /// `value` in hexadecimal, eight lower-case digits.
  void hex(std::uint32_t value) noexcept;

 protected:
  constexpr TextOutput() noexcept = default;
  ~TextOutput() = default;

 private:
  virtual void do_put(char c) noexcept = 0;
};

}  // namespace hal::baremetal
