// SPDX-License-Identifier: MIT
#include <hal/mock/strict_ssd1306.hpp>

namespace hal::mock {

StrictSsd1306::StrictSsd1306(int width, int height, int column_offset, std::uint8_t i2c_address,
                             int memory_columns)
    : StrictController(i2c_address),
      width_(width),
      height_(height),
      column_offset_(column_offset),
      memory_columns_(memory_columns),
      memory_(noise_bytes(54321, std::size_t{columns} * pages)) {}

int StrictSsd1306::parameters(std::uint8_t command) const {
  const auto between = [command](int low, int high) { return command >= low && command <= high; };
  if (between(0x00, 0x1F) || between(0x40, 0x7F) || between(0xB0, 0xB7)) return 0;
  switch (command) {
    case 0x2E:
    case 0x2F:
    case 0xA0:
    case 0xA1:
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7:
    case 0xAE:
    case 0xAF:
    case 0xC0:
    case 0xC8:
    case 0xE3:
      return 0;
    case 0x20:
    case 0x81:
    case 0x8D:
    case 0xA8:
    case 0xAD:
    case 0xD3:
    case 0xD5:
    case 0xD9:
    case 0xDA:
    case 0xDB:
      return 1;
    case 0x21:
    case 0x22:
      return 2;
    default:
      return -1;
  }
}

void StrictSsd1306::execute(std::uint8_t command, const std::vector<std::uint8_t>& given) {
  if (command <= 0x0F) {
    window_.column.at = (window_.column.at & 0xF0) | command;
  } else if (command <= 0x1F) {
    window_.column.at = (window_.column.at & 0x0F) | (command & 0x0F) << 4;
  } else if (command >= 0x40 && command <= 0x7F) {
    start_line_ = command & 63;
  } else if (command >= 0xB0 && command <= 0xB7) {
    window_.row.at = command & 7;
  } else if (command == 0x20) {
    if (in_range(command, given[0], 0, 2)) addressing_ = static_cast<Addressing>(given[0]);
  } else if (command == 0x21) {
    if (in_range(command, given[0], 0, memory_columns_ - 1) &&
        in_range(command, given[1], given[0], memory_columns_ - 1))
      window_.column = {given[0], given[1], given[0]};
  } else if (command == 0x22) {
    if (in_range(command, given[0], 0, pages - 1) && in_range(command, given[1], given[0], pages - 1))
      window_.row = {given[0], given[1], given[0]};
  } else if (command == 0x81) {
    contrast_ = given[0];
  } else if (command == 0x8D) {
    if ((given[0] & 0xFBU) != 0x10) breach("the charge pump has one bit, beside one that is always set");
  } else if (command == 0xA8) {
    in_range(command, given[0], 15, 63);
  } else if (command == 0xD3) {
    in_range(command, given[0], 0, 63);
  } else if (command == 0xD9) {  // Two phases of at least a clock.
    in_range(command, given[0] & 15, 1, 15);
    in_range(command, given[0] >> 4, 1, 15);
  } else if (command == 0xDA) {
    if ((given[0] & 0xCFU) != 0x02) breach("the row pins have two bits, beside one that is always set");
  } else if (command == 0xA0 || command == 0xA1) {
    segments_reversed_ = command == 0xA1;
  } else if (command == 0xA4 || command == 0xA5) {
    all_on_ = command == 0xA5;
  } else if (command == 0xA6 || command == 0xA7) {
    inverse_ = command == 0xA7;
  } else if (command == 0xAE || command == 0xAF) {
    on_ = command == 0xAF;
  } else if (command == 0xC0 || command == 0xC8) {
    rows_reversed_ = command == 0xC8;
  }
}

void StrictSsd1306::store(std::uint8_t byte) {
  if (window_.column.at >= memory_columns_) {
    breach("data beyond the end of page " + std::to_string(window_.row.at));
    return;
  }
  memory_[static_cast<std::size_t>(window_.row.at * columns + window_.column.at)] = byte;
  if (addressing_ == Addressing::page) {
    ++window_.column.at;
  } else {
    window_.next(addressing_ == Addressing::vertical);
  }
}

int StrictSsd1306::stored(int x, int y) const {
  // Reversed against how the glass is mounted, columns count from the other end of the memory.
  const bool mounted_reversed = width_ >= 128;
  const int near = column_offset_ + x;
  const int column = segments_reversed_ == mounted_reversed ? near : memory_columns_ - 1 - near;
  const int row = ((rows_reversed_ ? y : height_ - 1 - y) + start_line_) % 64;
  const auto place = static_cast<std::size_t>(row / 8 * columns + column);
  return memory_[place] >> static_cast<unsigned>(row % 8) & 1;
}

Pattern StrictSsd1306::displayed() const {
  Pattern picture = Pattern::blank(width_, height_);
  if (!on_) return picture;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const int lit = all_on_ ? 1 : stored(x, y);
      picture.at(x, y) = inverse_ ? 1 - lit : lit;
    }
  return picture;
}

}  // namespace hal::mock
