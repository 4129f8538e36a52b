// SPDX-License-Identifier: MIT
//
// Between a screen and its panel: what every kind of screen checks, and statuses of the hardware in terms of
// the library. None of it depends on the pixel format, so it is compiled once.
#pragma once

#include <hal/panel.hpp>
#include <intaglio/image/format.hpp>
#include <intaglio/status.hpp>

#include <cstdint>
#include <span>

namespace intaglio::present {

/// What the hardware answered, as a status: busy stays busy, everything else is a failure of the device.
[[nodiscard]] Status to_status(hal::Status status) noexcept;

/// Success if the panel takes pixels of `bits` bits in this order.
/// Errors: mismatched panel.
[[nodiscard]] Status check_format(const hal::Capabilities& panel, int bits, image::BitOrder order) noexcept;

template <image::PixelFormat F>
[[nodiscard]] Status check_format(const hal::Capabilities& panel) noexcept {
  return check_format(panel, F::bits, F::order);
}

/// Success if the panel can load these colours; no colours always go.
/// Errors: palette (unsupported: the panel's colours are fixed; malformed: not whole entries; too large:
/// `needed()` is the most bytes it takes).
[[nodiscard]] Status check_palette(const hal::Capabilities& panel,
                                   std::span<const std::uint8_t> palette) noexcept;

/// True if a write panel's frame with these colours may be dropped: what it brings can wait for the next
/// frame without changing what is shown, or being lost.
[[nodiscard]] inline bool can_wait(const hal::Capabilities& panel,
                                   std::span<const std::uint8_t> palette) noexcept {
  return palette.empty() || panel.palette_on_write;
}

}  // namespace intaglio::present
