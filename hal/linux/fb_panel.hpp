// SPDX-License-Identifier: MIT
//
// A frame buffer device of Linux as a panel with a palette.
//
// Rule: a `show` takes effect at the first VBLANK that this program notices after it, that is in
// `wait_for_vblank`, `vblank_count` or `show_pending`: palette and picture, one directly after the other.
// - 8 bits of pseudo-colour: the palette is the hardware's (FBIOPUTCMAP). With room for two pictures the
//   program draws in the device's own memory and the device pans between them (FBIOPAN_DISPLAY).
// - Else pictures are copied, and turned to colours where the device has real ones.
// VBLANKs are the device's (FBIO_WAITFORVSYNC) where it tells them while someone waits; in between, and where
// it tells none, they are a clock's.
#pragma once

#include <hal/linux/screen_panel.hpp>

#include <memory>
#include <string>

namespace hal::linux_io {

/// "Virtual FB 640x480, 8 bits" of a file of /dev; "" if it can't be opened.
[[nodiscard]] std::string fb_description(const std::string& path, System& system = System::kernel());

class FbPanel final : public ScreenPanel {
 public:
  /// `picture`: the program's size. The device is set to it if it can be, else the picture is enlarged by a
  /// whole number; {} is the whole device as it is set. Throws DeviceError.
  explicit FbPanel(const std::string& path, Extent picture = {}, System& system = System::kernel());
  /// Blanks the picture and sets the device as it was, unless `keep` was called.
  ~FbPanel();
  void keep() noexcept;

  /// True if the device pans between two pictures.
  [[nodiscard]] bool pans() const noexcept { return pans_; }
  /// True if colours are looked up by the device.
  [[nodiscard]] bool has_hardware_palette() const noexcept { return hardware_palette_; }

 private:
  struct Device;

  Status do_show(int index, std::span<const std::uint8_t> palette) noexcept override;
  bool do_show_pending() noexcept override;
  int do_on_display() noexcept override;
  Status do_load_palette(std::span<const std::uint8_t> palette) noexcept override;
  std::uint32_t do_vblank_count() noexcept override;
  Status do_wait_for_vblank() noexcept override;

  /// The program draws in the device's memory.
  [[nodiscard]] bool direct() const noexcept { return hardware_palette_ && pans_; }
  /// The device's memory of buffer `index`; the only one if it doesn't pan.
  [[nodiscard]] std::span<std::uint8_t> page(int index) noexcept;
  /// True if the picture asked for is copied to memory that isn't displayed.
  [[nodiscard]] bool drawn_ahead() const noexcept {
    return pans_ && !hardware_palette_ && asked_.buffer != shown_.buffer;
  }
  void draw_page(const Picture& picture) noexcept;
  /// Loads colours into the device.
  Status put(const Picture& picture) noexcept;
  Status pan(int index) noexcept;
  /// Counts VBLANKs that are over and lets a request take effect after one.
  void notice() noexcept;
  Status take_effect() noexcept;

  std::unique_ptr<Device> device_;
  bool hardware_palette_;
  bool pans_;
  PixelLayout layout_;
  Nanoseconds period_;
  Nanoseconds anchor_;   // When VBLANK `count_` began.
  bool synced_ = false;  // As the device told it.
  std::uint32_t count_ = 0;
  bool pending_ = false;
  bool new_colours_ = false;  // Of `asked_`, which the device doesn't have yet.
  Picture asked_;             // Of the last request; on display unless `pending_` or lost.
  Picture shown_;
  std::uint32_t asked_at_ = 0;
};

}  // namespace hal::linux_io
