// SPDX-License-Identifier: MIT
//
// What a program must know of a screen to lay out and colour its picture: nothing of buses, buffers or bands.
#pragma once

#include <hal/panel.hpp>
#include <intaglio/linear/point.hpp>

#include <cstdint>
#include <span>

namespace intaglio::present {

/// A screen as a program sees it. Constant for the life of the panel it describes.
struct ScreenInfo {
  linear::Size size;
  /// Entries of the palette the program loads; 0: the colours are fixed.
  int palette_entries = 0;
  /// The colours of the indices where they are fixed: red, green, blue, three bytes an entry.
  std::span<const std::uint8_t> fixed_palette;
};

/// The screen that a panel is.
[[nodiscard]] constexpr ScreenInfo screen_info(const hal::Capabilities& panel) noexcept {
  return {{panel.width, panel.height}, panel.palette_entries, panel.fixed_palette};
}

}  // namespace intaglio::present
