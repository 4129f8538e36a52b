// SPDX-License-Identifier: MIT
//
// A TFT controller that speaks MIPI DCS, with memory for 240x320 pixels and a glass: what the data sheets of
// the ST7789 and the ILI9341 have in common, bits of a pixel and milliseconds of sleep included.
//
// Reported as breaches, besides what every strict controller reports:
// - a command within 5 ms after a reset, 10h or 11h; 10h and 11h within 120 ms of each other; 11h within
//   120 ms after a reset, and 01h within 120 ms after 11h;
// - windows outside the addresses that the address mode leaves; more pixels than the window has; a window
//   left before it is full; part of a pixel;
// - a pixel format that the bus doesn't take.
#pragma once

#include <hal/clock.hpp>
#include <hal/mock/address_window.hpp>
#include <hal/mock/strict_controller.hpp>

namespace hal::mock {

/// How a glass is mounted on the memory, and what it needs.
struct DcsGlass {
  int width = 240;
  int height = 320;
  int column_offset = 0;
  int row_offset = 0;
  /// Its columns count from the right.
  bool mirrored = false;
  /// Its stripes are blue, green, red.
  bool bgr = false;
  /// It shows true colours only with inversion on.
  bool inverted = false;
};

class StrictDcs : public StrictController {
 public:
  static constexpr int memory_width = 240;
  static constexpr int memory_height = 320;

  ~StrictDcs() override = default;

  enum class Tearing : std::uint8_t { off, vblank, vblank_and_hblank };

  /// Colours as RGB565; 0 while the display is off or asleep.
  [[nodiscard]] Pattern displayed() const override;
  /// The same whether or not the display is on.
  [[nodiscard]] Pattern memory() const;
  [[nodiscard]] int beam_row(int step) const override;
  [[nodiscard]] bool on() const { return on_ && !asleep_; }
  [[nodiscard]] bool asleep() const { return asleep_; }
  [[nodiscard]] Tearing tearing() const { return tearing_; }
  /// The line of the refresh at which the TE line rises; 0: VBLANK.
  [[nodiscard]] int tearing_line() const { return tearing_line_; }
  /// Of the back light, which follows its register only while its control is on.
  [[nodiscard]] int brightness() const { return brightness_controlled_ ? brightness_ : 0; }
  /// As by the reset line.
  void hardware_reset();

 protected:
  /// At power-on: memory full of noise, asleep, display off. The clock outlives the model.
  StrictDcs(hal::Clock& clock, const DcsGlass& glass);
  void execute(std::uint8_t command, const std::vector<std::uint8_t>& parameters) final;
  /// Parameters of the commands of MIPI DCS that both controllers have.
  [[nodiscard]] int parameters(std::uint8_t command) const override;
  /// A command of the controller's own: looks at its parameters.
  virtual void execute_own(std::uint8_t command, const std::vector<std::uint8_t>& parameters) = 0;
  /// True if the controller takes pixels of this format, the low three bits of 3Ah.
  [[nodiscard]] virtual bool takes_format(int format) const = 0;

 private:
  void store(std::uint8_t byte) final;
  void pause(std::uint8_t command);
  void change_sleep(std::uint8_t command);
  void set_window(std::uint8_t command, const std::vector<std::uint8_t>& parameters);
  void begin_pixels();
  void end_pixels();
  void put(std::uint16_t colour);
  void set_defaults();
  [[nodiscard]] std::uint16_t shown(std::uint16_t colour) const;

  hal::Clock* clock_;
  DcsGlass glass_;
  std::vector<std::uint16_t> memory_;
  unsigned mode_ = 0;
  AddressWindow window_;
  int left_ = 0;  // Pixels of the window that haven't come yet.
  bool writing_ = false;
  int format_ = 6;
  unsigned bits_ = 0;  // Of the pixel that is coming in.
  int bit_count_ = 0;
  bool inverted_ = false;
  bool on_ = false;
  bool asleep_ = true;
  Tearing tearing_ = Tearing::off;
  int tearing_line_ = 0;
  int brightness_ = 0;
  bool brightness_controlled_ = false;
  Nanoseconds last_pause_ = 0;  // When 5 ms began.
  Nanoseconds last_sleep_ = 0;  // When 120 ms began.
};

/// Command table 2 and pixel formats of the Sitronix ST7789V.
class StrictSt7789 final : public StrictDcs {
 public:
  explicit StrictSt7789(hal::Clock& clock, const DcsGlass& glass = {.inverted = true})
      : StrictDcs(clock, glass) {}
  ~StrictSt7789() override = default;

 private:
  [[nodiscard]] int parameters(std::uint8_t command) const override;
  void execute_own(std::uint8_t command, const std::vector<std::uint8_t>& parameters) override;
  [[nodiscard]] bool takes_format(int format) const override {
    return format == 3 || format == 5 || format == 6;
  }
};

/// Command table 2 and pixel formats of the ILI9341.
class StrictIli9341 final : public StrictDcs {
 public:
  explicit StrictIli9341(hal::Clock& clock, const DcsGlass& glass = {.mirrored = true, .bgr = true})
      : StrictDcs(clock, glass) {}
  ~StrictIli9341() override = default;

 private:
  [[nodiscard]] int parameters(std::uint8_t command) const override;
  void execute_own(std::uint8_t command, const std::vector<std::uint8_t>& parameters) override;
  [[nodiscard]] bool takes_format(int format) const override { return format == 5 || format == 6; }
};

}  // namespace hal::mock
