// SPDX-License-Identifier: MIT
#include <hal/hid/host/mcp2221.hpp>

#include <algorithm>

namespace hal::hid {

namespace {

constexpr std::uint8_t status_or_parameters = 0x10;
constexpr std::uint8_t write_data = 0x90;
constexpr std::uint8_t cancel_transfer = 0x10;
constexpr std::uint8_t set_speed = 0x20;
constexpr std::size_t piece_bytes = 60;
constexpr std::size_t most_bytes = 0xFFFF;

// Of the answer to `status_or_parameters`:
constexpr std::size_t speed_answer = 3;
constexpr std::size_t engine_state = 8;
constexpr std::size_t acknowledge = 20;
constexpr std::uint8_t not_acknowledged = 0x40;
constexpr std::uint8_t idle = 0x00;

constexpr Nanoseconds answer_patience = 500'000'000;
constexpr Nanoseconds least_answer_patience = 20'000'000;
constexpr Nanoseconds engine_patience = 500'000'000;
/// Questions after which it should be at rest even if the clock has leapt.
constexpr int engine_chances = 100;

/// States in which the engine has given up: time-outs of start, address, data, stop; address refused.
bool failed(std::uint8_t state) {
  constexpr std::array<std::uint8_t, 6> states{0x12, 0x17, 0x23, 0x25, 0x44, 0x62};
  return std::find(states.begin(), states.end(), state) != states.end();
}

}  // namespace

Status Mcp2221I2c::ask(const Report& command, Report& answer) noexcept {
  if (const Status s = port_->send(command); !s.ok()) return s;
  Patience patience(*clock_, answer_patience);
  do {
    const Received got = port_->receive(answer, patience.left(least_answer_patience));
    if (!got.status.ok()) return got.status;
    // An answer to what was asked before, by whomever, is passed over.
    if (got.size == answer.size() && answer[0] == command[0]) return {};
  } while (!patience.over());
  return {Error::timeout, Part::bus};
}

Status Mcp2221I2c::start(std::uint32_t hertz) noexcept {
  constexpr std::uint32_t chip_hertz = 12'000'000;
  if (hertz < 46'511 || hertz > 400'000) return {Error::invalid, Part::bus};
  // Cancelling takes effect after the answer; only then the speed can be set.
  cancel({}).ignore();
  Report command{status_or_parameters};
  command[3] = set_speed;
  command[4] = static_cast<std::uint8_t>(chip_hertz / hertz - 3U);
  Report answer{};
  Patience patience(*clock_, engine_patience, engine_chances);
  do {
    if (const Status s = ask(command, answer); !s.ok()) return s;
    if (answer[1] == 0 && answer[speed_answer] == set_speed) return {};
  } while (!patience.over());
  return {Error::bus, Part::bus};
}

Status Mcp2221I2c::cancel(const Status& why) noexcept {
  if (why.error() == Error::disconnected) return why;
  Report command{status_or_parameters};
  command[2] = cancel_transfer;
  Report answer{};
  const Status s = ask(command, answer);
  return why.ok() ? s : why;
}

Status Mcp2221I2c::do_write(std::uint8_t address, std::span<const std::uint8_t> prefix,
                            std::span<const std::uint8_t> bytes) noexcept {
  const std::size_t all = prefix.size() + bytes.size();
  if (all > most_bytes) return {Error::invalid, Part::bus};
  Patience patience(*clock_, engine_patience + all * 100'000U, engine_chances);
  std::size_t done = 0;
  do {
    Report piece{write_data, static_cast<std::uint8_t>(all & 0xFFU), static_cast<std::uint8_t>(all >> 8U),
                 static_cast<std::uint8_t>(address * 2U)};
    const std::size_t count = std::min(piece_bytes, all - done);
    for (std::size_t i = 0; i < count; ++i, ++done)
      piece[4 + i] = done < prefix.size() ? prefix[done] : bytes[done - prefix.size()];
    if (const Status s = send_piece(piece, patience); !s.ok()) return cancel(s);
  } while (done < all);
  if (const Status s = settle(patience); !s.ok()) return cancel(s);
  return {};
}

Status Mcp2221I2c::send_piece(const Report& piece, Patience& patience) noexcept {
  Report answer{};
  for (;;) {
    if (const Status s = ask(piece, answer); !s.ok()) return s;
    if (answer[1] == 0) return {};
    if (failed(answer[2])) return {Error::bus, Part::bus};
    if (patience.over()) return {Error::timeout, Part::bus};
  }
}

Status Mcp2221I2c::settle(Patience& patience) noexcept {
  const Report command{status_or_parameters};
  Report answer{};
  for (;;) {
    if (const Status s = ask(command, answer); !s.ok()) return s;
    if (failed(answer[engine_state])) return {Error::bus, Part::bus};
    if (answer[engine_state] == idle)
      return (answer[acknowledge] & not_acknowledged) != 0 ? Status{Error::bus, Part::bus} : Status{};
    if (patience.over()) return {Error::timeout, Part::bus};
  }
}

}  // namespace hal::hid
