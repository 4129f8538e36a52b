// SPDX-License-Identifier: MIT
#include <hal/mock/strict_ssd0323.hpp>

namespace hal::mock {

StrictSsd0323::StrictSsd0323()
    : StrictGreyOled(0x3D, Parameters::as_commands,
                     {width, height, columns, rows, 1, vertical_increment, 0xA4, 0xA6}, 12345) {}

int StrictSsd0323::parameters(std::uint8_t command) const {
  switch (command) {
    case 0x84:
    case 0x85:
    case 0x86:  // Current range.
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7:  // Normal, all on, all off, inverse.
    case 0xAE:
    case 0xAF:
    case 0xE3:  // Display off, on; no operation.
      return 0;
    case 0x81:
    case 0xA0:
    case 0xA1:
    case 0xA2:
    case 0xA8:
    case 0xAD:
    case 0xB0:
    case 0xB1:
    case 0xB2:
    case 0xB3:
    case 0xB4:
    case 0xBC:
    case 0xBE:
    case 0xBF:
      return 1;
    case 0x15:
    case 0x75:  // Column and row window.
      return 2;
    case 0xB8:  // Grey scale table.
      return 8;
    default:
      return -1;
  }
}

void StrictSsd0323::set_window(std::uint8_t command, const std::vector<std::uint8_t>& given, int limit,
                               AddressWindow::Axis& side) {
  const int inside = window_bytes();
  if (!set_side(command, given, limit, side)) return;
  if (!take_fault() && window_started_ && left_in_window_ != 0)
    breach("a new window before the last was full: " + std::to_string(left_in_window_) + " of " +
           std::to_string(inside) + " bytes are missing");
  window_started_ = false;
  left_in_window_ = window_bytes();
}

void StrictSsd0323::execute(std::uint8_t command, const std::vector<std::uint8_t>& given) {
  switch (command) {
    case 0x15:
      set_window(command, given, columns, window_.column);
      break;
    case 0x75:
      set_window(command, given, rows, window_.row);
      break;
    case 0x81:
      in_range(command, given[0], 0, 127);
      break;
    case 0xA0:
      remap_ = given[0];
      break;
    case 0xA8:
      in_range(command, given[0], 15, rows - 1);
      break;
    default:
      StrictGreyOled::execute(command, given);
      break;
  }
}

void StrictSsd0323::store(std::uint8_t byte) {
  if (left_in_window_ == 0) breach("more data than the window has bytes");
  left_in_window_ -= left_in_window_ > 0 ? 1 : 0;
  window_started_ = true;
  put(byte);
}

int StrictSsd0323::nibble_of(int x) const {
  // Whole columns of two pixels are remapped; with their nibbles remapped too the row is mirrored.
  const int column = (remap_ & remap_column) != 0 ? columns - 1 - x / 2 : x / 2;
  const bool high = (x % 2 == 0) == ((remap_ & remap_nibble) != 0);
  return 2 * column + (high ? 0 : 1);
}

}  // namespace hal::mock
