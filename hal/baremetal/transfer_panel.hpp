// SPDX-License-Identifier: MIT
//
// Frame buffers in the program's memory for a panel behind a bus, sent by DMA or by interrupts: to a program
// it is a panel that scans out.
//
// Rule: the VBLANK interrupt begins to send the frame asked for, the interrupt at the end of the transfer
// says that it is out; until then its buffer counts as on display. Both are of the same priority, so neither
// interrupts the other. A frame that isn't out at the next VBLANK keeps the one behind it waiting. All of it
// is `hal::SwapProtocol`, explored in tests/present/interleavings.cpp. Colours of a frame whose transfer
// failed go out again with the next, which may bring none. A bus slower than the beam tears on a
// panel that scans its memory meanwhile; where that matters, the transfer takes at most as long as
// present/beam_race says.
#pragma once

#include <hal/baremetal/core.hpp>
#include <hal/panel.hpp>
#include <hal/swap_protocol.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace hal::baremetal {

/// Sends frames while the program goes on.
class FrameTransfer {
 public:
  FrameTransfer(const FrameTransfer&) = delete;
  FrameTransfer& operator=(const FrameTransfer&) = delete;

  /// Called in the VBLANK interrupt: begins to send a frame, rows close together, and its colours (3 bytes an
  /// entry from entry 0 on; empty: they stay), which are gone when it returns.
  Status begin(std::span<const std::uint8_t> pixels, std::span<const std::uint8_t> colours) noexcept {
    return do_begin(pixels, colours);
  }

 protected:
  constexpr FrameTransfer() noexcept = default;
  ~FrameTransfer() = default;

 private:
  virtual Status do_begin(std::span<const std::uint8_t> pixels,
                          std::span<const std::uint8_t> colours) noexcept = 0;
};

/// `most_colours` entries of palette are kept for the interrupt; `Cell`, `Core` and `Guards` are for tests.
template <std::size_t most_colours, template <class> class Cell = InterruptCell, class Core = ThisCore,
          class Guards = SwapProtocolGuards>
class TransferPanel final : public Panel {
 public:
  /// The panel `device` (its `buffers` is ignored) with `buffers` frame buffers, at least 2, one behind the
  /// other in `memory`.
  TransferPanel(const Capabilities& device, FrameTransfer& transfer, std::span<std::uint8_t> memory,
                int buffers) noexcept
      : capabilities_(device), transfer_(&transfer), memory_(memory) {
    capabilities_.buffers = buffers;
    capabilities_.palette_on_write = false;
    capabilities_.vblank_signal = true;
  }

  /// The handler of the VBLANK (or of the tearing-effect line). Takes 3 * `most_colours` bytes of stack.
  void on_vblank() noexcept {
    requests_.on_vblank([this](int index, std::size_t count, const auto& colour) noexcept {
      sent_ = std::max(count, owed_);
      std::array<std::uint8_t, 3 * most_colours> colours;  // What isn't written isn't read.
      for (std::size_t i = 0; i < sent_; ++i) {
        const std::uint32_t rgb = colour(i);
        for (std::size_t part = 0; part < 3; ++part)
          colours[3 * i + part] = static_cast<std::uint8_t>(rgb >> (8U * part));
      }
      if (!transfer_->begin(do_buffer(index), std::span(colours).first(3 * sent_)).ok()) on_sent(false);
    });
  }
  /// The handler of the end of a transfer, whether it went well or not.
  void on_sent(bool well = true) noexcept {
    if (!well) ++failed_;
    owed_ = well ? 0 : sent_;
    requests_.on_sent();
  }

  /// Frames that weren't sent, or not to the end.
  [[nodiscard]] std::uint32_t failed() const noexcept { return failed_; }

 private:
  [[nodiscard]] const Capabilities& do_capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] int do_buffer_stride() const noexcept override {
    return (capabilities_.width * capabilities_.bits_per_pixel + 7) / 8;
  }
  [[nodiscard]] std::span<std::uint8_t> do_buffer(int index) noexcept override {
    const auto bytes = static_cast<std::size_t>(do_buffer_stride() * capabilities_.height);
    const std::size_t first = bytes * static_cast<std::size_t>(index);
    return memory_.size() < first + bytes ? std::span<std::uint8_t>{} : memory_.subspan(first, bytes);
  }
  Status do_show(int index, std::span<const std::uint8_t> palette) noexcept override {
    if (do_buffer(index).empty()) return {Error::invalid, Part::buffer};
    if (palette.size() > 3 * most_colours) return {Error::invalid, Part::palette};
    requests_.request(index, palette.size() / 3, [palette](std::size_t i) noexcept {
      const std::span<const std::uint8_t> rgb = palette.subspan(3 * i, 3);
      return std::uint32_t{rgb[0]} | std::uint32_t{rgb[1]} << 8U | std::uint32_t{rgb[2]} << 16U;
    });
    return {};
  }
  [[nodiscard]] bool do_show_pending() noexcept override { return requests_.pending(); }
  [[nodiscard]] bool do_show_replaced() noexcept override { return requests_.replaced(); }
  [[nodiscard]] int do_on_display() noexcept override { return requests_.on_display(); }
  Status do_write(const Rect&, std::span<const std::uint8_t>, int) noexcept override {
    return {Error::unsupported, Part::buffer};
  }
  Status do_load_palette(std::span<const std::uint8_t>) noexcept override {
    return {Error::unsupported, Part::palette};
  }
  [[nodiscard]] std::uint32_t do_vblank_count() noexcept override { return requests_.vblanks(); }
  Status do_wait_for_vblank() noexcept override {
    const std::uint32_t before = requests_.vblanks();
    sleep_until<Core>([this, before] { return requests_.vblanks() != before; });
    return {};
  }

  Capabilities capabilities_;
  FrameTransfer* transfer_;
  std::span<std::uint8_t> memory_;
  SwapProtocol<Cell, std::uint32_t, most_colours, Feed::sends, Guards> requests_{};
  // Written by interrupts alone:
  std::uint32_t failed_ = 0;
  std::size_t sent_ = 0;  // Colours that went out with the last frame,
  std::size_t owed_ = 0;  // and those of them that may not have arrived.
};

}  // namespace hal::baremetal
