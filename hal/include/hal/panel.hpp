// SPDX-License-Identifier: MIT
//
// The panel: the one run-time interface between a frame and whatever shows it.
//
// There are two kinds, told apart by `Capabilities::buffers`:
// - a *scan-out* panel (buffers >= 1) shows a frame buffer in the program's memory. The program draws into
//   `buffer(i)` and asks with `show(i, palette)` that buffer and palette be displayed; both take effect
//   together at the next VBLANK, or not at all.
// - a *write* panel (buffers == 0) has memory of its own behind a bus. The program sends rectangles with
//   `write`, whose edges keep the stated alignment, and the palette (if it has one) with `load_palette`.
//
// Rule: the public calls check their arguments and call private virtuals, so a driver never sees bad ones.
// Colours are bytes, red, green, blue, three an entry: the border knows bytes, rectangles and time.
#pragma once

#include <hal/status.hpp>

#include <cstdint>
#include <span>

namespace hal {

struct Rect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  friend constexpr bool operator==(const Rect&, const Rect&) noexcept = default;
};

/// Which end of a byte holds its leftmost pixel.
enum class BitOrder : std::uint8_t { msb_first, lsb_first };

/// The way the beam runs over the picture as the program sees it.
enum class ScanDirection : std::uint8_t { down, up, right, left };

/// What a panel is and can do. Constant for the life of the panel.
struct Capabilities {
  int width = 0;
  int height = 0;
  int bits_per_pixel = 8;
  BitOrder bit_order = BitOrder::msb_first;
  /// Entries of the colour look-up table; 0: the colours are fixed, see `fixed_palette`.
  int palette_entries = 0;
  /// Bits a channel that the device keeps of each 8-bit colour component.
  int palette_bits = 8;
  /// True if colours are applied to pixels as they are written: loading a palette changes nothing that is
  /// shown until it is written again. Write panels only.
  bool palette_on_write = false;
  /// The colours of the indices where no palette can be loaded: 3 bytes an entry, 2^bits_per_pixel entries.
  std::span<const std::uint8_t> fixed_palette{};
  /// Frame buffers in the program's memory that the device scans out; 0: a write panel.
  int buffers = 0;
  /// Rectangles of partial writes begin and end at multiples of these.
  int x_alignment = 1;
  int y_alignment = 1;
  ScanDirection scan = ScanDirection::down;
  /// True if the device tells when its VBLANK begins (interrupt or tearing-effect line).
  bool vblank_signal = false;
  /// Frames a second times 1000.
  std::uint32_t refresh_millihertz = 60'000;
};

class Panel {
 public:
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;

  [[nodiscard]] const Capabilities& capabilities() const noexcept { return do_capabilities(); }

  /// The memory of frame buffer `index`; empty if there is no such buffer.
  [[nodiscard]] std::span<std::uint8_t> buffer(int index) noexcept;
  /// Bytes from a row of a frame buffer to the next.
  [[nodiscard]] int buffer_stride() const noexcept { return do_buffer_stride(); }

  /// Asks that from the next VBLANK on buffer `index` be displayed with these colours (3 bytes an entry from
  /// entry 0 on; empty: the colours stay). Replaces a request that hasn't taken effect yet, but entries that
  /// the later one doesn't bring are those of the one replaced.
  /// Errors: buffer, palette (longer than the table or not whole entries), unsupported on a write panel.
  Status show(int index, std::span<const std::uint8_t> palette) noexcept;
  /// True while a request of `show` waits for its VBLANK.
  [[nodiscard]] bool show_pending() noexcept { return do_show_pending(); }
  /// True if the last request of `show` replaced one that never took effect. Meant for drivers that can tell
  /// what is on display.
  [[nodiscard]] bool show_replaced() noexcept { return do_show_replaced(); }
  static constexpr int nothing = -1;
  static constexpr int unknown = -2;
  /// The frame buffer that the device is showing or sending, on which nothing may be drawn; `nothing` if it
  /// is none of them, `unknown` if the driver can't tell.
  [[nodiscard]] int on_display() noexcept { return do_on_display(); }

  /// Sends a rectangle of pixels to a write panel; `stride` bytes from a row to the next.
  /// Errors: rectangle (outside or empty; misaligned), stride, pixels (too few), unsupported on a scan-out
  /// panel.
  Status write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept;
  /// Loads colours from entry 0 on; on a scan-out panel without waiting for VBLANK (prefer `show`).
  Status load_palette(std::span<const std::uint8_t> palette) noexcept;

  /// VBLANKs (or frame-clock ticks) since the panel was started; wraps.
  [[nodiscard]] std::uint32_t vblank_count() noexcept { return do_vblank_count(); }
  /// Returns when the next VBLANK has begun, whatever was pending has taken effect. Errors: timeout.
  Status wait_for_vblank() noexcept { return do_wait_for_vblank(); }

 protected:
  constexpr Panel() noexcept = default;
  ~Panel() = default;

 private:
  [[nodiscard]] virtual const Capabilities& do_capabilities() const noexcept = 0;
  [[nodiscard]] virtual std::span<std::uint8_t> do_buffer(int index) noexcept = 0;
  [[nodiscard]] virtual int do_buffer_stride() const noexcept = 0;
  virtual Status do_show(int index, std::span<const std::uint8_t> palette) noexcept = 0;
  [[nodiscard]] virtual bool do_show_pending() noexcept = 0;
  [[nodiscard]] virtual bool do_show_replaced() noexcept { return false; }
  [[nodiscard]] virtual int do_on_display() noexcept { return unknown; }
  virtual Status do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept = 0;
  virtual Status do_load_palette(std::span<const std::uint8_t> palette) noexcept = 0;
  [[nodiscard]] virtual std::uint32_t do_vblank_count() noexcept = 0;
  virtual Status do_wait_for_vblank() noexcept = 0;
  /// A public call was refused on account of its arguments, before the driver saw it: test doubles report it.
  virtual void do_refused(Status) noexcept {}

  Status refuse(Error error, Part part) noexcept;
  Status check_palette(std::span<const std::uint8_t> palette) noexcept;
};

}  // namespace hal
