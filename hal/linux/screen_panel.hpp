// SPDX-License-Identifier: MIT
//
// What screens behind a file of the kernel have in common: a program draws indices, and its picture lies
// enlarged in the middle of a screen that has a size and colours of its own.
//
// Rule: a panel starts with buffer 0 on display, all of it index 0, all colours black. Each picture keeps the
// colours that it is shown with, so those of a request that waits aren't seen before it is; colours that are
// loaded alone reach both.
#pragma once

#include <hal/linux/device_file.hpp>
#include <hal/linux/scaling.hpp>
#include <hal/panel.hpp>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace hal::linux_io {

class ScreenPanel : public Panel {
 public:
  static constexpr int buffers = 2;

  [[nodiscard]] const std::string& name() const noexcept { return file_.name(); }
  [[nodiscard]] const std::string& fault() const noexcept { return file_.fault(); }
  /// False: the driver doesn't tell VBLANKs, and a timer stands in.
  [[nodiscard]] bool tells_vblanks() const noexcept { return capabilities_.vblank_signal; }

 protected:
  /// A picture of the program's, and the colours it is shown with.
  struct Picture {
    int buffer = 0;
    std::array<std::uint8_t, 768> colours{};  // RGBRGB…
    void load(std::span<const std::uint8_t> rgb) noexcept;
  };

  /// `kind` as "frame buffer". Throws DeviceError.
  ScreenPanel(System& system, const char* kind, const std::string& path) : file_(system, kind, path) {}
  ~ScreenPanel() = default;

  [[nodiscard]] Clock& clock() const noexcept { return file_.system().clock(); }

  /// What a driver says of its screen's size. Throws DeviceError if no screen has it.
  static Extent checked_size(const DeviceFile& file, std::uint64_t width, std::uint64_t height);
  /// The refreshes a second times 1000 that a driver says, or 60 Hz where that can't be.
  static std::uint32_t likely_refresh(std::uint64_t millihertz) noexcept;

  /// Sets up a picture of the size that was asked for ({}: the screen's) on a screen of this size. Throws
  /// DeviceError.
  void set_up(Extent asked, Extent screen, std::uint32_t refresh_millihertz, bool tells_vblanks);
  /// The program draws in memory of the device instead of its own.
  void draw_in(const std::array<std::span<std::uint8_t>, buffers>& pictures, int stride) noexcept;

  /// Puts a picture of the program's on the screen.
  void draw(const Picture& picture, const PixelPalette& palette, std::span<std::uint8_t> screen,
            std::size_t stride) const noexcept;

  /// The failure of a request that was to take effect while something else was asked; told once.
  [[nodiscard]] Status take_lost() noexcept { return std::exchange(lost_, {}); }

  DeviceFile file_;
  bool replaced_ = false;  // The last request took the place of one that never took effect.
  Status lost_;

 private:
  const Capabilities& do_capabilities() const noexcept final { return capabilities_; }
  std::span<std::uint8_t> do_buffer(int index) noexcept final {
    return pictures_[static_cast<std::size_t>(index)];
  }
  int do_buffer_stride() const noexcept final { return stride_; }
  bool do_show_replaced() noexcept final { return replaced_; }
  Status do_write(const Rect&, std::span<const std::uint8_t>, int) noexcept final {
    return {Error::unsupported, Part::buffer};
  }

  Capabilities capabilities_;
  Placement placement_{{1, 1}, {1, 1}};
  std::vector<std::uint8_t> memory_;  // The program's, unless it is the device's.
  std::array<std::span<std::uint8_t>, buffers> pictures_;
  int stride_ = 0;
};

}  // namespace hal::linux_io
