// SPDX-License-Identifier: MIT
//
// What TFT controllers that speak MIPI DCS (Display Command Set, version 1.3) have in common: ST7789,
// ILI9341.
//
// Rules:
// - A picture of palette indices is turned to RGB565 while it is sent, a buffer at a time; a write sets a
//   window (2Ah, 2Bh) and streams its pixels behind 2Ch. A fault in the middle costs nothing but the rest of
//   that window: the next write begins with commands, and a command ends whatever was under way.
// - Rotation is the controller's: 36h exchanges and mirrors addresses. The beam doesn't follow; `scan` tells
//   how it runs over the turned picture.
// - A glass smaller than the memory lies `column_offset` and `row_offset` away from the memory's corner;
//   mirrored addresses count from the other end.
// - Sleep: 5 ms after 10h, 11h and a reset before the next command; 120 ms between 10h and 11h, from a reset
//   to 11h, and from 11h to a reset (data sheets of both controllers at 01h, 10h and 11h). The driver waits
//   only for what is left.
#pragma once

#include <hal/panels/bus_panel.hpp>
#include <hal/panels/command_port.hpp>
#include <hal/panels/expansion.hpp>
#include <hal/panels/rotation.hpp>

namespace hal::panels {

/// What the tearing-effect line tells; the values are one more than the parameter of 35h.
enum class TearingEffect : std::uint8_t {
  off,
  vblank,             ///< High during VBLANK.
  vblank_and_hblank,  ///< High between lines too.
};

/// What depends on the module, and on how it is used.
struct DcsOptions {
  /// The glass, not turned.
  int width = 240;
  int height = 320;
  /// Where the glass begins in the memory of 240x320 pixels.
  int column_offset = 0;
  int row_offset = 0;
  Rotation rotation = Rotation::by_0;
  /// The glass's columns count from the right, as on most ILI9341 modules.
  bool mirrored = false;
  /// The glass's stripes are blue, green, red.
  bool bgr = false;
  /// Colours are inverted by the controller, as IPS glass needs it.
  bool invert = false;
  /// The glass is refreshed from its last row to its first.
  bool scan_up = false;
  TearingEffect te = TearingEffect::off;
  /// The line of the refresh at which the TE line rises, 0..319; 0: at the VBLANK. Another line leaves no
  /// room for `TearingEffect::vblank_and_hblank`.
  int te_line = 0;
  /// Indices that the program draws: 1, 2, 4 or 8 bits.
  int bits_per_pixel = 8;
  BitOrder bit_order = BitOrder::msb_first;
  /// Frames a second times 1000, at least 1, counted by the clock where there is no TE line.
  std::uint32_t refresh_millihertz = 60'000;
  /// Brightness of a back light that the controller drives, 0..255.
  std::uint8_t contrast = 255;
  /// Where pixels are turned to colours before they are sent: the larger, the fewer transfers. Lives as long
  /// as the panel; below 256 bytes: 256 bytes of stack are used.
  std::span<std::uint8_t> workspace{};
};

/// How the beam spends a refresh, in times of a line.
struct BeamLines {
  int before = 0;  ///< From the VBLANK signal to the picture's first line.
  int total = 0;   ///< From a VBLANK signal to the next.
  friend constexpr bool operator==(const BeamLines&, const BeamLines&) noexcept = default;
};

class DcsPanel : public BusPanel {
 public:
  static constexpr int memory_width = 240;
  static constexpr int memory_height = 320;

 protected:
  /// `setup` are the controller's own commands in the form of `CommandPort::sequence`.
  DcsPanel(CommandPort& port, Clock& clock, VblankSource* vblank, const DcsOptions& options,
           std::span<const std::uint8_t> setup) noexcept;
  ~DcsPanel() = default;

 private:
  enum class Sleep : std::uint8_t { unknown, asleep, awake };

  Status do_start() noexcept final;
  Status do_stop() noexcept final;
  Status do_sleep(bool asleep) noexcept final;
  Status do_set_contrast(std::uint8_t contrast) noexcept final;
  Status do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept final;
  Status do_load_palette(std::span<const std::uint8_t> palette) noexcept final;

  Status send(std::uint8_t code, std::span<const std::uint8_t> parameters = {}) noexcept;
  Status send(std::uint8_t code, std::uint8_t parameter) noexcept { return send(code, {&parameter, 1}); }
  Status reset() noexcept;
  /// A reset or a change of sleep has just been sent.
  void pause() noexcept;
  Status configure() noexcept;
  Status clear() noexcept;
  Status set_window(const Rect& area) noexcept;
  Status set_range(std::uint8_t code, int first, int count) noexcept;
  [[nodiscard]] std::uint8_t address_mode() const noexcept;

  CommandPort* port_;
  Clock* clock_;
  DcsOptions options_;
  std::span<const std::uint8_t> setup_;
  bool valid_;
  Sleep sleep_ = Sleep::unknown;
  Nanoseconds ready_ = 0;    // When the next command may be sent.
  Nanoseconds settled_ = 0;  // When the controller may be put to sleep or woken.
  int column_shift_ = 0;     // From the picture's columns to addresses.
  int row_shift_ = 0;
  Rgb565Palette palette_;
};

/// The beam of a controller that rests for so many lines between the last row of its memory and the first; it
/// goes through all rows, whatever part of them the glass shows. `te_line` is 0. Nothing for a glass that
/// `start` refuses.
[[nodiscard]] constexpr BeamLines beam_lines(const DcsOptions& o, int blank_lines) noexcept {
  constexpr int rows = DcsPanel::memory_height;
  if (o.height < 1 || o.height > rows || o.row_offset < 0 || o.row_offset > rows - o.height) return {};
  return {blank_lines + (o.scan_up ? rows - o.row_offset - o.height : o.row_offset), blank_lines + rows};
}

}  // namespace hal::panels
