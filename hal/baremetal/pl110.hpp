// SPDX-License-Identifier: MIT
//
// Arm PrimeCell PL110 colour LCD controller (versatile flavour: control at 0x18, interrupt mask at 0x1C) as a
// scan-out panel with two frame buffers and a palette of 5:5:5 colours.
//
// Rule: while the controller is on, the base address and the palette are written only by `on_interrupt`, both
// in the same call, at the "next base" interrupt that begins the vertical blanking. Real parts latch the base
// address there by themselves; QEMU takes a write at once, so the rule is also what makes it tear-free there.
// `show` only stages a request, by `hal::SwapProtocol`.
//
// Pixels: the low bits of a byte are the left pixel at 1, 2 and 4 bits (little-endian mode).
// Colours: the device keeps the upper 5 bits of each component; QEMU shows component & 0xF8.
#pragma once

#include <hal/panel.hpp>
#include <hal/swap_protocol.hpp>

#include <cstdint>
#include <span>

namespace hal::baremetal {

class Pl110 final : public Panel {
 public:
  /// What is connected: a panel of `width` (a multiple of 16, at most 1024) by `height` (at most 1024)
  /// pixels.
  struct Geometry {
    int width = 0;
    int height = 0;
    int bits_per_pixel = 8;  ///< 1, 2, 4 or 8
  };
  static constexpr int buffer_count = 2;
  /// Bytes of both frame buffers together.
  [[nodiscard]] static constexpr std::uint32_t memory_bytes(const Geometry& g) noexcept {
    return static_cast<std::uint32_t>(g.width * g.bits_per_pixel / 8 * g.height * buffer_count);
  }

  /// `memory`: `memory_bytes` bytes, aligned to 4, that the device reads from now on.
  constexpr Pl110(std::uintptr_t registers, const Geometry& geometry, std::span<std::uint8_t> memory) noexcept
      : registers_(registers),
        memory_(memory),
        capabilities_{.width = geometry.width,
                      .height = geometry.height,
                      .bits_per_pixel = geometry.bits_per_pixel,
                      .bit_order = BitOrder::lsb_first,
                      .palette_entries = 1 << geometry.bits_per_pixel,
                      .palette_bits = 5,
                      .buffers = buffer_count,
                      .vblank_signal = true,
                      .refresh_millihertz = 60'000} {}

  /// Turns the controller on with buffer 0 on display and the palette of `show` as yet all black.
  /// Errors: panel (a geometry the controller can't scan), buffer (memory too small).
  Status start() noexcept;

  /// The handler of the controller's interrupt: latches what `show` asked for and counts the VBLANK.
  void on_interrupt() noexcept;

 private:
  [[nodiscard]] const Capabilities& do_capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] std::span<std::uint8_t> do_buffer(int index) noexcept override;
  [[nodiscard]] int do_buffer_stride() const noexcept override {
    return capabilities_.width * capabilities_.bits_per_pixel / 8;
  }
  Status do_show(int index, std::span<const std::uint8_t> palette) noexcept override;
  [[nodiscard]] bool do_show_pending() noexcept override;
  [[nodiscard]] bool do_show_replaced() noexcept override { return requests_.replaced(); }
  [[nodiscard]] int do_on_display() noexcept override { return requests_.on_display(); }
  Status do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept override;
  Status do_load_palette(std::span<const std::uint8_t> palette) noexcept override;
  [[nodiscard]] std::uint32_t do_vblank_count() noexcept override;
  Status do_wait_for_vblank() noexcept override;

  [[nodiscard]] std::uint32_t buffer_address(int index) noexcept;

  std::uintptr_t registers_;
  std::span<std::uint8_t> memory_;
  Capabilities capabilities_;
  bool on_ = false;
  SwapProtocol<InterruptCell, std::uint16_t, 256, Feed::scans_out> requests_{};
};

}  // namespace hal::baremetal
