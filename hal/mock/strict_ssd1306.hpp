// SPDX-License-Identifier: MIT
//
// An SSD1306, SH1106 or SSD0303 with its glass, as the data sheets describe them: display memory in pages of
// eight rows, a byte a column with bit 0 on top; page, horizontal and vertical addressing.
// Besides what every strict controller reports: running over the end of a page in page addressing mode.
#pragma once

#include <hal/mock/address_window.hpp>
#include <hal/mock/strict_controller.hpp>

namespace hal::mock {

class StrictSsd1306 final : public StrictController {
 public:
  /// A glass of width x height pixels whose first column is memory column `column_offset` of
  /// `memory_columns`: as it is mounted, which is for reversed rows, and for reversed segments if it is 128
  /// pixels wide.
  StrictSsd1306(int width, int height, int column_offset = 0, std::uint8_t i2c_address = 0x3C,
                int memory_columns = 128);
  ~StrictSsd1306() override = default;

  [[nodiscard]] Pattern displayed() const override;
  [[nodiscard]] int beam_row(int step) const override { return rows_reversed_ ? step : height_ - 1 - step; }
  [[nodiscard]] bool on() const { return on_; }
  [[nodiscard]] int contrast() const { return contrast_; }

 private:
  static constexpr int columns = 132;  // Of the largest relative.
  static constexpr int pages = 8;
  enum class Addressing : std::uint8_t { horizontal, vertical, page };

  [[nodiscard]] int parameters(std::uint8_t command) const override;
  void execute(std::uint8_t command, const std::vector<std::uint8_t>& parameters) override;
  void store(std::uint8_t byte) override;
  /// What the memory holds for a pixel of the glass.
  [[nodiscard]] int stored(int x, int y) const;

  int width_;
  int height_;
  int column_offset_;
  int memory_columns_;
  std::vector<std::uint8_t> memory_;
  Addressing addressing_ = Addressing::page;
  AddressWindow window_{{0, columns - 1}, {0, pages - 1}};  // Its rows are pages.
  int start_line_ = 0;
  bool segments_reversed_ = false;
  bool rows_reversed_ = false;
  bool inverse_ = false;
  bool all_on_ = false;
  bool on_ = false;
  int contrast_ = 128;
};

}  // namespace hal::mock
