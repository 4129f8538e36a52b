// SPDX-License-Identifier: MIT
//
// What Solomon's controllers of grey OLEDs have in common (SSD0323, SSD1322): a byte of display memory holds
// two pixels of 16 greys, whose place on the glass the remap register and the start line say; commands A1h,
// A2h, A4h to A7h, AEh and AFh.
#pragma once

#include <hal/mock/address_window.hpp>
#include <hal/mock/strict_controller.hpp>

namespace hal::mock {

class StrictGreyOled : public StrictController {
 public:
  ~StrictGreyOled() override = default;

  [[nodiscard]] Pattern displayed() const final;
  /// The glass is mounted for row remapping; without it the picture stands on its head.
  [[nodiscard]] int beam_row(int step) const final {
    return (remap_ & remap_row) != 0 ? step : chip_.height - 1 - step;
  }
  /// The same whether or not the display is on.
  [[nodiscard]] Pattern memory() const;
  [[nodiscard]] bool on() const { return on_; }

 protected:
  /// In what they differ.
  struct Chip {
    int width, height;             // Of the glass.
    int columns, rows;             // Of the memory.
    int column_bytes;              // Of a column of a row.
    unsigned downwards;            // The bit of the remap register for counting rows first.
    std::uint8_t normal, all_off;  // Two of A4h, A6h; A5h is all on, A7h inverse.
  };

  /// At power-on: memory full of noise, display off.
  StrictGreyOled(std::uint8_t i2c_address, Parameters travel, const Chip& chip, unsigned noise);

  /// Which of a row's nibbles, from the first byte's high one on, is seen in column x of the glass.
  [[nodiscard]] virtual int nibble_of(int x) const = 0;

  /// Sets a side of the window, from which on data go to its first byte. False: it can't be.
  bool set_side(std::uint8_t command, const std::vector<std::uint8_t>& given, int limit,
                AddressWindow::Axis& side);
  /// Bytes that the window takes.
  [[nodiscard]] int window_bytes() const { return chip_.column_bytes * window_.places(); }
  void put(std::uint8_t byte);
  /// A command that they have in common, or that has no effect here.
  void execute(std::uint8_t command, const std::vector<std::uint8_t>& given) override;

  AddressWindow window_;
  unsigned remap_ = 0;

 private:
  static constexpr unsigned remap_row = 16;

  Chip chip_;
  std::vector<std::uint8_t> memory_;
  int byte_ = 0;  // Of the column.
  int start_line_ = 0;
  bool on_ = false;
  std::uint8_t mode_;
};

}  // namespace hal::mock
