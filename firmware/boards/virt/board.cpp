// SPDX-License-Identifier: MIT
#include <hal/baremetal/ns16550.hpp>

#include <array>
#include <cstddef>
#include <firmware/boards/virt/board.hpp>

namespace {

constexpr intaglio::linear::Size size{320, 240};

constinit std::array<std::uint8_t, static_cast<std::size_t>(size.width* size.height)> frame{};
constinit hal::baremetal::Ns16550 uart{0x1000'0000};

}  // namespace

extern "C" void handle_fault() { uart.text("failed: fault\n"); }

namespace boards::virt {

Board::Screen Board::screen() noexcept { return {frame, {size, 256, {}}}; }
hal::baremetal::TextOutput& Board::serial() noexcept { return uart; }

}  // namespace boards::virt
