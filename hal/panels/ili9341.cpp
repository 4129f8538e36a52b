// SPDX-License-Identifier: MIT
#include <hal/panels/ili9341.hpp>

#include <array>

namespace hal::panels {

namespace {

// clang-format off
constexpr auto setup = std::to_array<std::uint8_t>({
    0xCB, 5, 0x39, 0x2C, 0x00, 0x34, 0x02,  // Power control A.
    0xCF, 3, 0x00, 0xC1, 0x30,              // Power control B.
    0xE8, 3, 0x85, 0x00, 0x78,              // Driver timing A.
    0xEA, 2, 0x00, 0x00,                    // Driver timing B.
    0xED, 4, 0x64, 0x03, 0x12, 0x81,        // Power-on sequence.
    0xF7, 1, 0x20,                          // Charge pump: twice VCI.
    0xC0, 1, 0x23,                          // Grey levels up to 4.6 V.
    0xC1, 1, 0x10,                          // Step-up factors.
    0xC5, 2, 0x3E, 0x28,                    // VCOM 4.25 V, -1.5 V.
    0xC7, 1, 0x86,                          // VCOM offset.
    0xB1, 2, 0x00, 0x1F,                    // 61 frames a second.
    0xB6, 4, 0x08, 0x82, 0x27, 0x00,        // 320 lines, gates and sources in the order of the memory.
    0xF2, 1, 0x00,                          // One gamma for three colours.
    0x26, 1, 0x01,
    0xE0, 15, 0x0F, 0x31, 0x2B, 0x0C, 0x0E, 0x08, 0x4E, 0xF1, 0x37, 0x07, 0x10, 0x03, 0x0E, 0x09, 0x00,
    0xE1, 15, 0x00, 0x0E, 0x14, 0x03, 0x11, 0x07, 0x31, 0xC1, 0x48, 0x08, 0x0F, 0x0C, 0x31, 0x36, 0x0F,
});
// clang-format on

}  // namespace

Ili9341::Ili9341(CommandPort& port, Clock& clock, VblankSource* vblank,
                 const Ili9341Options& options) noexcept
    : DcsPanel(port, clock, vblank, options, setup) {}

}  // namespace hal::panels
