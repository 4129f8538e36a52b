// SPDX-License-Identifier: MIT
//
// A screen of this machine as a panel with a palette: KMS, by libdrm, with dumb buffers and page flips.
//
// Rule: the program draws indices in memory of its own. `show` turns them to colours in a buffer that isn't
// displayed and asks the kernel to flip to it at the next VBLANK, so palette and frame change together. A
// `show` while a flip is under way waits for it, and then for the next VBLANK.
#pragma once

#include <hal/linux/monotonic_clock.hpp>
#include <hal/linux/scaling.hpp>
#include <hal/linux/system.hpp>
#include <hal/linux/trouble.hpp>
#include <hal/panel.hpp>
#include <hal/panels/frame_ticks.hpp>

#include <memory>
#include <string>
#include <vector>

namespace hal::linux_io {

/// The screens that `path`, a file of /dev/dri, has: "HDMI-A 1920x1080" of those with something plugged in.
[[nodiscard]] std::vector<std::string> kms_screens(const std::string& path,
                                                   System& system = System::kernel());

class KmsPanel final : public Panel {
 public:
  static constexpr int buffers = 2;

  /// `picture`: the program's size, enlarged by a whole number; {} is the whole screen. Throws DeviceError.
  explicit KmsPanel(const std::string& path, Extent picture = {}, System& system = System::kernel());
  /// Gives the screen back as it was.
  ~KmsPanel();

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] const std::string& fault() const noexcept { return fault_.text(); }
  /// Flips that have happened.
  [[nodiscard]] std::uint32_t flips() const noexcept { return flips_; }
  /// False: the driver doesn't tell VBLANKs, and a timer stands in.
  [[nodiscard]] bool tells_vblanks() const noexcept { return tells_vblanks_; }

 private:
  struct Screen;  // What libdrm knows of it.

  const Capabilities& do_capabilities() const noexcept override { return capabilities_; }
  std::span<std::uint8_t> do_buffer(int index) noexcept override;
  int do_buffer_stride() const noexcept override { return capabilities_.width; }
  Status do_show(int index, std::span<const std::uint8_t> palette) noexcept override;
  bool do_show_pending() noexcept override;
  Status do_write(const Rect&, std::span<const std::uint8_t>, int) noexcept override;
  Status do_load_palette(std::span<const std::uint8_t> palette) noexcept override;
  std::uint32_t do_vblank_count() noexcept override;
  Status do_wait_for_vblank() noexcept override;

  /// Puts the program's buffer on one of the screen's.
  void draw(int index, std::size_t on) noexcept;
  Status flip(std::size_t to) noexcept;
  /// Takes notice of flips that have happened, waiting at most so long for one.
  Status take_events(int milliseconds) noexcept;
  void flipped() noexcept;
  /// The kernel's count. False: it keeps none.
  bool query_vblank(bool wait, std::uint32_t& count) noexcept;

  std::string name_;
  File file_;
  std::unique_ptr<Screen> screen_;
  Capabilities capabilities_;
  Placement placement_;
  PixelPalette palette_;
  MonotonicClock clock_;
  panels::FrameTicks ticks_;
  std::vector<std::uint8_t> memory_;
  std::size_t shown_ = 0;     // Of the screen's buffers.
  std::size_t flipping_ = 0;  // Same as shown_: no flip is under way.
  std::size_t waiting_ = 0;   // Same as shown_: none waits for the flip under way.
  int shown_index_ = 0;       // The program's buffer shown or asked for last.
  std::uint32_t flips_ = 0;
  bool tells_vblanks_ = true;
  Fault fault_;
};

}  // namespace hal::linux_io
