// SPDX-License-Identifier: MIT
//
// Source: Sitronix ST7789V data sheet, version 1.3, and ILI9341 data sheet, version 1.11, at the commands
// named below and under "Address control" and "Sleep out / sleep in".
#include <hal/mock/strict_dcs.hpp>

namespace hal::mock {

namespace {

constexpr unsigned row_order = 0x80;
constexpr unsigned column_order = 0x40;
constexpr unsigned exchanged = 0x20;
constexpr unsigned vertical_order = 0x10;
constexpr unsigned bgr_order = 0x08;

constexpr Nanoseconds millisecond = 1'000'000;

}  // namespace

StrictDcs::StrictDcs(hal::Clock& clock, const DcsGlass& glass)
    : StrictController(0, Parameters::as_data), clock_(&clock), glass_(glass) {
  unsigned noise = 98765;
  for (int i = 0; i < memory_width * memory_height; ++i) {
    noise = noise * 1103515245U + 12345U;
    memory_.push_back(static_cast<std::uint16_t>(noise >> 16U));
  }
  hardware_reset();
}

void StrictDcs::hardware_reset() {
  set_defaults();
  last_pause_ = last_sleep_ = clock_->now();
}

void StrictDcs::set_defaults() {
  mode_ = 0;
  window_ = {{0, memory_width - 1}, {0, memory_height - 1}};
  writing_ = false;
  left_ = bit_count_ = 0;
  format_ = 6;
  inverted_ = on_ = false;
  asleep_ = true;
  tearing_ = Tearing::off;
  tearing_line_ = brightness_ = 0;
  brightness_controlled_ = false;
}

int StrictDcs::parameters(std::uint8_t command) const {
  switch (command) {
    case 0x00:
    case 0x01:
    case 0x10:
    case 0x11:
    case 0x12:
    case 0x13:
    case 0x20:
    case 0x21:
    case 0x28:
    case 0x29:
    case 0x2C:
    case 0x34:
    case 0x38:
    case 0x39:
    case 0x3C:
      return 0;
    case 0x26:
    case 0x35:
    case 0x36:
    case 0x3A:
    case 0x51:
    case 0x53:
    case 0x55:
    case 0x5E:
      return 1;
    case 0x37:
    case 0x44:
      return 2;
    case 0x2A:
    case 0x2B:
    case 0x30:
      return 4;
    case 0x33:
      return 6;
    default:
      return -1;
  }
}

void StrictDcs::pause(std::uint8_t command) {
  if (clock_->now() - last_pause_ < 5 * millisecond)
    breach("command " + std::to_string(command) + " within 5 ms after a reset or a change of sleep");
}

void StrictDcs::change_sleep(std::uint8_t command) {
  const bool asleep = command == 0x10;
  if (asleep == asleep_) return;
  if (clock_->now() - last_sleep_ < 120 * millisecond)
    breach("sleep is changed within 120 ms after the last change or a reset");
  asleep_ = asleep;
  last_pause_ = last_sleep_ = clock_->now();
}

void StrictDcs::execute(std::uint8_t command, const std::vector<std::uint8_t>& given) {
  pause(command);
  end_pixels();
  switch (command) {
    case 0x01:
      if (!asleep_ && clock_->now() - last_sleep_ < 120 * millisecond)
        breach("a reset within 120 ms after the end of sleep");
      set_defaults();
      last_pause_ = last_sleep_ = clock_->now();
      break;
    case 0x10:
    case 0x11:
      change_sleep(command);
      break;
    case 0x20:
    case 0x21:
      inverted_ = command == 0x21;
      break;
    case 0x26:
      if (given[0] != 1 && given[0] != 2 && given[0] != 4) in_range(command, given[0], 8, 8);
      break;
    case 0x28:
    case 0x29:
      on_ = command == 0x29;
      break;
    case 0x2A:
    case 0x2B:
      set_window(command, given);
      break;
    case 0x2C:
      begin_pixels();
      break;
    case 0x3C:
      breach("a write is continued, which no driver here does");
      break;
    case 0x34:
      tearing_ = Tearing::off;
      break;
    case 0x35:
      if (!in_range(command, given[0], 0, 1)) break;
      tearing_ = given[0] == 0 ? Tearing::vblank : Tearing::vblank_and_hblank;
      tearing_line_ = 0;
      break;
    case 0x36:
      if ((given[0] & 3U) != 0) breach("bits 0 and 1 of the address mode are none");
      mode_ = given[0];
      break;
    case 0x3A:
      if (takes_format(given[0] & 7) && (given[0] & 0x88U) == 0) {
        format_ = given[0] & 7;
      } else {
        breach("there is no pixel format " + std::to_string(given[0]));
      }
      break;
    case 0x44:
      if (in_range(command, given[0] * 256 + given[1], 0, memory_height - 1)) {
        tearing_line_ = given[0] * 256 + given[1];
        tearing_ = Tearing::vblank;  // Line 0 is the VBLANK, and nothing is told between lines.
      }
      break;
    case 0x51:
      brightness_ = given[0];
      break;
    case 0x53:
      if ((given[0] & 0xD3U) != 0) breach("the control of the brightness has bits 2, 3 and 5 alone");
      brightness_controlled_ = (given[0] & 0x24U) == 0x24U;
      break;
    default:
      if (StrictDcs::parameters(command) < 0) execute_own(command, given);
      break;
  }
}

void StrictDcs::set_window(std::uint8_t command, const std::vector<std::uint8_t>& given) {
  const int first = given[0] * 256 + given[1];
  const int last = given[2] * 256 + given[3];
  const bool long_side = ((mode_ & exchanged) != 0) == (command == 0x2A);
  const int limit = long_side ? memory_height : memory_width;
  if (!in_range(command, first, 0, limit - 1) || !in_range(command, last, first, limit - 1)) return;
  (command == 0x2A ? window_.column : window_.row) = {first, last, first};
}

void StrictDcs::begin_pixels() {
  window_.restart();
  left_ = window_.places();
  bit_count_ = 0;
  bits_ = 0;
  writing_ = true;
}

void StrictDcs::end_pixels() {
  const bool fault = take_fault();
  if (writing_ && !fault) {
    if (bit_count_ != 0) breach("part of a pixel");
    if (left_ != 0) breach("a window is left with " + std::to_string(left_) + " pixels missing");
  }
  writing_ = false;
}

void StrictDcs::store(std::uint8_t byte) {
  if (!writing_) {
    breach("data that no command asked for");
    return;
  }
  bits_ = bits_ << 8U | byte;
  bit_count_ += 8;
  const int pixel_bits = format_ == 3 ? 12 : format_ == 5 ? 16 : 24;
  if (bit_count_ < pixel_bits) return;
  bit_count_ -= pixel_bits;
  const unsigned pixel = bits_ >> static_cast<unsigned>(bit_count_);
  unsigned red = pixel >> 11U & 31U;
  unsigned green = pixel >> 5U & 63U;
  unsigned blue = pixel & 31U;
  if (format_ == 3) {
    red = (pixel >> 8U & 15U) * 2U + (pixel >> 11U & 1U);
    green = (pixel >> 4U & 15U) * 4U + (pixel >> 6U & 3U);
    blue = (pixel & 15U) * 2U + (pixel >> 3U & 1U);
  } else if (format_ == 6) {
    red = pixel >> 19U & 31U;
    green = pixel >> 10U & 63U;
    blue = pixel >> 3U & 31U;
  }
  put(static_cast<std::uint16_t>(red * 2048U + green * 32U + blue));
}

void StrictDcs::put(std::uint16_t colour) {
  if (left_ == 0) {
    breach("more pixels than the window has");
    return;
  }
  --left_;
  const bool turned = (mode_ & exchanged) != 0;
  int column = (turned ? window_.row : window_.column).at;
  int row = (turned ? window_.column : window_.row).at;
  if ((mode_ & column_order) != 0) column = memory_width - 1 - column;
  if ((mode_ & row_order) != 0) row = memory_height - 1 - row;
  // A window set before the address mode was changed may lie outside.
  if (column < 0 || column >= memory_width || row < 0 || row >= memory_height) {
    breach("a pixel outside the memory");
  } else {
    memory_[static_cast<std::size_t>(row * memory_width + column)] = colour;
  }
  window_.next();
}

std::uint16_t StrictDcs::shown(std::uint16_t colour) const {
  unsigned seen = colour;
  if (inverted_ != glass_.inverted) seen ^= 0xFFFFU;
  if (((mode_ & bgr_order) != 0) != glass_.bgr) seen = (seen & 31U) << 11U | (seen & 0x07E0U) | seen >> 11U;
  return static_cast<std::uint16_t>(seen);
}

Pattern StrictDcs::memory() const {
  Pattern picture = Pattern::blank(glass_.width, glass_.height);
  for (int y = 0; y < glass_.height; ++y)
    for (int x = 0; x < glass_.width; ++x) {
      const int column = glass_.column_offset + (glass_.mirrored ? glass_.width - 1 - x : x);
      const auto place = static_cast<std::size_t>((glass_.row_offset + y) * memory_width + column);
      picture.at(x, y) = shown(memory_[place]);
    }
  return picture;
}

Pattern StrictDcs::displayed() const { return on() ? memory() : Pattern::blank(glass_.width, glass_.height); }

int StrictDcs::beam_row(int step) const {
  return (mode_ & vertical_order) != 0 ? glass_.height - 1 - step : step;
}

int StrictSt7789::parameters(std::uint8_t command) const {
  switch (command) {
    case 0xB5:
    case 0xB7:
    case 0xBA:
    case 0xBB:
    case 0xBD:
    case 0xC0:
    case 0xC3:
    case 0xC4:
    case 0xC5:
    case 0xC6:
    case 0xC7:
    case 0xC8:
    case 0xC9:
    case 0xCA:
    case 0xCC:
    case 0xD2:
    case 0xE7:
    case 0xE8:
    case 0xEC:
    case 0xFC:
    case 0xFE:
      return 1;
    case 0xB0:
    case 0xC2:
    case 0xD0:
      return 2;
    case 0xB1:
    case 0xB3:
    case 0xC1:
    case 0xE4:
    case 0xE9:
      return 3;
    case 0xB8:
    case 0xDF:
    case 0xFA:
      return 4;
    case 0xB2:
      return 5;
    case 0xE0:
    case 0xE1:
      return 14;
    case 0xE2:
    case 0xE3:
      return 64;
    default:
      return StrictDcs::parameters(command);
  }
}

void StrictSt7789::execute_own(std::uint8_t command, const std::vector<std::uint8_t>& given) {
  switch (command) {
    case 0xB2:  // Porches of at least a line.
      in_range(command, given[0], 1, 127);
      in_range(command, given[1], 1, 127);
      break;
    case 0xBB:
    case 0xC3:
    case 0xC4:
      in_range(command, given[0], 0, 63);
      break;
    case 0xC2:
      in_range(command, given[0], 0, 1);
      in_range(command, given[1], 255, 255);
      break;
    case 0xD0:
      in_range(command, given[0], 0xA4, 0xA4);
      break;
    default:
      break;
  }
}

int StrictIli9341::parameters(std::uint8_t command) const {
  switch (command) {
    case 0xB0:
    case 0xB4:
    case 0xB7:
    case 0xB8:
    case 0xB9:
    case 0xBA:
    case 0xBB:
    case 0xBC:
    case 0xBE:
    case 0xBF:
    case 0xC0:
    case 0xC1:
    case 0xC7:
    case 0xF2:
    case 0xF7:
      return 1;
    case 0xB1:
    case 0xB2:
    case 0xB3:
    case 0xC5:
    case 0xEA:
      return 2;
    case 0xCF:
    case 0xD0:
    case 0xE8:
    case 0xF6:
      return 3;
    case 0xB5:
    case 0xB6:
    case 0xED:
      return 4;
    case 0xCB:
      return 5;
    case 0xE0:
    case 0xE1:
      return 15;
    case 0xE2:
      return 16;
    case 0xE3:
      return 64;
    default:
      return StrictDcs::parameters(command);
  }
}

void StrictIli9341::execute_own(std::uint8_t command, const std::vector<std::uint8_t>& given) {
  switch (command) {
    case 0xB1:
      in_range(command, given[0], 0, 3);
      in_range(command, given[1], 16, 31);
      break;
    case 0xB5:  // Porches of at least two lines.
      in_range(command, given[0], 2, 127);
      in_range(command, given[1], 2, 127);
      break;
    case 0xB6:  // Number of lines: 8 * (n + 1).
      in_range(command, given[2], 39, 39);
      break;
    case 0xC0:
      in_range(command, given[0], 3, 63);
      break;
    case 0xC1:
      in_range(command, given[0], 16, 19);
      break;
    case 0xC5:
      in_range(command, given[0], 0, 127);
      in_range(command, given[1], 0, 100);
      break;
    case 0xF7:
      if (given[0] != 0x20) in_range(command, given[0], 0x30, 0x30);
      break;
    default:
      break;
  }
}

}  // namespace hal::mock
