// SPDX-License-Identifier: MIT
#include <hal/hid/run_length.hpp>

#include <algorithm>

namespace hal::hid {

namespace {

constexpr std::uint8_t first_run = 0x80;
constexpr std::uint8_t first_skip = 0xC0;
constexpr std::uint8_t long_run = 0xFE;
constexpr std::uint8_t long_skip = 0xFF;
constexpr std::size_t most_literal = 128;
constexpr std::size_t most_short_run = 65;
constexpr std::size_t most_short_skip = 62;
constexpr std::size_t most_long = 65535;
/// Shorter ones inside a literal cost more than they save.
constexpr std::size_t worth_a_token = 4;

std::size_t same_as_before(std::span<const std::uint8_t> fresh, std::span<const std::uint8_t> before,
                           std::size_t at, std::size_t most) noexcept {
  if (before.empty()) return 0;
  const std::size_t end = std::min(fresh.size(), at + most);
  std::size_t i = at;
  while (i < end && fresh[i] == before[i]) ++i;
  return i - at;
}

std::size_t run_at(std::span<const std::uint8_t> fresh, std::size_t at, std::size_t most) noexcept {
  const std::size_t end = std::min(fresh.size(), at + most);
  std::size_t i = at;
  while (i < end && fresh[i] == fresh[at]) ++i;
  return i - at;
}

}  // namespace

Packed pack(std::span<const std::uint8_t> fresh, std::span<const std::uint8_t> before,
            std::span<std::uint8_t> room) noexcept {
  Packed done;
  const auto put = [&](std::size_t byte) { room[done.written++] = static_cast<std::uint8_t>(byte); };
  const auto put_count = [&](std::size_t count) {
    put(count & 0xFFU);
    put(count >> 8U);
  };
  while (done.taken < fresh.size() && room.size() - done.written >= least_token_room) {
    const std::size_t skip = same_as_before(fresh, before, done.taken, most_long);
    const std::size_t run = run_at(fresh, done.taken, most_long);
    // The longer one: it costs no more, and what was looked at is taken.
    if ((skip >= worth_a_token && skip >= run) || (skip > 0 && done.taken + skip == fresh.size())) {
      if (skip <= most_short_skip) {
        put(first_skip + skip - 1U);
      } else {
        put(long_skip);
        put_count(skip);
      }
      done.taken += skip;
    } else if (run >= worth_a_token) {
      if (run <= most_short_run) {
        put(first_run + run - 2U);
      } else {
        put(long_run);
        put_count(run);
      }
      put(fresh[done.taken]);
      done.taken += run;
    } else {
      const std::size_t most =
          std::min({most_literal, room.size() - done.written - 1U, fresh.size() - done.taken});
      std::size_t count = 1;
      while (count < most &&
             same_as_before(fresh, before, done.taken + count, worth_a_token) < worth_a_token &&
             run_at(fresh, done.taken + count, worth_a_token) < worth_a_token)
        ++count;
      put(count - 1U);
      for (std::size_t i = 0; i < count; ++i) put(fresh[done.taken + i]);
      done.taken += count;
    }
  }
  return done;
}

std::optional<Token> take_token(std::span<const std::uint8_t>& tokens) noexcept {
  if (tokens.empty()) return {};
  const std::uint8_t head = tokens.front();
  std::size_t used = 1;
  Token token;
  std::size_t bytes = 0;
  if (head < first_run) {
    token.kind = Token::Kind::literal;
    token.count = bytes = head + std::size_t{1};
  } else if (head < first_skip) {
    token.kind = Token::Kind::run;
    token.count = head - std::size_t{first_run} + 2U;
    bytes = 1;
  } else if (head < long_run) {
    token.count = head - std::size_t{first_skip} + 1U;
  } else {
    if (tokens.size() < 3) return {};
    token.kind = head == long_run ? Token::Kind::run : Token::Kind::skip;
    token.count = static_cast<std::size_t>(tokens[1] | tokens[2] << 8);
    bytes = head == long_run ? 1 : 0;
    used = 3;
    if (token.count == 0) return {};
  }
  if (tokens.size() - used < bytes) return {};
  token.bytes = tokens.subspan(used, bytes);
  tokens = tokens.subspan(used + bytes);
  return token;
}

}  // namespace hal::hid
