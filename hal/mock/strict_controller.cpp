// SPDX-License-Identifier: MIT
#include <hal/mock/strict_controller.hpp>

#include <gtest/gtest.h>

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

void StrictController::breach(std::string_view what) const { ADD_FAILURE() << what; }

bool StrictController::in_range(std::uint8_t command, int value, int low, int high) const {
  if (value >= low && value <= high) return true;
  ADD_FAILURE() << "command " << hex(command) << ": parameter " << value << " is not in " << low << " .. "
                << high;
  return false;
}

void StrictController::expect_idle() const {
  if (!command_.empty()) ADD_FAILURE() << "command " << hex(command_[0]) << " still waits for parameters";
}

bool StrictController::begin_transfer() {
  if (transfers_left_ <= 0) return false;
  --transfers_left_;
  ++transfers_;
  return true;
}

void StrictController::take_command(std::uint8_t byte) {
  ++command_bytes_;
  command_.push_back(byte);
  const int wanted = parameters(command_[0]);
  if (wanted < 0) {
    breach("unknown command " + hex(byte));
    command_.clear();
    return;
  }
  if (command_.size() < static_cast<std::size_t>(wanted) + 1U) return;
  const std::vector<std::uint8_t> given(command_.begin() + 1, command_.end());
  const std::uint8_t command = command_[0];
  command_.clear();
  execute(command, given);
}

void StrictController::take_data(std::uint8_t byte) {
  ++data_bytes_;
  store(byte);
}

Status StrictController::Spi::do_write(std::span<const std::uint8_t> bytes) noexcept {
  StrictController& c = *owner_;
  if (!c.begin_transfer()) return {Error::bus, Part::bus};
  if (c.line_ == Line::unknown) c.breach("bytes were sent before the data/command line was driven");
  if (c.line_ == Line::data) c.expect_idle();
  for (const std::uint8_t byte : bytes) {
    if (c.line_ == Line::data) {
      c.take_data(byte);
    } else {
      c.take_command(byte);
    }
  }
  return {};
}

Status StrictController::Pin::do_set(bool high) noexcept {
  StrictController& c = *owner_;
  if (!c.begin_transfer()) return {Error::bus, Part::pin};
  const Line line = high ? Line::data : Line::command;
  if (line != c.line_) c.expect_idle();
  c.line_ = line;
  return {};
}

Status StrictController::I2c::do_write(std::uint8_t address, std::span<const std::uint8_t> prefix,
                                       std::span<const std::uint8_t> bytes) noexcept {
  StrictController& c = *owner_;
  if (!c.begin_transfer()) return {Error::bus, Part::bus};
  if (address != c.i2c_address_) {
    c.breach("nothing answers at I2C address " + hex(address));
    return {Error::bus, Part::bus};
  }
  std::vector<std::uint8_t> all(prefix.begin(), prefix.end());
  all.insert(all.end(), bytes.begin(), bytes.end());
  for (std::size_t i = 0; i < all.size();) {
    const std::uint8_t control = all[i++];
    if (control == control_one_command && i < all.size()) {
      c.take_command(all[i++]);
      continue;
    }
    if (control == control_data) c.expect_idle();
    if (control != control_more_commands && control != control_data) {
      c.breach("byte " + hex(control) + " is no control byte, or nothing follows it");
      return {};
    }
    // Without continuation bit the rest of the transaction is of this kind.
    while (i < all.size()) {
      if (control == control_data) {
        c.take_data(all[i++]);
      } else {
        c.take_command(all[i++]);
      }
    }
  }
  return {};
}

}  // namespace hal::mock
