// SPDX-License-Identifier: MIT
#include <intaglio/present/panel_port.hpp>

namespace intaglio::present {

Status to_status(hal::Status status) noexcept {
  if (status.ok()) return {};
  return {status.error() == hal::Error::busy ? Error::busy : Error::device, Argument::panel};
}

Status check_format(const hal::Capabilities& panel, int bits, image::BitOrder order) noexcept {
  const bool lsb_first = order == image::BitOrder::lsb_first;
  const bool panel_lsb_first = panel.bit_order == hal::BitOrder::lsb_first;
  // A pixel that fills its byte has no order in it.
  if (panel.bits_per_pixel != bits || (bits < 8 && lsb_first != panel_lsb_first))
    return {Error::mismatched, Argument::panel};
  return {};
}

Status check_palette(const hal::Capabilities& panel, std::span<const std::uint8_t> palette) noexcept {
  if (palette.empty()) return {};
  if (panel.palette_entries == 0) return {Error::unsupported, Argument::palette};
  if (palette.size() % 3U != 0) return {Error::malformed, Argument::palette};
  const auto most = static_cast<std::uint32_t>(panel.palette_entries) * 3U;
  if (palette.size() > most) return {Error::too_large, Argument::palette, most};
  return {};
}

}  // namespace intaglio::present
