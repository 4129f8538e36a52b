// SPDX-License-Identifier: MIT
#include <hal/mock/strict_grey_oled.hpp>

namespace hal::mock {

StrictGreyOled::StrictGreyOled(std::uint8_t i2c_address, Parameters travel, const Chip& chip, unsigned noise)
    : StrictController(i2c_address, travel),
      window_{{0, chip.columns - 1}, {0, chip.rows - 1}},
      chip_(chip),
      mode_(chip.normal) {
  memory_ = noise_bytes(noise, static_cast<std::size_t>(chip.column_bytes * chip.columns * chip.rows));
}

bool StrictGreyOled::set_side(std::uint8_t command, const std::vector<std::uint8_t>& given, int limit,
                              AddressWindow::Axis& side) {
  if (!in_range(command, given[0], 0, limit - 1) || !in_range(command, given[1], given[0], limit - 1))
    return false;
  side.begin = given[0];
  side.end = given[1];
  window_.restart();
  byte_ = 0;
  return true;
}

void StrictGreyOled::put(std::uint8_t byte) {
  const int column = window_.row.at * chip_.columns + window_.column.at;
  memory_[static_cast<std::size_t>(column * chip_.column_bytes + byte_)] = byte;
  byte_ = (byte_ + 1) % chip_.column_bytes;
  if (byte_ == 0) window_.next((remap_ & chip_.downwards) != 0);
}

void StrictGreyOled::execute(std::uint8_t command, const std::vector<std::uint8_t>& given) {
  switch (command) {
    case 0xA1:
      if (in_range(command, given[0], 0, chip_.rows - 1)) start_line_ = given[0];
      break;
    case 0xA2:
      in_range(command, given[0], 0, chip_.rows - 1);
      break;
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7:
      mode_ = command;
      break;
    case 0xAE:
    case 0xAF:
      on_ = command == 0xAF;
      break;
    default:
      break;
  }
}

Pattern StrictGreyOled::memory() const {
  Pattern picture = Pattern::blank(chip_.width, chip_.height);
  for (int y = 0; y < chip_.height; ++y) {
    const int row = (beam_row(y) + start_line_) % chip_.rows;
    for (int x = 0; x < chip_.width; ++x) {
      const int nibble = nibble_of(x);
      const auto place = static_cast<std::size_t>(row * chip_.columns * chip_.column_bytes + nibble / 2);
      picture.at(x, y) = nibble % 2 == 0 ? memory_[place] >> 4U : memory_[place] & 15U;
    }
  }
  return picture;
}

Pattern StrictGreyOled::displayed() const {
  if (!on_ || mode_ == chip_.all_off) return Pattern::blank(chip_.width, chip_.height);
  Pattern picture = memory();
  for (int& pixel : picture.pixels) {
    if (mode_ == 0xA5) pixel = 15;
    if (mode_ == 0xA7) pixel = 15 - pixel;
  }
  return picture;
}

}  // namespace hal::mock
