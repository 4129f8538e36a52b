// SPDX-License-Identifier: MIT
//
// An SSD1322 with a glass of 256x64 pixels of 16 greys on columns 28 to 91, as its data sheet describes it:
// display memory of 128 rows of 120 columns of four pixels, window and address counter, remapping of columns,
// nibbles and rows, grey table, command lock. Besides what every strict controller reports: data that no
// command asked for, more bytes than the window has, a window left before it is full, commands while locked,
// a grey table that doesn't rise, two rows at once with more rows than it can, a display switched on with a
// multiplex ratio that isn't the glass's.
#pragma once

#include <hal/mock/strict_controller.hpp>

#include <array>

namespace hal::mock {

class StrictSsd1322 final : public StrictController {
 public:
  static constexpr int width = 256;
  static constexpr int height = 64;

  /// At power-on: memory full of noise, display off.
  StrictSsd1322();
  ~StrictSsd1322() override = default;

  [[nodiscard]] Pattern displayed() const override;
  /// The same whether or not the display is on.
  [[nodiscard]] Pattern memory() const;
  [[nodiscard]] int beam_row(int step) const override {
    return (remap_ & remap_row) != 0 ? step : height - 1 - step;
  }
  [[nodiscard]] bool on() const { return on_; }
  [[nodiscard]] int contrast() const { return contrast_; }
  /// Light of grey 0..15 in 1/180.
  [[nodiscard]] int pulse_width(int grey) const;

 private:
  static constexpr int columns = 120;
  static constexpr int rows = 128;
  static constexpr int first_column = 28;
  static constexpr int row_bytes = 2 * columns;
  // Bits of the remap register.
  static constexpr unsigned vertical_increment = 1;
  static constexpr unsigned remap_column = 2;
  static constexpr unsigned remap_nibble = 4;
  static constexpr unsigned remap_row = 16;
  static constexpr unsigned split_rows = 32;

  [[nodiscard]] int parameters(std::uint8_t command) const override;
  void execute(std::uint8_t command, const std::vector<std::uint8_t>& parameters) override;
  void store(std::uint8_t byte) override;
  void set_range(std::uint8_t command, const std::vector<std::uint8_t>& given, int limit, int& begin,
                 int& end);
  void set_grey_table(const std::vector<std::uint8_t>& widths);
  void end_write();
  void next_column();

  std::array<std::uint8_t, std::size_t{row_bytes} * rows> memory_{};
  int column_begin_ = 0, column_end_ = columns - 1, row_begin_ = 0, row_end_ = rows - 1;
  int column_ = 0;
  int row_ = 0;
  int byte_ = 0;  // Of the column.
  int left_ = 0;  // Bytes of the window that haven't come yet.
  bool writing_ = false;
  unsigned remap_ = 0;
  int start_line_ = 0;
  int rows_driven_ = rows;
  std::vector<std::uint8_t> grey_table_;
  bool grey_table_used_ = false;
  bool locked_ = false;
  bool on_ = false;
  int contrast_ = 127;
  std::uint8_t mode_ = 0xA6;
};

}  // namespace hal::mock
