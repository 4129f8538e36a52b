// SPDX-License-Identifier: MIT
//
// Oracle: packed pixels, bit by bit. A row is a string of bits; pixel x owns the `bits` bits from x * bits
// on. Most significant first, bit n of the string is bit 7 - n%8 of byte n/8 and a pixel's first bit is its
// highest; least significant first, it is bit n%8 and a pixel's first bit is its lowest.
#pragma once

#include <tests/oracle/random.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace oracle {

class Packed {
 public:
  Packed(int bits, bool most_significant_first, int stride, int height)
      : bits_(bits),
        most_significant_first_(most_significant_first),
        stride_(stride),
        bytes_(static_cast<std::size_t>(stride) * static_cast<std::size_t>(height)) {}

  [[nodiscard]] unsigned get(int x, int y) const {
    unsigned value = 0;
    for (int k = 0; k < bits_; ++k) {
      const unsigned bit = unsigned{bytes_[byte_of(x, y, k)]} >> place_of(x, k) & 1U;
      value |= bit << static_cast<unsigned>(most_significant_first_ ? bits_ - 1 - k : k);
    }
    return value;
  }
  void set(int x, int y, unsigned value) {
    for (int k = 0; k < bits_; ++k) {
      const unsigned bit = value >> static_cast<unsigned>(most_significant_first_ ? bits_ - 1 - k : k) & 1U;
      std::uint8_t& byte = bytes_[byte_of(x, y, k)];
      byte = static_cast<std::uint8_t>((byte & ~(1U << place_of(x, k))) | bit << place_of(x, k));
    }
  }
  void randomize(Random& random) {
    for (std::uint8_t& byte : bytes_) byte = static_cast<std::uint8_t>(random.bits());
  }

  [[nodiscard]] std::vector<std::uint8_t>& bytes() { return bytes_; }
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  [[nodiscard]] int stride() const { return stride_; }

 private:
  [[nodiscard]] std::size_t byte_of(int x, int y, int k) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(stride_) +
           static_cast<std::size_t>((x * bits_ + k) / 8);
  }
  [[nodiscard]] unsigned place_of(int x, int k) const {
    const int n = (x * bits_ + k) % 8;
    return static_cast<unsigned>(most_significant_first_ ? 7 - n : n);
  }

  int bits_;
  bool most_significant_first_;
  int stride_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace oracle
