// SPDX-License-Identifier: MIT
//
// An SSD1322 with a glass of 256x64 pixels of 16 greys on columns 28 to 91, as its data sheet describes it:
// display memory of 128 rows of 120 columns of four pixels, window and address counter, remapping of columns,
// nibbles and rows, grey table, command lock. Besides what every strict controller reports: data that no
// command asked for, more bytes than the window has, a window left before it is full, commands while locked,
// a grey table that doesn't rise, two rows at once with more rows than it can, a display switched on with a
// multiplex ratio that isn't the glass's.
#pragma once

#include <hal/mock/strict_grey_oled.hpp>

namespace hal::mock {

class StrictSsd1322 final : public StrictGreyOled {
 public:
  static constexpr int width = 256;
  static constexpr int height = 64;

  StrictSsd1322();
  ~StrictSsd1322() override = default;

  [[nodiscard]] int contrast() const { return contrast_; }
  /// Light of grey 0..15 in 1/180.
  [[nodiscard]] int pulse_width(int grey) const;

 private:
  static constexpr int columns = 120;
  static constexpr int rows = 128;
  static constexpr int first_column = 28;
  // Bits of the remap register.
  static constexpr unsigned vertical_increment = 1;
  static constexpr unsigned remap_column = 2;
  static constexpr unsigned remap_nibble = 4;
  static constexpr unsigned split_rows = 32;

  [[nodiscard]] int parameters(std::uint8_t command) const override;
  void execute(std::uint8_t command, const std::vector<std::uint8_t>& given) override;
  void store(std::uint8_t byte) override;
  [[nodiscard]] int nibble_of(int x) const override;
  void set_grey_table(const std::vector<std::uint8_t>& widths);
  void end_write();

  int left_ = 0;  // Bytes of the window that haven't come yet.
  bool writing_ = false;
  int rows_driven_ = rows;
  std::vector<std::uint8_t> grey_table_;
  bool grey_table_used_ = false;
  bool locked_ = false;
  int contrast_ = 127;
};

}  // namespace hal::mock
