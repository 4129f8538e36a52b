// SPDX-License-Identifier: MIT
#include <hal/mock/strict_ssd0323.hpp>

namespace hal::mock {

StrictSsd0323::StrictSsd0323() : StrictController(0x3D) {
  unsigned noise = 12345;
  for (std::uint8_t& byte : memory_) {
    noise = noise * 1103515245U + 12345U;
    byte = static_cast<std::uint8_t>(noise >> 16U);
  }
}

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

void StrictSsd0323::set_window(std::uint8_t command, int first, int last, int limit, int& begin, int& end) {
  if (!in_range(command, first, 0, limit - 1) || !in_range(command, last, first, limit - 1)) return;
  const int inside = (column_end_ - column_begin_ + 1) * (row_end_ - row_begin_ + 1);
  if (!take_fault() && window_started_ && left_in_window_ != 0)
    breach("a new window before the last was full: " + std::to_string(left_in_window_) + " of " +
           std::to_string(inside) + " bytes are missing");
  begin = first;
  end = last;
  column_ = column_begin_;
  row_ = row_begin_;
  window_started_ = false;
  left_in_window_ = (column_end_ - column_begin_ + 1) * (row_end_ - row_begin_ + 1);
}

void StrictSsd0323::execute(std::uint8_t command, const std::vector<std::uint8_t>& given) {
  switch (command) {
    case 0x15:
      set_window(command, given[0], given[1], columns, column_begin_, column_end_);
      break;
    case 0x75:
      set_window(command, given[0], given[1], rows, row_begin_, row_end_);
      break;
    case 0x81:
      in_range(command, given[0], 0, 127);
      break;
    case 0xA0:
      remap_ = given[0];
      break;
    case 0xA1:
      if (in_range(command, given[0], 0, rows - 1)) start_line_ = given[0];
      break;
    case 0xA2:
      in_range(command, given[0], 0, rows - 1);
      break;
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7:
      mode_ = command;
      break;
    case 0xA8:
      in_range(command, given[0], 15, rows - 1);
      break;
    case 0xAE:
    case 0xAF:
      on_ = command == 0xAF;
      break;
    default:
      break;
  }
}

void StrictSsd0323::store(std::uint8_t byte) {
  if (left_in_window_ == 0) breach("more data than the window has bytes");
  left_in_window_ -= left_in_window_ > 0 ? 1 : 0;
  window_started_ = true;
  memory_[static_cast<std::size_t>(row_ * columns + column_)] = byte;
  const auto step = [](int& at, int begin, int end) {
    if (++at <= end) return false;
    at = begin;
    return true;
  };
  if ((remap_ & vertical_increment) != 0) {
    if (step(row_, row_begin_, row_end_)) step(column_, column_begin_, column_end_);
  } else {
    if (step(column_, column_begin_, column_end_)) step(row_, row_begin_, row_end_);
  }
}

Pattern StrictSsd0323::memory() const {
  Pattern picture = Pattern::blank(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      // The glass is mounted for row remapping; without it the picture stands on its head.
      const int line = (remap_ & remap_row) != 0 ? y : height - 1 - y;
      // Whole columns of two pixels are remapped; with their nibbles remapped too the row is mirrored.
      const int column = (remap_ & remap_column) != 0 ? columns - 1 - x / 2 : x / 2;
      const auto place = static_cast<std::size_t>((line + start_line_) % rows * columns + column);
      const bool high = (x % 2 == 0) == ((remap_ & remap_nibble) != 0);
      picture.at(x, y) = high ? memory_[place] >> 4U : memory_[place] & 15U;
    }
  return picture;
}

Pattern StrictSsd0323::displayed() const {
  Pattern picture = Pattern::blank(width, height);
  if (!on_ || mode_ == 0xA6) return picture;
  picture = memory();
  for (int& pixel : picture.pixels) {
    if (mode_ == 0xA5) pixel = 15;
    if (mode_ == 0xA7) pixel = 15 - pixel;
  }
  return picture;
}

}  // namespace hal::mock
