// SPDX-License-Identifier: MIT
//
// How the bytes of a rectangle are packed: bytes that are as they were, runs of one byte, and bytes as they
// are.
//
// Rule: the bytes of the rectangle's rows, one row behind the other, are covered by tokens, each whole within
// a report:
//
//     0x00..0x7F         t+1 bytes follow as they are (1..128)
//     0x80..0xBF  v      the byte v, t-0x80+2 times (2..65)
//     0xC0..0xFD         t-0xC0+1 bytes stay as they are on the device (1..62)
//     0xFE  n n  v       the byte v, n times (1..65535)
//     0xFF  n n          n bytes stay (1..65535)
//
// At worst (no byte like its neighbour or its predecessor) 129 bytes carry 128.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace hal::hid {

/// Bytes that the longest token but a literal takes.
inline constexpr std::size_t least_token_room = 4;

/// What a call of `pack` did.
struct Packed {
  std::size_t taken = 0;    ///< bytes of the picture
  std::size_t written = 0;  ///< bytes of tokens
};
/// Packs the front of `fresh` into as many tokens as go into `room`. `before` is what the device holds there
/// (as long as `fresh`), or empty if that isn't known.
[[nodiscard]] Packed pack(std::span<const std::uint8_t> fresh, std::span<const std::uint8_t> before,
                          std::span<std::uint8_t> room) noexcept;

/// One token, taken from the front of `tokens`.
struct Token {
  enum class Kind : std::uint8_t { literal, run, skip } kind = Kind::skip;
  std::size_t count = 0;
  /// The bytes of a literal; the one byte of a run.
  std::span<const std::uint8_t> bytes{};
};
/// Nothing if the token isn't whole or says "no times".
[[nodiscard]] std::optional<Token> take_token(std::span<const std::uint8_t>& tokens) noexcept;

}  // namespace hal::hid
