// SPDX-License-Identifier: MIT
//
// Runs of bytes: what a flat span of any pixel format comes down to.
//
// Rule: every byte of a run is written once, in whole words where the address allows, and nothing before or
// behind the run is touched. An `Ink` says what writing means: `Replace` stores, `Flip` exclusive-ors. A span
// of less than 8 bits a pixel that begins or ends inside a byte carries a mask for that byte; a full byte in
// the middle never needs one.
//
// Cost (Cortex-M3, -O2): about 26 instructions a run and 1/8 instruction a byte for `Replace`, which stores
// four registers at a time; about 1 a byte for `Flip`.
#pragma once

#include <cstdint>

namespace intaglio::image {

/// Stores `value` in `count` bytes from `first`. A count of zero or less stores nothing.
void fill_bytes(std::uint8_t* first, int count, std::uint8_t value) noexcept;

/// Exclusive-ors `value` into `count` bytes from `first`. A count of zero or less changes nothing.
void flip_bytes(std::uint8_t* first, int count, std::uint8_t value) noexcept;

/// A run of whole bytes between two that it may share with its neighbours.
struct MaskedRun {
  std::uint8_t* first = nullptr;  ///< The byte in which the run begins.
  int length = 0;                 ///< Bytes from `first` to the one in which the run ends; 0: the same byte.
  unsigned head = 0;              ///< The bits of the first byte from the run's beginning on.
  unsigned tail = 0;  ///< The bits of the last byte before the run's end; 0: that byte isn't touched.
};

/// Writes over what was there.
struct Replace {
  static void run(std::uint8_t* first, int count, std::uint8_t value) noexcept {
    fill_bytes(first, count, value);
  }
  static void run(const MaskedRun& run, std::uint8_t value) noexcept;
  /// The same run in `rows` rows, `stride` bytes apart.
  static void rows(std::uint8_t* first, int count, int rows, int stride, std::uint8_t value) noexcept;
  static void rows(const MaskedRun& run, int rows, int stride, std::uint8_t value) noexcept;
  /// Writes the bits of `mask`.
  static constexpr void put(std::uint8_t& byte, unsigned mask, unsigned value) noexcept {
    byte = static_cast<std::uint8_t>((byte & ~mask) | (value & mask));
  }
  static constexpr void put(std::uint8_t& byte, unsigned value) noexcept {
    byte = static_cast<std::uint8_t>(value);
  }
};

/// Exclusive-ors with what was there: drawn twice, everything is as before.
struct Flip {
  static void run(std::uint8_t* first, int count, std::uint8_t value) noexcept {
    flip_bytes(first, count, value);
  }
  static void run(const MaskedRun& run, std::uint8_t value) noexcept;
  /// The same run in `rows` rows, `stride` bytes apart.
  static void rows(std::uint8_t* first, int count, int rows, int stride, std::uint8_t value) noexcept;
  static void rows(const MaskedRun& run, int rows, int stride, std::uint8_t value) noexcept;
  /// Changes the bits of `mask`.
  static constexpr void put(std::uint8_t& byte, unsigned mask, unsigned value) noexcept {
    byte = static_cast<std::uint8_t>(byte ^ (value & mask));
  }
  static constexpr void put(std::uint8_t& byte, unsigned value) noexcept {
    byte = static_cast<std::uint8_t>(byte ^ value);
  }
};

}  // namespace intaglio::image
