// SPDX-License-Identifier: MIT
//
// What every fuzz target shares: arguments out of a fuzzer's bytes, and how a finding is reported.
//
// Rule: bytes mostly become arguments that make a small visible picture, some become any number, and some
// those at which programs break. When the bytes are used up all further arguments are zero, so every input
// means something and short ones stay simple.
#pragma once

#include <intaglio/linear/point.hpp>

#include <climits>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

namespace fuzz {

/// Ends the program with a message, which is what a fuzzer takes as a finding.
[[noreturn]] inline void report(std::string_view what) {
  std::fprintf(stderr, "wrong: %.*s\n", static_cast<int>(what.size()), what.data());
  std::abort();
}
inline void require(bool good, std::string_view what) {
  if (!good) report(what);
}

/// The bytes of one run, taken from the front.
class Input {
 public:
  explicit Input(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  [[nodiscard]] bool empty() const { return bytes_.empty(); }
  [[nodiscard]] std::size_t left() const { return bytes_.size(); }

  int byte() {
    if (bytes_.empty()) return 0;
    const int value = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return value;
  }
  /// 0 .. count-1, count at most 256.
  int choice(int count) { return byte() % count; }
  /// Any int.
  int any() {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8U | static_cast<std::uint32_t>(byte());
    return static_cast<int>(value);
  }
  /// -2^15 .. 2^15-1.
  int medium() {
    const int high = byte();
    return high * 256 + byte() - (1 << 15);
  }
  /// One of the numbers at which programs break; `limit` is that of the domain.
  int edge(int limit) {
    const std::array<int, 12> edges{limit,   -limit,  limit + 1, -limit - 1, limit - 1, 1 - limit,
                                    INT_MIN, INT_MAX, 0,         -1,         1 << 16,   1 << 30};
    return edges[static_cast<std::size_t>(choice(static_cast<int>(edges.size())))];
  }
  /// A pixel's coordinate: mostly near first .. first+length-1.
  int coordinate(int first, int length) {
    constexpr int limit = intaglio::linear::coordinate_limit;
    const int b = byte();
    if (b < 0xC0) return first - 16 + b % (length + 32);
    return number(b, limit);
  }
  /// The same in 1/256 pixel.
  int sub_coordinate(int first, int length) {
    constexpr int limit = intaglio::linear::coordinate_limit * intaglio::linear::subpixel_one;
    const int b = byte();
    if (b < 0xC0) {
      // Centres and borders of pixels are where ties are.
      const int f = byte();
      const int part = f < 64 ? 0 : f < 96 ? 128 : f;
      return (first - 16 + b % (length + 32)) * intaglio::linear::subpixel_one + part;
    }
    return number(b, limit);
  }
  /// A length or radius: mostly 0 .. 63.
  int length() {
    const int b = byte();
    return b < 0xC0 ? b & 63 : number(b, intaglio::linear::coordinate_limit);
  }
  /// What is left.
  std::span<const std::uint8_t> rest() {
    const auto all = bytes_;
    bytes_ = {};
    return all;
  }
  std::string_view rest_as_text() {
    const auto all = rest();
    return {reinterpret_cast<const char*>(all.data()), all.size()};
  }

 private:
  int number(int kind, int limit) {
    switch (kind & 3) {
      case 0:
        return medium();
      case 1:
        return any() % (limit + 1);
      case 2:
        return edge(limit);
      default:
        return any();
    }
  }

  std::span<const std::uint8_t> bytes_;
};

/// One run: every target defines it. Reports what it finds.
void run(Input in);

}  // namespace fuzz
