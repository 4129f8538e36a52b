// SPDX-License-Identifier: MIT
//
// Panels that can be simulated, as a table: what a device is, told once.
#pragma once

#include <hal/panel.hpp>
#include <hal/sim/effects/effects.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hal::sim {

/// When a request of `show` takes effect.
enum class Latch : std::uint8_t {
  at_vblank,  ///< As hardware does.
  at_once,    ///< In the middle of the picture: a faulty driver, for proving that the fault is seen.
};

/// Everything that describes a simulated panel.
struct PanelSpec {
  std::string name;
  std::string description;
  /// `fixed_palette` is set by the panel from `fixed_colours`.
  Capabilities capabilities;
  std::vector<std::uint8_t> fixed_colours{};
  /// Lines of a refresh, those of the VBLANK interval included; at least height + 1.
  int total_lines = 0;
  /// Bytes between the end of a row of a frame buffer and the start of the next.
  int row_padding = 0;
  Latch latch = Latch::at_vblank;
  /// What the effects are on this panel, where a scenario names them without a value.
  EffectTable effects{};
};

/// All named panels.
[[nodiscard]] std::span<const PanelSpec> catalog();

/// A scan-out panel with a palette of 2^bits entries. Sides 1..16384; bits 1, 2, 4 or 8.
[[nodiscard]] PanelSpec paletted(int width, int height, int bits_per_pixel, int buffers = 2,
                                 BitOrder order = BitOrder::msb_first);

/// The panel of a name of the catalogue, or of a format like "320x200x4" (`paletted`).
[[nodiscard]] std::optional<PanelSpec> find_panel(std::string_view text);

}  // namespace hal::sim
