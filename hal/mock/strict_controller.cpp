// SPDX-License-Identifier: MIT
#include <hal/mock/strict_controller.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace hal::mock {

namespace {

std::string hex(unsigned value) {
  char text[8];
  std::snprintf(text, sizeof text, "0x%02X", value);
  return text;
}

constexpr std::uint8_t control_more_commands = 0x00;
constexpr std::uint8_t control_one_command = 0x80;
constexpr std::uint8_t control_data = 0x40;

}  // namespace

std::vector<std::uint8_t> StrictController::noise_bytes(unsigned seed, std::size_t size) {
  std::vector<std::uint8_t> bytes(size);
  for (std::uint8_t& byte : bytes) {
    seed = seed * 1103515245U + 12345U;
    byte = static_cast<std::uint8_t>(seed >> 16U);
  }
  return bytes;
}

void StrictController::breach(std::string_view what) const {
  if (report_) {
    report_(what);
  } else {
    ADD_FAILURE() << what;
  }
}

bool StrictController::in_range(std::uint8_t command, int value, int low, int high) const {
  if (value >= low && value <= high) return true;
  breach("command " + hex(command) + ": parameter " + std::to_string(value) + " is not in " +
         std::to_string(low) + " .. " + std::to_string(high));
  return false;
}

void StrictController::expect_idle() const {
  if (!command_.empty()) breach("command " + hex(command_[0]) + " still waits for parameters");
}

bool StrictController::begin_transfer() {
  if (transfers_left_ <= 0) return false;
  --transfers_left_;
  ++transfers_;
  return true;
}

Status StrictController::fail(Part part) {
  fault_ = true;
  torn_command_ = !command_.empty();
  return {Error::bus, part};
}

std::size_t StrictController::torn(std::size_t count) {
  return std::min(count, static_cast<std::size_t>(std::exchange(torn_bytes_, 0)));
}

void StrictController::take(bool data, std::uint8_t byte) {
  if (data) {
    take_data(byte);
  } else {
    take_command(byte);
  }
}

void StrictController::take_command(std::uint8_t byte) {
  ++command_bytes_;
  if (travel_ == Parameters::as_data) {
    if (!torn_command_) expect_idle();
    torn_command_ = false;
    command_.clear();
  }
  if (!command_.empty()) {
    take_parameter(byte);
    return;
  }
  if (parameters(byte) < 0) {
    breach("unknown command " + hex(byte));
    return;
  }
  command_.push_back(byte);
  execute_if_complete();
}

void StrictController::take_parameter(std::uint8_t byte) {
  command_.push_back(byte);
  execute_if_complete();
}

void StrictController::execute_if_complete() {
  if (command_.size() < static_cast<std::size_t>(parameters(command_[0])) + 1U) return;
  const std::vector<std::uint8_t> given(command_.begin() + 1, command_.end());
  const std::uint8_t command = command_[0];
  command_.clear();
  // With parameters that were sent as something else a torn command may do anything but good.
  if (!std::exchange(torn_command_, false)) execute(command, given);
}

void StrictController::take_data(std::uint8_t byte) {
  if (travel_ == Parameters::as_data && !command_.empty()) {
    ++command_bytes_;
    take_parameter(byte);
    return;
  }
  ++data_bytes_;
  store(byte);
}

Status StrictController::Spi::do_write(std::span<const std::uint8_t> bytes) noexcept {
  StrictController& c = *owner_;
  const bool whole = c.begin_transfer();
  if (!whole) bytes = bytes.first(c.torn(bytes.size()));
  if (c.line_ == Line::unknown && !bytes.empty())
    c.breach("bytes were sent before the data/command line was driven");
  if (c.line_ == Line::data && c.travel_ == Parameters::as_commands) c.expect_idle();
  for (const std::uint8_t byte : bytes) c.take(c.line_ == Line::data, byte);
  return whole ? Status{} : c.fail(Part::bus);
}

Status StrictController::Pin::do_set(bool high) noexcept {
  StrictController& c = *owner_;
  if (!c.begin_transfer()) return c.fail(Part::pin);
  const Line line = high ? Line::data : Line::command;
  if (line != c.line_ && c.travel_ == Parameters::as_commands && !c.torn_command_) c.expect_idle();
  c.line_ = line;
  return {};
}

Status StrictController::I2c::do_write(std::uint8_t address, std::span<const std::uint8_t> prefix,
                                       std::span<const std::uint8_t> bytes) noexcept {
  StrictController& c = *owner_;
  const bool whole = c.begin_transfer();
  if (whole && address != c.i2c_address_) {
    c.breach("nothing answers at I2C address " + hex(address));
    return {Error::bus, Part::bus};
  }
  std::vector<std::uint8_t> all(prefix.begin(), prefix.end());
  all.insert(all.end(), bytes.begin(), bytes.end());
  if (!whole) all.resize(c.torn(all.size()));
  for (std::size_t i = 0; i < all.size();) {
    const std::uint8_t control = all[i++];
    if (control == control_one_command && i < all.size()) {
      c.take_command(all[i++]);
      continue;
    }
    if (control == control_data && c.travel_ == Parameters::as_commands) c.expect_idle();
    if (control != control_more_commands && control != control_data) {
      if (whole) c.breach("byte " + hex(control) + " is no control byte, or nothing follows it");
      break;
    }
    if (whole && i == all.size()) c.breach("control byte " + hex(control) + " has nothing behind it");
    // Without continuation bit the rest of the transaction is of this kind.
    while (i < all.size()) c.take(control == control_data, all[i++]);
  }
  return whole ? Status{} : c.fail(Part::bus);
}

}  // namespace hal::mock
