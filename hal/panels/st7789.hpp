// SPDX-License-Identifier: MIT
//
// ST7789 (ST7789V, ST7789V2): TFT controller with memory for 240x320 pixels, behind SPI with a data/command
// line; its TE output tells the VBLANK.
//
// Source: Sitronix ST7789V data sheet, version 1.3 (2014/03), chapter 9 "Command"; of the second command
// table timings and polarities are its defaults, voltages and gamma those of a usual IPS glass.
#pragma once

#include <hal/panels/dcs_panel.hpp>

namespace hal::panels {

using St7789Options = DcsOptions;

/// The common modules, with IPS glass.
inline constexpr St7789Options st7789_240x320{.invert = true};
inline constexpr St7789Options st7789_240x240{.height = 240, .invert = true};
inline constexpr St7789Options st7789_135x240{
    .width = 135, .height = 240, .column_offset = 52, .row_offset = 40, .invert = true};

/// Lines between two pictures: the porches that the driver sets.
inline constexpr int st7789_blank_lines = 24;

class St7789 final : public DcsPanel {
 public:
  /// `vblank` counts the pulses of the TE line; null: frames follow the clock. Everything outlives the panel.
  St7789(CommandPort& port, Clock& clock, VblankSource* vblank = nullptr,
         const St7789Options& options = st7789_240x320) noexcept;
};

}  // namespace hal::panels
