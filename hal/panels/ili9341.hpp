// SPDX-License-Identifier: MIT
//
// ILI9341: TFT controller with memory for 240x320 pixels, behind SPI with a data/command line; its TE output
// tells the VBLANK.
//
// Source: ILI Technology ILI9341 data sheet, version 1.11 (2011/06), chapter 8 "Command", and application
// notes 0.6 (2011/03) for the commands above C9h.
#pragma once

#include <hal/panels/dcs_panel.hpp>

namespace hal::panels {

using Ili9341Options = DcsOptions;

/// The usual module, upright and on its side.
inline constexpr Ili9341Options ili9341_240x320{.mirrored = true, .bgr = true, .refresh_millihertz = 61'000};
inline constexpr Ili9341Options ili9341_320x240{
    .rotation = Rotation::by_90, .mirrored = true, .bgr = true, .refresh_millihertz = 61'000};

/// Lines between two pictures: the porches as they are after a reset.
inline constexpr int ili9341_blank_lines = 4;

class Ili9341 final : public DcsPanel {
 public:
  /// `vblank` counts the pulses of the TE line; null: frames follow the clock. Everything outlives the panel.
  Ili9341(CommandPort& port, Clock& clock, VblankSource* vblank = nullptr,
          const Ili9341Options& options = ili9341_240x320) noexcept;
};

}  // namespace hal::panels
