// SPDX-License-Identifier: MIT
//
// Runs of bytes: what a flat span of any pixel format comes down to.
//
// Rule: every byte of a run is written once, in whole words where the address allows, and nothing before or
// behind the run is touched. An `Ink` says what writing means: `Replace` stores, `Flip` exclusive-ors. A span
// of less than 8 bits a pixel that begins or ends inside a byte carries a mask for that byte; a full byte in
// the middle never needs one.
//
// Cost (Cortex-M3, -O2): about 25 instructions a run and 1/8 instruction a byte for `Replace`, which stores
// four registers at a time; about 5/4 a byte for `Flip`.
#pragma once

#include <cstdint>

namespace intaglio::image {

/// A byte four times over: what the functions here take, so that no run has to build it again.
class Pattern {
 public:
  explicit constexpr Pattern(std::uint8_t byte) noexcept : word_(byte * 0x0101'0101U) {}
  [[nodiscard]] constexpr std::uint32_t word() const noexcept { return word_; }
  [[nodiscard]] constexpr std::uint8_t byte() const noexcept { return static_cast<std::uint8_t>(word_); }

 private:
  std::uint32_t word_;
};

/// Stores the pattern's byte in `count` >= 0 bytes from `first`.
void fill_bytes(std::uint8_t* first, int count, Pattern pattern) noexcept;

/// Exclusive-ors the pattern's byte into `count` >= 0 bytes from `first`.
void flip_bytes(std::uint8_t* first, int count, Pattern pattern) noexcept;

/// Copies `count` >= 0 bytes from `source` to `first`, but leaves those that are the pattern's byte. The runs
/// may overlap if `first` lies before `source`.
void copy_bytes_but(std::uint8_t* first, const std::uint8_t* source, int count, Pattern pattern) noexcept;

/// Stores table[i] for each of `count` >= 0 bytes i from `source`. The runs may overlap if `first` lies
/// before `source`.
void map_bytes(std::uint8_t* first, const std::uint8_t* source, int count,
               const std::uint8_t* table) noexcept;

/// A run of whole bytes between two that it may share with its neighbours.
struct MaskedRun {
  std::uint8_t* first = nullptr;  ///< The byte in which the run begins.
  int length = 0;                 ///< Bytes from `first` to the one in which the run ends; 0: the same byte.
  unsigned head = 0;              ///< The bits of the first byte from the run's beginning on.
  unsigned tail = 0;  ///< The bits of the last byte before the run's end; 0: that byte isn't touched.
};

/// Writes over what was there.
struct Replace {
  static void run(std::uint8_t* first, int count, Pattern pattern) noexcept {
    fill_bytes(first, count, pattern);
  }
  static void run(const MaskedRun& run, Pattern pattern) noexcept;
  /// The same run in `rows` rows, `stride` bytes apart. Precondition: rows >= 1.
  static void rows(std::uint8_t* first, int count, int rows, int stride, Pattern pattern) noexcept;
  static void rows(const MaskedRun& run, int rows, int stride, Pattern pattern) noexcept;
  /// Writes the bits of `mask`.
  [[gnu::always_inline]] static constexpr void put(std::uint8_t& byte, unsigned mask,
                                                   Pattern pattern) noexcept {
    byte = static_cast<std::uint8_t>((byte & ~mask) | (pattern.word() & mask));
  }
  [[gnu::always_inline]] static constexpr void put(std::uint8_t& byte, Pattern pattern) noexcept {
    byte = pattern.byte();
  }
};

/// Exclusive-ors with what was there: drawn twice, everything is as before.
struct Flip {
  static void run(std::uint8_t* first, int count, Pattern pattern) noexcept {
    flip_bytes(first, count, pattern);
  }
  static void run(const MaskedRun& run, Pattern pattern) noexcept;
  /// The same run in `rows` rows, `stride` bytes apart. Precondition: rows >= 1.
  static void rows(std::uint8_t* first, int count, int rows, int stride, Pattern pattern) noexcept;
  static void rows(const MaskedRun& run, int rows, int stride, Pattern pattern) noexcept;
  /// Changes the bits of `mask`.
  [[gnu::always_inline]] static constexpr void put(std::uint8_t& byte, unsigned mask,
                                                   Pattern pattern) noexcept {
    byte = static_cast<std::uint8_t>(byte ^ (pattern.word() & mask));
  }
  [[gnu::always_inline]] static constexpr void put(std::uint8_t& byte, Pattern pattern) noexcept {
    byte = static_cast<std::uint8_t>(byte ^ pattern.byte());
  }
};

}  // namespace intaglio::image
