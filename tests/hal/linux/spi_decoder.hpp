// SPDX-License-Identifier: MIT
//
// Reads the bytes of SPI (mode 0) back from changes of lines, as the controller at their ends would.
#pragma once

#include "fake_gpio.hpp"

#include <hal/bus.hpp>
#include <hal/pin.hpp>

#include <gtest/gtest.h>

namespace fake_gpio {

struct SpiLines {
  unsigned clock = 0, data = 0, select = 0, data_command = 0;
  bool selected_always = false;
};

class SpiDecoder {
 public:
  /// Whole bytes go to `bus`, the state of data/command to `pin` before them.
  SpiDecoder(const SpiLines& lines, hal::SpiBus& bus, hal::OutputPin& pin)
      : lines_(lines), bus_(&bus), pin_(&pin) {}

  void operator()(const Chip& chip) {
    const auto level = [&chip](unsigned line) { return chip.lines.at(line).value != 0; };
    const bool selected = lines_.selected_always || !level(lines_.select);
    if (!selected) {
      EXPECT_EQ(bits_, 0) << "deselected in the middle of a byte";
      bits_ = 0;
    }
    const bool clock = level(lines_.clock);
    if (selected && clock && !clock_) take_bit(level(lines_.data), level(lines_.data_command));
    // Both at once is no moment to read data, but for the clock's falling edge.
    EXPECT_FALSE(clock && clock_ && level(lines_.data) != data_) << "data changed while the clock was high";
    clock_ = clock;
    data_ = level(lines_.data);
  }

 private:
  void take_bit(bool bit, bool is_data) {
    EXPECT_EQ(bit, data_) << "data weren't there before the clock rose";
    byte_ = static_cast<std::uint8_t>(static_cast<unsigned>(byte_) << 1U | (bit ? 1U : 0U));
    if (++bits_ < 8) return;
    bits_ = 0;
    EXPECT_TRUE(pin_->set(is_data).ok());
    EXPECT_TRUE(bus_->write({&byte_, 1}).ok());
  }

  SpiLines lines_;
  hal::SpiBus* bus_;
  hal::OutputPin* pin_;
  int bits_ = 0;
  std::uint8_t byte_ = 0;
  bool clock_ = false;
  bool data_ = false;
};

}  // namespace fake_gpio
