// SPDX-License-Identifier: MIT
//
// An SSD0323 with a glass of 128x64 pixels of 16 greys, as its data sheet describes it: display memory of 80
// rows of 64 bytes, window and address counter, remapping of columns, nibbles and rows. Besides what every
// strict controller reports: data without a window, more bytes than the window has, a new window before the
// last is full.
#pragma once

#include <hal/mock/strict_controller.hpp>

#include <array>

namespace hal::mock {

class StrictSsd0323 final : public StrictController {
 public:
  static constexpr int width = 128;
  static constexpr int height = 64;

  /// At power-on: memory full of noise, display off.
  StrictSsd0323();
  ~StrictSsd0323() override = default;

  [[nodiscard]] Pattern displayed() const override;
  [[nodiscard]] int beam_row(int step) const override {
    return (remap_ & remap_row) != 0 ? step : height - 1 - step;
  }
  /// The same whether or not the display is on.
  [[nodiscard]] Pattern memory() const;
  [[nodiscard]] bool on() const { return on_; }

 private:
  static constexpr int columns = 64;
  static constexpr int rows = 80;
  // Bits of the remap register.
  static constexpr unsigned remap_column = 1;
  static constexpr unsigned remap_nibble = 2;
  static constexpr unsigned vertical_increment = 4;
  static constexpr unsigned remap_row = 16;

  [[nodiscard]] int parameters(std::uint8_t command) const override;
  void execute(std::uint8_t command, const std::vector<std::uint8_t>& parameters) override;
  void store(std::uint8_t byte) override;
  void set_window(std::uint8_t command, int first, int last, int limit, int& begin, int& end);

  std::array<std::uint8_t, std::size_t{columns} * rows> memory_{};
  int column_begin_ = 0, column_end_ = columns - 1, row_begin_ = 0, row_end_ = rows - 1;
  int column_ = 0;
  int row_ = 0;
  int left_in_window_ = 0;
  bool window_started_ = false;
  unsigned remap_ = 0;
  int start_line_ = 0;
  bool on_ = false;
  std::uint8_t mode_ = 0xA4;
};

}  // namespace hal::mock
