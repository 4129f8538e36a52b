// SPDX-License-Identifier: MIT
#include <hal/panels/st7789.hpp>

#include <array>

namespace hal::panels {

namespace {

// clang-format off
constexpr auto setup = std::to_array<std::uint8_t>({
    0xB2, 5, 0x0C, 0x0C, 0x00, 0x33, 0x33,  // Porches: 12 lines before and behind the picture.
    0xB7, 1, 0x35,                          // Gate voltages 13.26 V, -10.43 V.
    0xBB, 1, 0x19,                          // VCOM 0.725 V.
    0xC0, 1, 0x2C,                          // Directions and colours as the glass expects them.
    0xC2, 2, 0x01, 0xFF,                    // VRH and VDV come from the next two.
    0xC3, 1, 0x12,
    0xC4, 1, 0x20,
    0xC6, 1, 0x0F,                          // 60 frames a second.
    0xD0, 2, 0xA4, 0xA1,                    // AVDD 6.8 V, AVCL -4.8 V, VDS 2.3 V.
    0xE0, 14, 0xD0, 0x04, 0x0D, 0x11, 0x13, 0x2B, 0x3F, 0x54, 0x4C, 0x18, 0x0D, 0x0B, 0x1F, 0x23,
    0xE1, 14, 0xD0, 0x04, 0x0C, 0x11, 0x13, 0x2C, 0x3F, 0x44, 0x51, 0x2F, 0x1F, 0x1F, 0x20, 0x23,
});
// clang-format on

}  // namespace

St7789::St7789(CommandPort& port, Clock& clock, VblankSource* vblank, const St7789Options& options) noexcept
    : DcsPanel(port, clock, vblank, options, setup) {}

}  // namespace hal::panels
