// SPDX-License-Identifier: MIT
//
// An SSD0323 with a glass of 128x64 pixels of 16 greys, as its data sheet describes it: display memory of 80
// rows of 64 bytes, window and address counter, remapping of columns, nibbles and rows. Besides what every
// strict controller reports: data without a window, more bytes than the window has, a new window before the
// last is full.
#pragma once

#include <hal/mock/strict_grey_oled.hpp>

namespace hal::mock {

class StrictSsd0323 final : public StrictGreyOled {
 public:
  static constexpr int width = 128;
  static constexpr int height = 64;

  StrictSsd0323();
  ~StrictSsd0323() override = default;

 private:
  static constexpr int columns = 64;
  static constexpr int rows = 80;
  // Bits of the remap register.
  static constexpr unsigned remap_column = 1;
  static constexpr unsigned remap_nibble = 2;
  static constexpr unsigned vertical_increment = 4;

  [[nodiscard]] int parameters(std::uint8_t command) const override;
  void execute(std::uint8_t command, const std::vector<std::uint8_t>& given) override;
  void store(std::uint8_t byte) override;
  [[nodiscard]] int nibble_of(int x) const override;
  void set_window(std::uint8_t command, const std::vector<std::uint8_t>& given, int limit,
                  AddressWindow::Axis& side);

  int left_in_window_ = 0;  // Bytes.
  bool window_started_ = false;
};

}  // namespace hal::mock
