// SPDX-License-Identifier: MIT
//
// The fonts of the programs, by size.
#pragma once

#include <intaglio_fonts/digits_16.hpp>
#include <intaglio_fonts/digits_28.hpp>
#include <intaglio_fonts/fixed_5x8.hpp>
#include <intaglio_fonts/fixed_6x13.hpp>

namespace apps {

/// For units and notes: legible at five columns a character.
[[nodiscard]] inline const intaglio::text::Font& small_font() noexcept { return intaglio::fonts::fixed_5x8; }
/// For running text.
[[nodiscard]] inline const intaglio::text::Font& text_font() noexcept { return intaglio::fonts::fixed_6x13; }
/// For the numbers of a dial of that radius.
[[nodiscard]] inline const intaglio::text::Font& number_font(int radius) noexcept {
  return radius >= 110  ? intaglio::fonts::digits_16
         : radius >= 66 ? intaglio::fonts::fixed_6x13
                        : intaglio::fonts::fixed_5x8;
}

/// For the drums of an odometer in a strip of so many rows.
[[nodiscard]] inline const intaglio::text::Font& counter_font(int rows) noexcept {
  return rows >= 56 ? intaglio::fonts::digits_28 : intaglio::fonts::fixed_6x13;
}

}  // namespace apps
