// SPDX-License-Identifier: MIT
//
// Source: Solomon Systech SSD1322 data sheet, rev. 1.2, chapters 8.7 "Graphic display data RAM", 9 "Command
// table" and 10 "Command descriptions".
#include <hal/mock/strict_ssd1322.hpp>

namespace hal::mock {

StrictSsd1322::StrictSsd1322()
    : StrictGreyOled(0, Parameters::as_data,
                     {width, height, columns, rows, 2, vertical_increment, 0xA6, 0xA4}, 24680) {}

int StrictSsd1322::parameters(std::uint8_t command) const {
  switch (command) {
    case 0x00:  // Use the grey table.
    case 0x5C:  // Write.
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7:  // All off, all on, normal, inverse.
    case 0xA9:  // The whole display.
    case 0xAE:
    case 0xAF:  // Display off, on.
    case 0xB9:  // Linear greys.
      return 0;
    case 0xA1:
    case 0xA2:
    case 0xAB:
    case 0xB1:
    case 0xB3:
    case 0xB5:
    case 0xB6:
    case 0xBB:
    case 0xBE:
    case 0xC1:
    case 0xC7:
    case 0xCA:
    case 0xFD:
      return 1;
    case 0x15:
    case 0x75:
    case 0xA0:
    case 0xA8:
    case 0xB4:
    case 0xD1:
      return 2;
    case 0xB8:
      return 15;
    default:
      return -1;
  }
}

void StrictSsd1322::set_grey_table(const std::vector<std::uint8_t>& widths) {
  int last = -1;
  for (const std::uint8_t light : widths) {
    in_range(0xB8, light, last + 1, 180);
    last = light;
  }
  grey_table_ = widths;
  grey_table_used_ = false;
}

void StrictSsd1322::execute(std::uint8_t command, const std::vector<std::uint8_t>& given) {
  end_write();
  if (command == 0xFD) {
    if (given[0] != 0x12) in_range(command, given[0], 0x16, 0x16);
    locked_ = given[0] == 0x16;
    return;
  }
  if (locked_) {
    breach("a command while commands are locked");
    return;
  }
  switch (command) {
    case 0x00:
      if (grey_table_.empty()) breach("a grey table is used that wasn't set");
      grey_table_used_ = !grey_table_.empty();
      break;
    case 0x15:
      set_side(command, given, columns, window_.column);
      break;
    case 0x75:
      set_side(command, given, rows, window_.row);
      break;
    case 0x5C:
      writing_ = true;
      left_ = window_bytes();
      break;
    case 0xA0:
      in_range(command, given[0] & 0xC8, 0, 0);
      if ((given[1] & 0xEFU) != 1) breach("the second remap register has no such bits");
      if ((given[1] & 0x10U) != 0 && ((given[0] & split_rows) != 0 || rows_driven_ > 64))
        breach("two rows at once, but they are split or more than 64");
      remap_ = given[0];
      break;
    case 0xAF:
      if (rows_driven_ != height) breach("the display is on, but not all rows of the glass are driven");
      StrictGreyOled::execute(command, given);
      break;
    case 0xB1:  // Phases of at least 5 and 3 clocks.
      in_range(command, given[0] & 15, 2, 15);
      in_range(command, given[0] >> 4, 3, 15);
      break;
    case 0xB8:
      set_grey_table(given);
      break;
    case 0xB9:
      grey_table_used_ = false;
      break;
    case 0xBB:
      in_range(command, given[0], 0, 31);
      break;
    case 0xBE:
      in_range(command, given[0], 0, 7);
      break;
    case 0xC1:
      contrast_ = given[0];
      break;
    case 0xC7:
      in_range(command, given[0], 0, 15);
      break;
    case 0xCA:
      if (in_range(command, given[0], 15, rows - 1)) rows_driven_ = given[0] + 1;
      break;
    default:
      StrictGreyOled::execute(command, given);
      break;
  }
}

void StrictSsd1322::end_write() {
  if (!take_fault() && writing_ && left_ != 0)
    breach("a window is left with " + std::to_string(left_) + " bytes missing");
  writing_ = false;
}

void StrictSsd1322::store(std::uint8_t byte) {
  if (!writing_) {
    breach("data that no command asked for");
    return;
  }
  if (left_ == 0) {
    breach("more data than the window has");
    return;
  }
  --left_;
  put(byte);
}

int StrictSsd1322::nibble_of(int x) const {
  int segment = 4 * first_column + x;
  if ((remap_ & remap_column) != 0) segment = 4 * columns - 1 - segment;
  // The four nibbles of a column run from the first byte's high one with nibble remap, else backwards.
  return (remap_ & remap_nibble) != 0 ? segment : segment / 4 * 4 + 3 - segment % 4;
}

int StrictSsd1322::pulse_width(int grey) const {
  if (grey == 0) return 0;
  // The table at power-on: 0, 8, 16 … 112.
  return grey_table_used_ ? grey_table_[static_cast<std::size_t>(grey - 1)] : (grey - 1) * 8;
}

}  // namespace hal::mock
